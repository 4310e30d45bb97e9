#include "source_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace boomwatch {
namespace {

QString prefixOf(SourceKind kind) {
  switch (kind) {
    case SourceKind::Stereo:
      return QStringLiteral("stereo:");
    case SourceKind::Cloud:
      return QStringLiteral("cloud:");
    case SourceKind::Depth:
      return QStringLiteral("depth:");
    case SourceKind::Bag:
      return QStringLiteral("bag:");
    case SourceKind::Map:
      return QStringLiteral("map:");
    case SourceKind::Camera:
      return QStringLiteral("camera:");
  }
  return {};
}

QString hintOf(SourceKind kind) {
  switch (kind) {
    case SourceKind::Stereo:
      return SourceDialog::tr("A folder with left and right pictures or videos");
    case SourceKind::Cloud:
      return SourceDialog::tr("A PCD or PLY file, or a folder of them");
    case SourceKind::Depth:
      return SourceDialog::tr("A folder with colour and depth pictures");
    case SourceKind::Bag:
      return SourceDialog::tr("A .bag, .mcap or .db3 file, or ROS 2's folder of them");
    case SourceKind::Map:
      return SourceDialog::tr("A height or depth map: an ASCII grid, or its YAML file");
    case SourceKind::Camera:
      return SourceDialog::tr("LEFT,RIGHT: device numbers or addresses, or one for both");
  }
  return {};
}

}  // namespace

SourceDialog::SourceDialog(SourceKind kind, QWidget* parent)
    : QDialog(parent),
      m_kind(new QComboBox),
      m_path(new QLineEdit),
      m_folder(new QPushButton(tr("Folder..."))),
      m_file(new QPushButton(tr("File..."))),
      m_calibration(new QLineEdit),
      m_calibrationFile(new QPushButton(tr("File..."))),
      m_buttons(new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel)) {
  setWindowTitle(tr("Open a source"));
  m_kind->addItems({tr("Stereo recording"), tr("Point clouds"), tr("Depth recording"),
                    tr("Bag (ROS, Foxglove)"), tr("Map"), tr("Camera")});
  m_kind->setCurrentIndex(static_cast<int>(kind));
  layOut();
  wire();
  adapt();
}

void SourceDialog::layOut() {
  constexpr int pathWidth = 380;
  auto* form = new QFormLayout(this);
  form->addRow(tr("&Kind"), m_kind);
  auto* place = new QHBoxLayout;
  place->addWidget(m_path, 1);
  place->addWidget(m_folder);
  place->addWidget(m_file);
  m_path->setMinimumWidth(pathWidth);
  auto* placeLabel = new QLabel(tr("&Location"));
  placeLabel->setBuddy(m_path);
  form->addRow(placeLabel, place);
  auto* calibration = new QHBoxLayout;
  calibration->addWidget(m_calibration, 1);
  calibration->addWidget(m_calibrationFile);
  m_calibration->setPlaceholderText(tr("found beside the recording"));
  auto* calibrationLabel = new QLabel(tr("C&alibration"));
  calibrationLabel->setBuddy(m_calibration);
  form->addRow(calibrationLabel, calibration);
  form->addRow(m_buttons);
}

void SourceDialog::wire() {
  connect(m_kind, &QComboBox::currentIndexChanged, this, &SourceDialog::adapt);
  connect(m_path, &QLineEdit::textChanged, this, &SourceDialog::adapt);
  connect(m_folder, &QPushButton::clicked, this, &SourceDialog::browseFolder);
  connect(m_file, &QPushButton::clicked, this, &SourceDialog::browseFile);
  connect(m_calibrationFile, &QPushButton::clicked, this, &SourceDialog::browseCalibration);
  connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

SourceKind SourceDialog::kind() const { return static_cast<SourceKind>(m_kind->currentIndex()); }

void SourceDialog::adapt() {
  const bool camera = kind() == SourceKind::Camera;
  const bool bag = kind() == SourceKind::Bag;
  const bool calibrated = camera || bag || kind() == SourceKind::Stereo;
  m_path->setPlaceholderText(hintOf(kind()));
  const bool map = kind() == SourceKind::Map;
  m_folder->setEnabled(!camera && !map);
  m_file->setEnabled(map || bag || kind() == SourceKind::Cloud);
  m_calibration->setEnabled(calibrated);
  m_calibrationFile->setEnabled(calibrated);
  m_buttons->button(QDialogButtonBox::Open)->setEnabled(!address().isEmpty());
}

QString SourceDialog::address() const {
  const QString path = m_path->text().trimmed();
  return path.isEmpty() ? QString() : prefixOf(kind()) + path;
}

QString SourceDialog::calibration() const {
  return m_calibration->isEnabled() ? m_calibration->text().trimmed() : QString();
}

void SourceDialog::browseFolder() {
  const QString chosen = QFileDialog::getExistingDirectory(this, windowTitle(), m_path->text());
  if (!chosen.isEmpty()) m_path->setText(chosen);
}

void SourceDialog::browseFile() {
  const QString files = kind() == SourceKind::Map   ? tr("Maps (*.asc *.yaml *.yml)")
                        : kind() == SourceKind::Bag ? tr("Bags (*.bag *.mcap *.db3)")
                                                    : tr("Point clouds (*.pcd *.ply)");
  const QString chosen = QFileDialog::getOpenFileName(this, windowTitle(), m_path->text(), files);
  if (!chosen.isEmpty()) m_path->setText(chosen);
}

void SourceDialog::browseCalibration() {
  const QString chosen =
      QFileDialog::getOpenFileName(this, tr("Calibration"), m_path->text(),
                                   tr("Calibrations (*.yaml *.yml *.xml *.txt);;All files (*)"));
  if (!chosen.isEmpty()) m_calibration->setText(chosen);
}

}  // namespace boomwatch
