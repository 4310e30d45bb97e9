#include "tracking_dock.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QLabel>
#include <QPixmap>
#include <QPushButton>
#include <QVBoxLayout>

#include "patch_strip.h"
#include "save_name.h"
#include "tool_texts.h"

namespace boomwatch {
namespace {

/// The entry for the trackers that are seldom the best choice: cmt and klt.
constexpr int otherTrackers = -1;

QString modelFilter() { return TrackingDock::tr("Tool models (*.tool);;All files (*)"); }

/// A label of fixed height, so that the dock does not move when its text changes.
QLabel* makeLines(int lines) {
  auto* label = new QLabel;
  label->setWordWrap(true);
  label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  label->setFixedHeight(lines * label->fontMetrics().lineSpacing() + 2);
  return label;
}

void setLine(QLabel* label, const QString& text) {
  label->setText(text);
  label->setToolTip(text);
}

}  // namespace

TrackingDock::TrackingDock(QWidget* parent) : QDockWidget(tr("Tracking"), parent) {
  setObjectName(QStringLiteral("tracking"));
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(6, 6, 6, 6);
  column->addWidget(makeChoice());
  column->addWidget(makeButtons());
  column->addWidget(makeState());
  column->addStretch(1);
  setWidget(content);
  setParameters({});
  setDisplay(nullptr);
}

QWidget* TrackingDock::makeChoice() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  m_tracker = new QComboBox;
  m_tracker->setAccessibleName(tr("Tracker"));
  m_tracker->setToolTip(
      tr("Method that tracks the tool. A new tracker starts where the old one saw the tool."));
  m_tracker->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_tracker->setMinimumContentsLength(12);
  for (const TrackerKind kind : {TrackerKind::Tld, TrackerKind::Csrt, TrackerKind::Manual}) {
    m_tracker->addItem(trackerText(kind), static_cast<int>(kind));
  }
  m_tracker->addItem(tr("Other trackers"), otherTrackers);
  m_learn = new QCheckBox(tr("Learn"));
  m_learn->setToolTip(tr("tld: learn new views of the tool while tracking."));
  layout->addWidget(m_tracker, 1);
  layout->addWidget(m_learn);
  connect(m_tracker, &QComboBox::activated, this, [this] {
    const int chosen = m_tracker->currentData().toInt();
    if (chosen != otherTrackers) {
      emit trackerChosen(static_cast<TrackerKind>(chosen));
    } else {
      showOtherTrackers();
      if (m_tracker->isVisible()) m_tracker->showPopup();
    }
  });
  connect(m_learn, &QCheckBox::clicked, this, &TrackingDock::learningChosen);
  return row;
}

/// Lists them in place of the entry that leads to them. The choice stays as it was.
void TrackingDock::showOtherTrackers() {
  m_tracker->removeItem(m_tracker->findData(otherTrackers));
  for (const TrackerKind kind : {TrackerKind::Cmt, TrackerKind::Klt}) {
    m_tracker->addItem(trackerText(kind), static_cast<int>(kind));
  }
  m_tracker->setCurrentIndex(m_tracker->findData(static_cast<int>(m_kind)));
}

QWidget* TrackingDock::makeButtons() {
  auto* buttons = new QWidget;
  auto* grid = new QGridLayout(buttons);
  grid->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](int row, int column, const QString& text, const QString& help) {
    auto* button = new QPushButton(text);
    button->setToolTip(help);
    grid->addWidget(button, row, column);
    return button;
  };
  QPushButton* draw = add(0, 0, tr("Draw box"),
                          tr("Start a box in the camera view: the arrow keys size it, Enter starts "
                             "tracking, Escape cancels. Or drag a box with the mouse."));
  m_again = add(
      0, 1, tr("Restart"),
      tr("Restart the tracker where it last saw the tool, without the views learnt meanwhile."));
  m_forget = add(0, 2, tr("Remove"), tr("Remove the tool and stop tracking."));
  m_load = add(1, 0, tr("Load..."),
               tr("Find the tool with a saved model. Several files are merged. Only for tld."));
  m_merge = add(1, 1, tr("Merge..."), tr("Merge saved models into the current one."));
  m_save = add(1, 2, tr("Save..."), tr("Save the current model."));
  connect(draw, &QPushButton::clicked, this, &TrackingDock::boxWanted);
  connect(m_again, &QPushButton::clicked, this, &TrackingDock::beginAgainWanted);
  connect(m_forget, &QPushButton::clicked, this, &TrackingDock::forgetWanted);
  connect(m_load, &QPushButton::clicked, this, [this] { askWhatToLoad(false); });
  connect(m_merge, &QPushButton::clicked, this, [this] { askWhatToLoad(true); });
  connect(m_save, &QPushButton::clicked, this, &TrackingDock::askWhereToSave);
  return buttons;
}

QWidget* TrackingDock::makeState() {
  auto* state = new QWidget;
  auto* column = new QVBoxLayout(state);
  column->setContentsMargins(0, 0, 0, 0);
  m_state = makeLines(3);
  m_learning = makeLines(2);
  m_model = makeLines(1);
  m_patches = new QLabel;
  m_patches->setFixedHeight(2 * patchSide + 2);
  m_patches->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  m_patches->setAccessibleName(tr("Learnt views"));
  m_patches->setToolTip(tr("The latest learnt views: above of the tool, below of the background."));
  for (QLabel* label : {m_state, m_learning, m_model, m_patches}) column->addWidget(label);
  return state;
}

void TrackingDock::setParameters(const Parameters& parameters) {
  const TrackingParameters& tracking = parameters.tracking;
  m_kind = tracking.tracker;
  const int index = m_tracker->findData(static_cast<int>(m_kind));
  index < 0 ? showOtherTrackers() : m_tracker->setCurrentIndex(index);
  m_learn->setChecked(tracking.learn);
  const bool learns = tracking.tracker == TrackerKind::Tld;
  m_learn->setEnabled(learns);
  m_load->setEnabled(learns);
}

void TrackingDock::setDisplay(const DisplayPtr& display) {
  const bool any = display && display->result;
  const ToolTrack none;
  const ToolTrack& tool = any ? display->result->tool : none;
  const TrackingParameters tracking =
      any ? display->result->parameters.tracking : TrackingParameters{};
  setLine(m_state, toolSentence(tool, tracking));
  setLine(m_learning, tool.running() ? learningSentence(tool.learning) : QString());
  setLine(m_model, tool.model ? boomwatch::modelText(*tool.model) : QString());
  m_patches->setPixmap(any ? QPixmap::fromImage(display->patches) : QPixmap());
  m_again->setEnabled(tool.running());
  m_forget->setEnabled(tool.running() || tool.pixel);
  m_merge->setEnabled(tool.model != nullptr);
  m_save->setEnabled(tool.model != nullptr);
}

QString TrackingDock::stateText() const { return m_state->text(); }
QString TrackingDock::learningText() const { return m_learning->text(); }
QString TrackingDock::modelText() const { return m_model->text(); }

void TrackingDock::askWhatToLoad(bool merge) {
  const QStringList files = QFileDialog::getOpenFileNames(
      this, merge ? tr("Merge tool models") : tr("Load a tool model"), {}, modelFilter());
  if (files.isEmpty()) return;
  if (merge) {
    emit mergeWanted(files);
  } else {
    emit loadWanted(files);
  }
}

void TrackingDock::askWhereToSave() {
  const QString suffix = QStringLiteral("tool");
  const QString file = askSaveName(this, tr("Save the tool model"),
                                   QStringLiteral("boomwatch.") + suffix, modelFilter(), suffix);
  if (!file.isEmpty()) emit saveWanted(file);
}

}  // namespace boomwatch
