#pragma once

#include <QList>

#include "camera_view.h"
#include "display.h"
#include "distance_bar.h"
#include "distance_plot.h"
#include "map_view.h"
#include "parameter_dock.h"
#include "player_bar.h"
#include "point_cloud_view.h"
#include "state_line.h"
#include "status_strip.h"
#include "tracking_dock.h"

class QDockWidget;
class QLabel;
class QMainWindow;

namespace boomwatch {

/// What the window is made of, and where it stands. The window owns them all.
struct Panes {
  DistanceBar* bar = nullptr;
  QLabel* barCaption = nullptr;  ///< over the bar: whether it is now
  PointCloudView* cloud = nullptr;
  CameraView* camera = nullptr;
  MapView* probability = nullptr;
  MapView* environment = nullptr;
  DistancePlot* history = nullptr;
  ParameterDock* parameters = nullptr;
  TrackingDock* tracking = nullptr;
  PlayerBar* player = nullptr;
  StateLine* state = nullptr;
  StatusStrip* status = nullptr;
  QList<QDockWidget*> docks;  ///< those that can be moved and hidden

  /// Makes all of them and puts docks, centre and foot into `window`.
  static Panes make(QMainWindow* window);
  /// Puts the docks where they stand at first.
  void arrange(QMainWindow* window) const;
  void setDisplay(const DisplayPtr& display) const;
};

}  // namespace boomwatch
