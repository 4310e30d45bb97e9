#include "parameter_editor.h"
#include "parameters/parameter_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSpinBox>

namespace boomwatch {
namespace {

QString fromView(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

// Units that are words; the others are the same everywhere.
[[maybe_unused]] constexpr const char* wordUnits[] = {
    QT_TRANSLATE_NOOP("Parameters", "cells"), QT_TRANSLATE_NOOP("Parameters", "points"),
    QT_TRANSLATE_NOOP("Parameters", "frames"), QT_TRANSLATE_NOOP("Parameters", "pixels")};

QString unitSuffix(const ParameterInfo& info) {
  return *info.unit ? QStringLiteral(" ") + parameterText(info.unit) : QString();
}

/// Shows 0.04 as "0.04", not as "0.040000".
class NumberSpin : public QDoubleSpinBox {
 public:
  explicit NumberSpin(const ParameterInfo& info) {
    QLocale plain = locale();
    plain.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
    setLocale(plain);
    setDecimals(6);
    setRange(info.minimum, info.maximum);
    setSingleStep(info.step);
    setSuffix(unitSuffix(info));
    setKeyboardTracking(false);
  }
  QString textFromValue(double value) const override { return locale().toString(value, 'g', 10); }
};

class NumberEditor : public ParameterEditor {
 public:
  NumberEditor(const ParameterInfo& info, QWidget* parent)
      : ParameterEditor(parent), m_spin(new NumberSpin(info)) {
    adopt(m_spin, info);
    connect(m_spin, &QDoubleSpinBox::valueChanged, this, &ParameterEditor::edited);
  }
  ParameterValue value() const override { return m_spin->value(); }
  void setValue(const ParameterValue& value) override {
    const QSignalBlocker blocker(m_spin);
    m_spin->setValue(std::get<double>(value));
  }

 private:
  NumberSpin* m_spin;
};

class WholeNumberEditor : public ParameterEditor {
 public:
  WholeNumberEditor(const ParameterInfo& info, QWidget* parent)
      : ParameterEditor(parent), m_spin(new QSpinBox) {
    m_spin->setRange(static_cast<int>(info.minimum), static_cast<int>(info.maximum));
    m_spin->setSingleStep(static_cast<int>(info.step));
    m_spin->setSuffix(unitSuffix(info));
    m_spin->setKeyboardTracking(false);
    adopt(m_spin, info);
    connect(m_spin, &QSpinBox::valueChanged, this, &ParameterEditor::edited);
  }
  ParameterValue value() const override { return m_spin->value(); }
  void setValue(const ParameterValue& value) override {
    const QSignalBlocker blocker(m_spin);
    m_spin->setValue(std::get<int>(value));
  }

 private:
  QSpinBox* m_spin;
};

class FlagEditor : public ParameterEditor {
 public:
  FlagEditor(const ParameterInfo& info, QWidget* parent)
      : ParameterEditor(parent), m_box(new QCheckBox) {
    adopt(m_box, info);
    connect(m_box, &QCheckBox::toggled, this, &ParameterEditor::edited);
  }
  ParameterValue value() const override { return m_box->isChecked(); }
  void setValue(const ParameterValue& value) override {
    const QSignalBlocker blocker(m_box);
    m_box->setChecked(std::get<bool>(value));
  }

 private:
  QCheckBox* m_box;
};

class ChoiceEditor : public ParameterEditor {
 public:
  ChoiceEditor(const ParameterInfo& info, QWidget* parent)
      : ParameterEditor(parent), m_box(new QComboBox) {
    // Spelled as in presets, on the command line and in the tooltips.
    for (const std::string_view name : info.choices) m_box->addItem(fromView(name));
    adopt(m_box, info);
    connect(m_box, &QComboBox::currentIndexChanged, this, &ParameterEditor::edited);
  }
  ParameterValue value() const override { return Choice{m_box->currentIndex()}; }
  void setValue(const ParameterValue& value) override {
    const QSignalBlocker blocker(m_box);
    m_box->setCurrentIndex(std::get<Choice>(value).index);
  }

 private:
  QComboBox* m_box;
};

class OptionalEditor : public ParameterEditor {
 public:
  OptionalEditor(const ParameterInfo& info, QWidget* parent)
      : ParameterEditor(parent), m_on(new QCheckBox), m_spin(new NumberSpin(info)) {
    adopt(m_on, info);
    adopt(m_spin, info);
    m_spin->setEnabled(false);
    connect(m_on, &QCheckBox::toggled, m_spin, &QWidget::setEnabled);
    connect(m_on, &QCheckBox::toggled, this, &ParameterEditor::edited);
    connect(m_spin, &QDoubleSpinBox::valueChanged, this, &ParameterEditor::edited);
  }
  ParameterValue value() const override {
    return m_on->isChecked() ? std::optional(m_spin->value()) : std::nullopt;
  }
  void setValue(const ParameterValue& value) override {
    const auto& number = std::get<std::optional<double>>(value);
    const QSignalBlocker onBlocker(m_on);
    const QSignalBlocker spinBlocker(m_spin);
    m_on->setChecked(number.has_value());
    m_spin->setEnabled(number.has_value());
    if (number) m_spin->setValue(*number);
  }

 private:
  QCheckBox* m_on;
  NumberSpin* m_spin;
};

}  // namespace

ParameterEditor* ParameterEditor::make(const ParameterInfo& info, QWidget* parent) {
  const ParameterValue kind = info.get(Parameters{});
  if (std::holds_alternative<bool>(kind)) return new FlagEditor(info, parent);
  if (std::holds_alternative<int>(kind)) return new WholeNumberEditor(info, parent);
  if (std::holds_alternative<double>(kind)) return new NumberEditor(info, parent);
  if (std::holds_alternative<Choice>(kind)) return new ChoiceEditor(info, parent);
  return new OptionalEditor(info, parent);
}

void ParameterEditor::adopt(QWidget* control, const ParameterInfo& info) {
  if (!layout()) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
  }
  const bool grows = !qobject_cast<QCheckBox*>(control);
  static_cast<QHBoxLayout*>(layout())->addWidget(control, grows ? 1 : 0);
  control->setObjectName(fromView(info.key));
  control->setAccessibleName(parameterText(info.label));
  control->setFocusPolicy(Qt::StrongFocus);
  control->installEventFilter(this);
  if (!focusProxy()) setFocusProxy(control);
}

bool ParameterEditor::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::Wheel) return QWidget::eventFilter(watched, event);
  // Not for the control: its ignored event goes up to the scroll area.
  event->ignore();
  return true;
}

QString parameterText(const char* text) { return QCoreApplication::translate("Parameters", text); }

QString parameterHelp(const ParameterInfo& info) {
  QString range = fromView(rangeText(info));
  const ParameterValue kind = info.get(Parameters{});
  if (!std::holds_alternative<bool>(kind) && !std::holds_alternative<Choice>(kind)) {
    const QLocale locale;
    range =
        ParameterEditor::tr("%1 to %2%3")
            .arg(locale.toString(info.minimum), locale.toString(info.maximum), unitSuffix(info));
  }
  if (std::holds_alternative<std::optional<double>>(kind)) {
    range = ParameterEditor::tr("off, or %1").arg(range);
  }
  // As rich text, which a tooltip wraps; plain text would run off the screen.
  return QStringLiteral("<p>%1</p><p>%2: %3</p>")
      .arg(parameterText(info.tooltip).toHtmlEscaped(), fromView(info.key), range.toHtmlEscaped());
}

}  // namespace boomwatch
