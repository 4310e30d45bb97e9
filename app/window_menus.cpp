#include "window_menus.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>

#include "display.h"
#include "source_dialog.h"

namespace boomwatch {
namespace {

class Menus {
  Q_DECLARE_TR_FUNCTIONS(Menus)
};

QAction* makeAction(QMainWindow* window, const QString& text, const QKeySequence& key = {}) {
  auto* action = new QAction(text, window);
  action->setShortcut(key);
  window->addAction(action);
  return action;
}

QAction* addTo(QActionGroup* group, QMenu* menu, const QString& text, const QVariant& data) {
  QAction* action = menu->addAction(text);
  action->setData(data);
  group->addAction(action);
  return action;
}

/// One of several, the first chosen.
QActionGroup* addChoice(QMenu* parent, const QString& title, const QStringList& names) {
  QMenu* menu = parent->addMenu(title);
  auto* group = new QActionGroup(menu);
  for (int i = 0; i < names.size(); ++i) {
    QAction* action = addTo(group, menu, names[i], i);
    action->setCheckable(true);
    action->setChecked(i == 0);
  }
  return group;
}

void fillSourceMenu(WindowMenus& menus, QMainWindow* window) {
  menus.source = new QMenu(Menus::tr("&Source"), window);
  menus.kinds = new QActionGroup(window);
  menus.kinds->setExclusive(false);
  const auto kind = [&](const QString& text, SourceKind value) {
    return addTo(menus.kinds, menus.source, text, static_cast<int>(value));
  };
  QAction* stereo = kind(Menus::tr("&Stereo recording..."), SourceKind::Stereo);
  stereo->setShortcut(QKeySequence::Open);
  window->addAction(stereo);
  kind(Menus::tr("&Point clouds..."), SourceKind::Cloud);
  kind(Menus::tr("&Depth recording..."), SourceKind::Depth);
  kind(Menus::tr("&Bag..."), SourceKind::Bag);
  kind(Menus::tr("&Map..."), SourceKind::Map);
  kind(Menus::tr("&Camera..."), SourceKind::Camera);
  menus.source->addSeparator();
  menus.demos = new QActionGroup(window);
  menus.demos->setExclusive(false);
  const auto demo = [&](const QString& text, const char* address) {
    addTo(menus.demos, menus.source, text, QString::fromLatin1(address));
  };
  demo(Menus::tr("Demo: forestry y&ard"), "demo:yard");
  demo(Menus::tr("Demo: slanted &floor"), "demo:floor");
  demo(Menus::tr("Demo: four c&ylinders"), "demo:cylinders");
  demo(Menus::tr("Demo: &wall"), "demo:wall");
  menus.source->addSeparator();
  menus.quit = makeAction(window, Menus::tr("&Quit"), QKeySequence::Quit);
  menus.source->addAction(menus.quit);
}

void fillViewMenu(WindowMenus& menus, QMainWindow* window, const QList<QDockWidget*>& docks) {
  menus.view = new QMenu(Menus::tr("&View"), window);
  for (const QDockWidget* dock : docks) menus.view->addAction(dock->toggleViewAction());
  menus.view->addSeparator();
  menus.cloudColours = addChoice(menus.view, Menus::tr("&Cloud coloured by"),
                                 {Menus::tr("Depth"), Menus::tr("Height"), Menus::tr("Picture")});
  menus.mapColours = addChoice(menus.view, Menus::tr("&Maps coloured in"),
                               {Menus::tr("Grey"), Menus::tr("Colour")});
  menus.view->addSeparator();
  menus.resetView = makeAction(window, Menus::tr("&Reset 3-D view"), Qt::Key_R);
  menus.fitMaps = makeAction(window, Menus::tr("&Fit the maps"), Qt::Key_F);
  menus.lightTheme = makeAction(window, Menus::tr("&Light theme"));
  menus.lightTheme->setCheckable(true);
  menus.resetLayout = makeAction(window, Menus::tr("Reset la&yout"));
  menus.view->addActions({menus.resetView, menus.fitMaps, menus.lightTheme, menus.resetLayout});
}

}  // namespace

WindowMenus WindowMenus::make(QMainWindow* window, const QList<QDockWidget*>& docks) {
  WindowMenus menus;
  fillSourceMenu(menus, window);
  fillViewMenu(menus, window, docks);
  menus.snapshot = makeAction(window, Menus::tr("S&napshot"), Qt::CTRL | Qt::Key_S);
  menus.snapshot->setToolTip(Menus::tr("Save a picture of the whole window (Ctrl+S)"));
  menus.help = makeAction(window, Menus::tr("&Help"), QKeySequence::HelpContents);
  return menus;
}

}  // namespace boomwatch
