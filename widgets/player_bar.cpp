#include "player_bar.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <limits>

namespace boomwatch {
namespace {

int toSlider(std::size_t index) {
  return static_cast<int>(
      std::min<std::size_t>(index, static_cast<std::size_t>(std::numeric_limits<int>::max())));
}

QLabel* fixedLabel(const QString& widest, Qt::Alignment alignment) {
  auto* label = new QLabel;
  label->setAlignment(alignment | Qt::AlignVCenter);
  label->setFixedWidth(label->fontMetrics().horizontalAdvance(widest) + 8);
  return label;
}

}  // namespace

PlayerBar::PlayerBar(QWidget* parent) : QWidget(parent) {
  makeActions();
  layOut();
  wire();
  setStatus(std::nullopt);
}

void PlayerBar::makeActions() {
  const auto make = [this](const QString& icon, const QString& text, const QKeySequence& key) {
    auto* action = new QAction(QIcon(icon), text, this);
    action->setShortcut(key);
    action->setToolTip(tr("%1 (%2)").arg(text, key.toString(QKeySequence::NativeText)));
    addAction(action);
    return action;
  };
  m_play = make(":/icons/play.svg", tr("Play"), Qt::Key_Space);
  m_back = make(":/icons/step_back.svg", tr("Previous frame"), Qt::Key_Comma);
  m_forward = make(":/icons/step.svg", tr("Next frame"), Qt::Key_Period);
  m_loop = make(":/icons/loop.svg", tr("Loop"), Qt::Key_L);
  m_loop->setCheckable(true);
}

void PlayerBar::layOut() {
  m_speed = new QComboBox;
  for (const double speed : {0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0}) {
    m_speed->addItem(tr("%1x").arg(locale().toString(speed)), speed);
  }
  m_speed->addItem(tr("fastest"), Player::unlimited);
  m_speed->setToolTip(
      tr("Playback speed of a recording. fastest: as fast as frames can be processed."));
  m_speed->setAccessibleName(tr("Speed"));
  m_slider = new QSlider(Qt::Horizontal);
  m_slider->setMinimumWidth(120);
  m_slider->setAccessibleName(tr("Position in the recording"));
  m_position = fixedLabel(QStringLiteral("000000 / 000000"), Qt::AlignRight);
  m_state = fixedLabel(tr("Playing") + QStringLiteral("MMM"), Qt::AlignLeft);

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  for (QAction* action : {m_back, m_play, m_forward, m_loop}) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    row->addWidget(button);
  }
  row->addWidget(m_speed);
  row->addWidget(m_slider, 1);
  row->addWidget(m_position);
  row->addWidget(m_state);
}

void PlayerBar::wire() {
  connect(m_play, &QAction::triggered, this, [this] {
    if (playing()) {
      emit pauseRequested();
    } else {
      emit playRequested();
    }
  });
  connect(m_back, &QAction::triggered, this, [this] { emit stepRequested(-1); });
  connect(m_forward, &QAction::triggered, this, [this] { emit stepRequested(1); });
  connect(m_loop, &QAction::toggled, this, &PlayerBar::loopChanged);
  connect(m_speed, &QComboBox::activated, this,
          [this] { emit speedChanged(m_speed->currentData().toDouble()); });
  connect(m_slider, &QSlider::valueChanged, this,
          [this](int value) { emit seekRequested(static_cast<std::size_t>(value)); });
}

void PlayerBar::setStatus(const std::optional<PlayerStatus>& status) {
  m_status = status;
  enable();
  const QString text = playing() ? tr("Pause") : tr("Play");
  m_play->setIcon(QIcon(playing() ? ":/icons/pause.svg" : ":/icons/play.svg"));
  m_play->setText(text);
  m_play->setToolTip(tr("%1 (%2)").arg(text, m_play->shortcut().toString()));
  m_position->setText(positionText());
  m_state->setText(stateText());
  if (!status) return;
  const QSignalBlocker loopBlocker(m_loop);
  m_loop->setChecked(status->loop);
  showSpeed(status->speed);
  if (m_slider->isSliderDown()) return;
  const QSignalBlocker sliderBlocker(m_slider);
  m_slider->setRange(0, status->count ? toSlider(std::max<std::size_t>(1, *status->count) - 1) : 0);
  m_slider->setValue(toSlider(status->position.value_or(0)));
}

void PlayerBar::enable() {
  const bool open = m_status.has_value();
  const bool recording = open && !m_status->live;
  m_play->setEnabled(open);
  m_forward->setEnabled(open && m_status->state != PlayState::Ended);
  m_back->setEnabled(recording && m_status->position.value_or(0) > 0);
  m_loop->setEnabled(recording);
  m_speed->setEnabled(recording);
  m_slider->setEnabled(recording && m_status->count.value_or(0) > 1);
}

void PlayerBar::showSpeed(double speed) {
  const int index = m_speed->findData(speed);
  if (index >= 0) m_speed->setCurrentIndex(index);
}

QString PlayerBar::stateText() const {
  if (!m_status) return {};
  switch (m_status->state) {
    case PlayState::Playing:
      return m_status->live ? tr("Live") : tr("Playing");
    case PlayState::Paused:
      return tr("Paused");
    case PlayState::Ended:
      return tr("End");
    case PlayState::Lost:
      return tr("Lost");
  }
  return {};
}

QString PlayerBar::positionText() const {
  if (!m_status || !m_status->position) return {};
  const QString frame = QString::number(*m_status->position + 1);
  return m_status->count ? tr("%1 / %2").arg(frame).arg(*m_status->count) : frame;
}

}  // namespace boomwatch
