#pragma once

#include <QDialog>

namespace boomwatch {

/// One page: what the window shows, what the program cannot know, and the keys. GUI thread.
class HelpDialog : public QDialog {
  Q_OBJECT

 public:
  explicit HelpDialog(QWidget* parent = nullptr);
};

}  // namespace boomwatch
