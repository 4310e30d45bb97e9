#pragma once

#include <QDockWidget>
#include <vector>

#include "parameters/parameters.h"

class QGroupBox;
class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace boomwatch {

class ParameterRow;

/// Every parameter of the table, with search, reset and presets; made by a loop over the table.
///
/// What a person changes takes effect at once (parametersChanged), unless the values contradict
/// each other: then they stay as typed, the fields in question say why, and nothing is sent until
/// they agree again. GUI thread.
class ParameterDock : public QDockWidget {
  Q_OBJECT

 public:
  explicit ParameterDock(QWidget* parent = nullptr);

  /// As they stand in the fields, contradictions and all.
  const Parameters& parameters() const { return m_parameters; }
  /// Shows them; emits nothing.
  void setParameters(const Parameters& parameters);
  /// As if a person had typed them.
  void changeParameters(const Parameters& parameters);

  /// Both say in the dock what went wrong, and return false then.
  bool loadPresetFile(const QString& file);
  bool savePresetFile(const QString& file);

  ParameterRow* row(std::string_view key) const;
  /// What stands at the top of the dock; empty when all is well.
  QString message() const;

 public slots:
  void resetAll();
  void search(const QString& text);

 signals:
  /// Never contradictory.
  void parametersChanged(const boomwatch::Parameters& parameters);

 private:
  struct Group {
    QGroupBox* box = nullptr;
    std::vector<ParameterRow*> rows;
  };

  QWidget* makeHeader();
  QWidget* makeRows();
  Group& groupOf(const char* name, QVBoxLayout* column);
  void addRow(Group& group, ParameterRow* row);
  void askForPreset();
  void askWhereToSave();
  void showAll();
  void apply();
  /// False when the values contradict each other.
  bool check();
  void setMessage(const QString& text);

  Parameters m_parameters;
  std::vector<Group> m_groups;
  QLineEdit* m_search = nullptr;
  QLabel* m_message = nullptr;
};

}  // namespace boomwatch

Q_DECLARE_METATYPE(boomwatch::Parameters)
