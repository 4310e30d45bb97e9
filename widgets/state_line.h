#pragma once

#include <QString>
#include <QWidget>

class QLabel;
class QTimer;
class QToolButton;

namespace boomwatch {

/// One line under the controls. It shows the state of the source (live, a recording, paused,
/// ended). A notice covers the state for some seconds, a fault until the person dismisses it. The
/// size is fixed: a longer text is elided, and the tool tip shows it whole. GUI thread.
class StateLine : public QWidget {
  Q_OBJECT

 public:
  explicit StateLine(QWidget* parent = nullptr);

  void setState(const QString& text);
  /// Stands until it is dismissed.
  void showFault(const QString& text);
  /// Stands for a few seconds.
  void showNotice(const QString& text);
  void dismiss();

  /// What can be read now.
  QString text() const { return m_notice.isEmpty() ? m_state : m_notice; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void setNotice(const QString& text);
  void refresh();

  QString m_state;
  QString m_notice;
  QLabel* m_label;
  QToolButton* m_close;
  QTimer* m_timer;
};

}  // namespace boomwatch
