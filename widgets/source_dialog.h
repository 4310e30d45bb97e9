#pragma once

#include <QDialog>
#include <QString>

class QComboBox;
class QDialogButtonBox;
class QLineEdit;
class QPushButton;

namespace boomwatch {

enum class SourceKind { Stereo, Cloud, Depth, Bag, Map, Camera };

/// Asks for a source: its kind, where it is, and its calibration. GUI thread.
class SourceDialog : public QDialog {
  Q_OBJECT

 public:
  explicit SourceDialog(SourceKind kind, QWidget* parent = nullptr);

  /// "stereo:PATH", "camera:0,1", ...; empty while nothing is given.
  QString address() const;
  /// Empty: it lies beside the recording.
  QString calibration() const;

 private:
  void layOut();
  void wire();
  void adapt();
  void browseFolder();
  void browseFile();
  void browseCalibration();
  SourceKind kind() const;

  QComboBox* m_kind;
  QLineEdit* m_path;
  QPushButton* m_folder;
  QPushButton* m_file;
  QLineEdit* m_calibration;
  QPushButton* m_calibrationFile;
  QDialogButtonBox* m_buttons;
};

}  // namespace boomwatch
