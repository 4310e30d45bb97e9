#pragma once

#include <QWidget>
#include <optional>

#include "sources/player.h"

class QAction;
class QComboBox;
class QLabel;
class QSlider;

namespace boomwatch {

/// Play, step, loop, speed and position of a source. Shows what it is told by setStatus, asks by
/// signals, and decides nothing. Its size does not depend on what it shows. GUI thread.
class PlayerBar : public QWidget {
  Q_OBJECT

 public:
  explicit PlayerBar(QWidget* parent = nullptr);

  /// Absent: nothing is open. Emits nothing.
  void setStatus(const std::optional<PlayerStatus>& status);

  /// "Playing", "Paused", "End", "Live", "Lost", or "" when nothing is open.
  QString stateText() const;
  /// "13 / 400", counted from 1.
  QString positionText() const;

 signals:
  void playRequested();
  void pauseRequested();
  void stepRequested(int direction);
  void seekRequested(std::size_t index);
  void loopChanged(bool loop);
  void speedChanged(double speed);

 private:
  void makeActions();
  void layOut();
  void wire();
  void enable();
  void showSpeed(double speed);
  bool playing() const { return m_status && m_status->state == PlayState::Playing; }

  std::optional<PlayerStatus> m_status;
  QAction* m_play = nullptr;
  QAction* m_back = nullptr;
  QAction* m_forward = nullptr;
  QAction* m_loop = nullptr;
  QComboBox* m_speed = nullptr;
  QSlider* m_slider = nullptr;
  QLabel* m_position = nullptr;
  QLabel* m_state = nullptr;
};

}  // namespace boomwatch
