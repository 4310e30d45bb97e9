#include "panes.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QVBoxLayout>

namespace boomwatch {
namespace {

QString text(const char* source) { return QCoreApplication::translate("Panes", source); }

QDockWidget* makeDock(const char* name, const QString& title, QWidget* content,
                      QMainWindow* window) {
  auto* dock = new QDockWidget(title, window);
  dock->setObjectName(QLatin1String(name));
  dock->setWidget(content);
  content->setAccessibleName(title);
  return dock;
}

QLabel* makeCaption() {
  auto* caption = new QLabel;
  QFont font = caption->font();
  font.setBold(true);
  caption->setFont(font);
  caption->setAlignment(Qt::AlignCenter);
  caption->setMinimumHeight(2 * caption->fontMetrics().height());
  caption->setWordWrap(true);
  caption->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  return caption;
}

/// The bar stands where it always stands: no title, nothing to grab or close.
QDockWidget* makeBarDock(const Panes& panes, QMainWindow* window) {
  auto* column = new QWidget;
  auto* layout = new QVBoxLayout(column);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(panes.barCaption);
  layout->addWidget(panes.bar, 1);
  QDockWidget* dock =
      makeDock("distance", text(QT_TRANSLATE_NOOP("Panes", "Distance")), column, window);
  dock->setFeatures(QDockWidget::NoDockWidgetFeatures);
  dock->setAllowedAreas(Qt::LeftDockWidgetArea);
  dock->setTitleBarWidget(new QWidget);
  return dock;
}

}  // namespace

Panes Panes::make(QMainWindow* window) {
  Panes panes;
  panes.bar = new DistanceBar;
  panes.barCaption = makeCaption();
  panes.cloud = new PointCloudView;
  panes.camera = new CameraView;
  panes.probability = new MapView(MapKind::Probability);
  panes.environment = new MapView(MapKind::Environment);
  panes.history = new DistancePlot;
  panes.parameters = new ParameterDock(window);
  panes.tracking = new TrackingDock(window);
  panes.player = new PlayerBar;
  panes.state = new StateLine;
  panes.status = new StatusStrip;

  window->setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  window->setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  window->setDockNestingEnabled(true);
  window->setCentralWidget(panes.cloud);
  window->setStatusBar(panes.status);
  window->addDockWidget(Qt::LeftDockWidgetArea, makeBarDock(panes, window));
  panes.docks = {
      makeDock("camera", text(QT_TRANSLATE_NOOP("Panes", "Camera")), panes.camera, window),
      makeDock("probability", text(QT_TRANSLATE_NOOP("Panes", "Probability map")),
               panes.probability, window),
      makeDock("environment", text(QT_TRANSLATE_NOOP("Panes", "Environment model")),
               panes.environment, window),
      panes.tracking,
      panes.parameters,
      makeDock("history", text(QT_TRANSLATE_NOOP("Panes", "Distance against time")), panes.history,
               window)};
  panes.arrange(window);
  return panes;
}

void Panes::arrange(QMainWindow* window) const {
  for (QDockWidget* dock : docks) {
    dock->setFloating(false);
    const bool right = dock == parameters || dock == tracking;
    window->addDockWidget(right ? Qt::RightDockWidgetArea : Qt::BottomDockWidgetArea, dock);
    dock->show();
  }
  QDockWidget* below = docks.constLast();
  window->splitDockWidget(docks[0], below, Qt::Vertical);
  window->splitDockWidget(docks[0], docks[1], Qt::Horizontal);
  window->splitDockWidget(docks[1], docks[2], Qt::Horizontal);
  window->resizeDocks({docks[0], docks[1], docks[2]}, {1, 1, 1}, Qt::Horizontal);
  window->resizeDocks({docks[0], below},
                      {window->height() / 3, below->widget()->sizeHint().height()}, Qt::Vertical);
  window->resizeDocks({tracking, parameters}, {tracking->sizeHint().height(), window->height()},
                      Qt::Vertical);
}

void Panes::setDisplay(const DisplayPtr& display) const {
  // The bar first: it is what the person waits for.
  bar->setDisplay(display);
  status->showResult(*display->result);
  cloud->setDisplay(display);
  camera->setDisplay(display);
  probability->setDisplay(display);
  environment->setDisplay(display);
  tracking->setDisplay(display);
  history->setDisplay(display);
}

}  // namespace boomwatch
