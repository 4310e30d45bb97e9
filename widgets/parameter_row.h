#pragma once

#include <QWidget>

#include "parameters/parameter_table.h"

class QLabel;
class QToolButton;

namespace boomwatch {

class ParameterEditor;

/// One line of the parameter dock: label, editor, reset, and below them what is wrong, if anything
/// is. GUI thread.
class ParameterRow : public QWidget {
  Q_OBJECT

 public:
  explicit ParameterRow(const ParameterInfo& info, QWidget* parent = nullptr);

  const ParameterInfo& info() const { return m_info; }
  /// Shows the parameter's value; emits nothing.
  void showValue(const Parameters& parameters);
  /// Writes the editor's value.
  void write(Parameters& parameters) const;
  /// Empty: nothing is wrong.
  void setMessage(const QString& text);
  QString message() const;
  /// Whether key, label, group or explanation contain `text`; always when it is empty.
  bool matches(const QString& text) const;

 signals:
  void edited();
  void resetRequested();

 private:
  const ParameterInfo& m_info;
  ParameterEditor* m_editor;
  QToolButton* m_reset;
  QLabel* m_message;
};

}  // namespace boomwatch
