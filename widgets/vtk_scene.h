#pragma once

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <limits>

#include "display.h"
#include "theme.h"
#include "vtk_point_set.h"

namespace boomwatch {

/// What the cloud view shows, as VTK actors: cloud, removed points, bounds, load, nearest pair.
/// Knows nothing of windows; needs no OpenGL until its renderer is drawn. GUI thread.
class VtkScene {
 public:
  explicit VtkScene(const Theme& theme);

  vtkRenderer* renderer() const { return m_renderer; }

  /// Null clears. Keeps `display` alive, whose arrays VTK draws.
  void setDisplay(const DisplayPtr& display);
  /// Draws no more points of the cloud than this, but at least one of its layers.
  void setPointLimit(std::size_t limit);
  std::size_t pointLimit() const { return m_pointLimit; }
  bool everyPointDrawn() const { return m_everyPointDrawn; }

  /// Looks at the whole of the bounds; `aspect` is the view's width over its height.
  void resetView(double aspect);
  /// resetView, unless a person has turned the view since.
  void keepBoundsInView(double aspect);
  /// Turns about the focal point; degrees. Never tips over the poles.
  void orbit(double azimuth, double elevation);
  /// Moves with the hand: pixels of a view that is `viewHeight` pixels high.
  void pan(double right, double down, double viewHeight);
  void zoom(double factor);

 private:
  void showCloud();
  void showBoxes();
  void showNearest();

  DisplayPtr m_display;
  std::size_t m_pointLimit = std::numeric_limits<std::size_t>::max();
  bool m_everyPointDrawn = true;
  double m_aspect = 1.5;
  bool m_viewMoved = false;  ///< by a person: then new bounds leave it alone
  Bounds m_bounds;
  VtkPointSet m_cloud{2.0};
  VtkPointSet m_removed{4.0};
  VtkPointSet m_nearestPoint{12.0};
  vtkSmartPointer<vtkActor> m_boundsBox;
  vtkSmartPointer<vtkActor> m_loadBox;
  vtkSmartPointer<vtkActor> m_nearestLine;
  Points m_nearestEnds;  ///< lent to m_nearestPoint
  vtkSmartPointer<vtkRenderer> m_renderer;
};

}  // namespace boomwatch
