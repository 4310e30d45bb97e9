#pragma once

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

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
  /// While on, only the preview of the cloud is drawn.
  void setPreview(bool on);

  void resetView();
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
  bool m_preview = false;
  bool m_viewMoved = false;  ///< by a person: then new bounds leave it alone
  Bounds m_bounds;
  VtkPointSet m_cloud{2.0};
  VtkPointSet m_removed{4.0};
  VtkPointSet m_nearestPoint{14.0};
  vtkSmartPointer<vtkActor> m_boundsBox;
  vtkSmartPointer<vtkActor> m_loadBox;
  vtkSmartPointer<vtkActor> m_nearestLine;
  Points m_nearestEnds;  ///< lent to m_nearestPoint
  vtkSmartPointer<vtkRenderer> m_renderer;
};

}  // namespace boomwatch
