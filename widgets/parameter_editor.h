#pragma once

#include <QString>
#include <QWidget>

#include "parameters/parameter_table.h"

namespace boomwatch {

/// Edits one parameter; which controls it has depends on the kind of value: a number with its unit,
/// a check box, a choice, or a check box with a number for "off or a value". GUI thread.
///
/// A typed number counts when Enter is pressed or the field is left; arrows count at once. The
/// wheel changes nothing, so that the dock can be scrolled without harm.
class ParameterEditor : public QWidget {
  Q_OBJECT

 public:
  static ParameterEditor* make(const ParameterInfo& info, QWidget* parent = nullptr);

  virtual ParameterValue value() const = 0;
  /// Emits nothing. The alternative must be the one of the parameter.
  virtual void setValue(const ParameterValue& value) = 0;

 signals:
  /// A person changed the value.
  void edited();

 protected:
  explicit ParameterEditor(QWidget* parent) : QWidget(parent) {}
  /// Puts `control` into the row, nameable and safe from the wheel.
  void adopt(QWidget* control, const ParameterInfo& info);
  bool eventFilter(QObject* watched, QEvent* event) override;
};

/// Group, label or tooltip of the table, translated.
QString parameterText(const char* text);
/// What it is, its key, and what it may be: "0.001 to 1 m".
QString parameterHelp(const ParameterInfo& info);

}  // namespace boomwatch
