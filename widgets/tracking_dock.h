#pragma once

#include <QDockWidget>
#include <QStringList>

#include "display.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace boomwatch {

/// The choice of tracker, its learning, its box, the files of its model, and its state. Emits
/// requests only; the worker carries them out. GUI thread.
class TrackingDock : public QDockWidget {
  Q_OBJECT

 public:
  explicit TrackingDock(QWidget* parent = nullptr);

  /// Shows the current settings; emits no signal.
  void setParameters(const Parameters& parameters);
  void setDisplay(const DisplayPtr& display);

  /// The lines below the buttons.
  QString stateText() const;
  QString learningText() const;
  QString modelText() const;

 signals:
  void trackerChosen(boomwatch::TrackerKind kind);
  void learningChosen(bool on);
  void boxWanted();
  void beginAgainWanted();
  void forgetWanted();
  void loadWanted(const QStringList& files);
  /// As loadWanted, but merged with the current model.
  void mergeWanted(const QStringList& files);
  void saveWanted(const QString& file);

 private:
  QWidget* makeChoice();
  void showOtherTrackers();
  QWidget* makeButtons();
  QWidget* makeState();
  void askWhatToLoad(bool merge);
  void askWhereToSave();

  TrackerKind m_kind = TrackerKind::Tld;  ///< in force or about to be
  QComboBox* m_tracker = nullptr;
  QCheckBox* m_learn = nullptr;
  QPushButton* m_again = nullptr;
  QPushButton* m_forget = nullptr;
  QPushButton* m_load = nullptr;
  QPushButton* m_merge = nullptr;
  QPushButton* m_save = nullptr;
  QLabel* m_state = nullptr;
  QLabel* m_learning = nullptr;
  QLabel* m_model = nullptr;
  QLabel* m_patches = nullptr;
};

}  // namespace boomwatch
