#pragma once

#include <QString>
#include <QWidget>

class QLabel;
class QTimer;
class QToolButton;

namespace boomwatch {

/// One line under the controls, always there: what the picture is (live, a recording, paused,
/// ended), and over it, for a while or until it is dismissed, what went wrong. Never changes its
/// size; a text that is too long is cut off, and whole in the tool tip. GUI thread.
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
