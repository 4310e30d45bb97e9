#pragma once

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <Eigen/Core>
#include <QColor>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "display.h"

namespace boomwatch {

/// Many points as one VTK actor. The arrays are handed over as they are, without a copy: whoever
/// calls show() keeps them alive until the next show() or clear(). GUI thread.
class VtkPointSet {
 public:
  explicit VtkPointSet(double pointSize);
  ~VtkPointSet();
  VtkPointSet(const VtkPointSet&) = delete;
  VtkPointSet& operator=(const VtkPointSet&) = delete;

  vtkActor* actor() const { return m_actor; }

  /// All points finite. `colours`: one a point, or empty for the colour that was set.
  void show(std::span<const Eigen::Vector3f> points, std::span<const DrawnCloud::Rgba> colours);
  void clear() { show({}, {}); }
  void setColour(const QColor& colour);
  void setPointSize(double pixels);

 private:
  void showVertices(std::size_t count);

  vtkSmartPointer<vtkActor> m_actor;
  vtkSmartPointer<vtkPolyData> m_data;
  std::vector<std::int32_t> m_vertices;  ///< 0, 1, 2, ...: grows, and is shared by every frame
};

}  // namespace boomwatch
