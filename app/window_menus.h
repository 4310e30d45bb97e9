#pragma once

#include <QActionGroup>
#include <QList>
#include <QMenu>

class QDockWidget;
class QMainWindow;

namespace boomwatch {

/// The window's menus and their actions; they do nothing until the window wires them.
struct WindowMenus {
  QMenu* source = nullptr;
  QActionGroup* kinds = nullptr;  ///< data: SourceKind as int; opens the dialog
  QActionGroup* demos = nullptr;  ///< data: the address
  QAction* quit = nullptr;

  QMenu* view = nullptr;
  QActionGroup* cloudColours = nullptr;  ///< data: CloudColouring as int
  QActionGroup* mapColours = nullptr;    ///< data: MapColouring as int
  QAction* lightTheme = nullptr;
  QAction* resetView = nullptr;
  QAction* fitMaps = nullptr;
  QAction* resetLayout = nullptr;

  QAction* snapshot = nullptr;
  QAction* help = nullptr;

  /// All shortcuts work in `window`.
  static WindowMenus make(QMainWindow* window, const QList<QDockWidget*>& docks);
};

}  // namespace boomwatch
