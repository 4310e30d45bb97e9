#include "parameter_row.h"

#include <QGridLayout>
#include <QLabel>
#include <QToolButton>

#include "parameter_editor.h"

namespace boomwatch {

ParameterRow::ParameterRow(const ParameterInfo& info, QWidget* parent)
    : QWidget(parent),
      m_info(info),
      m_editor(ParameterEditor::make(info)),
      m_reset(new QToolButton),
      m_message(new QLabel) {
  constexpr int editorWidth = 132;
  auto* label = new QLabel(parameterText(info.label));
  label->setToolTip(parameterHelp(info));
  label->setBuddy(m_editor);
  m_editor->setToolTip(parameterHelp(info));
  m_editor->setFixedWidth(editorWidth);
  m_reset->setIcon(QIcon(QStringLiteral(":/icons/reset.svg")));
  m_reset->setAutoRaise(true);
  m_reset->setToolTip(tr("Reset to the default"));
  m_reset->setAccessibleName(tr("Reset %1").arg(label->text()));
  QSizePolicy keep = m_reset->sizePolicy();
  keep.setRetainSizeWhenHidden(true);
  m_reset->setSizePolicy(keep);
  m_message->setWordWrap(true);
  m_message->hide();

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(label, 0, 0);
  grid->addWidget(m_editor, 0, 1);
  grid->addWidget(m_reset, 0, 2);
  grid->addWidget(m_message, 1, 0, 1, 3);
  grid->setColumnStretch(0, 1);
  connect(m_editor, &ParameterEditor::edited, this, &ParameterRow::edited);
  connect(m_reset, &QToolButton::clicked, this, &ParameterRow::resetRequested);
}

void ParameterRow::showValue(const Parameters& parameters) {
  const ParameterValue value = m_info.get(parameters);
  m_editor->setValue(value);
  m_reset->setVisible(value != m_info.get(Parameters{}));
}

void ParameterRow::write(Parameters& parameters) const {
  m_info.set(parameters, m_editor->value());
  m_reset->setVisible(m_info.get(parameters) != m_info.get(Parameters{}));
}

void ParameterRow::setMessage(const QString& text) {
  m_message->setText(text.isEmpty() ? QString() : QStringLiteral("\u26A0 ") + text);
  m_message->setVisible(!text.isEmpty());
}

QString ParameterRow::message() const { return m_message->text(); }

bool ParameterRow::matches(const QString& text) const {
  const auto contains = [&](const QString& where) {
    return where.contains(text, Qt::CaseInsensitive);
  };
  return contains(
             QString::fromUtf8(m_info.key.data(), static_cast<qsizetype>(m_info.key.size()))) ||
         contains(parameterText(m_info.label)) || contains(parameterText(m_info.group)) ||
         contains(parameterText(m_info.tooltip));
}

}  // namespace boomwatch
