#include "vtk_scene.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace boomwatch {
namespace {

/// y points down in the camera frame.
const Eigen::Vector3d worldUp(0.0, -1.0, 0.0);
constexpr double steepest = 85.0;  // degrees of elevation
constexpr double viewAngle = 35.0;

vtkSmartPointer<vtkPolyData> linesOf(const std::vector<Eigen::Vector3d>& ends) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
    const std::array<vtkIdType, 2> ids{points->InsertNextPoint(ends[k].data()),
                                       points->InsertNextPoint(ends[k + 1].data())};
    cells->InsertNextCell(2, ids.data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

/// The twelve edges; corner k has sign (k & 1, k & 2, k & 4).
std::vector<Eigen::Vector3d> edgesOf(const std::array<Eigen::Vector3d, 8>& corners) {
  std::vector<Eigen::Vector3d> ends;
  for (unsigned k = 0; k < 8; ++k) {
    for (const unsigned axis : {1U, 2U, 4U}) {
      if (k & axis) continue;
      ends.push_back(corners[k]);
      ends.push_back(corners[k | axis]);
    }
  }
  return ends;
}

void showLines(vtkActor* actor, const std::vector<Eigen::Vector3d>& ends) {
  static_cast<vtkPolyDataMapper*>(actor->GetMapper())->SetInputData(linesOf(ends));
  actor->SetVisibility(!ends.empty());
}

vtkSmartPointer<vtkActor> lineActor(const QColor& colour, float width) {
  auto actor = vtkSmartPointer<vtkActor>::New();
  vtkNew<vtkPolyDataMapper> mapper;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
  actor->GetProperty()->SetLineWidth(width);
  actor->GetProperty()->LightingOff();
  actor->VisibilityOff();
  return actor;
}

OrientedBox boxOf(const Bounds& b) {
  const Eigen::Vector3d low(b.xMin, b.yMin, b.zMin);
  const Eigen::Vector3d high(b.xMax, b.yMax, b.zMax);
  return {(low + high) / 2, high - low, Eigen::Matrix3d::Identity()};
}

Eigen::Vector3d vectorOf(const double* v) { return {v[0], v[1], v[2]}; }

}  // namespace

VtkScene::VtkScene(const Theme& theme)
    : m_boundsBox(lineActor(theme.bounds, 1.5F)),
      m_loadBox(lineActor(theme.load, 3.0F)),
      m_nearestLine(lineActor(theme.nearest, 2.5F)),
      m_renderer(vtkSmartPointer<vtkRenderer>::New()) {
  m_removed.setColour(theme.removed);
  m_nearestPoint.setColour(theme.nearest);
  m_nearestPoint.actor()->GetProperty()->RenderPointsAsSpheresOn();
  m_renderer->SetBackground(theme.canvas.redF(), theme.canvas.greenF(), theme.canvas.blueF());
  m_renderer->GetActiveCamera()->SetViewAngle(viewAngle);
  for (vtkActor* actor : {m_boundsBox.Get(), m_cloud.actor(), m_removed.actor(), m_loadBox.Get(),
                          m_nearestLine.Get(), m_nearestPoint.actor()}) {
    m_renderer->AddActor(actor);
  }
  resetView(m_aspect);
}

void VtkScene::setDisplay(const DisplayPtr& display) {
  // The old one is held until VTK has the new arrays.
  const DisplayPtr old = std::exchange(m_display, display);
  const bool shown = m_display && m_display->result;
  showCloud();
  if (shown) {
    const bool moved = !(m_bounds == m_display->result->parameters.bounds);
    m_bounds = m_display->result->parameters.bounds;
    m_removed.show(m_display->result->scene.removed, {});
    if (moved) keepBoundsInView(m_aspect);
  } else {
    m_removed.clear();
  }
  showBoxes();
  showNearest();
}

void VtkScene::setPointLimit(std::size_t limit) {
  if (limit == m_pointLimit) return;
  m_pointLimit = limit;
  showCloud();
}

void VtkScene::showCloud() {
  if (!m_display) return m_cloud.clear();
  const DrawnCloud& cloud = m_display->cloud;
  std::size_t count = cloud.layerEnds.front();
  for (const std::size_t end : cloud.layerEnds) {
    if (end <= m_pointLimit) count = end;
  }
  m_everyPointDrawn = count == cloud.points.size();
  // Fewer points are drawn larger, so that a surface still looks like one.
  const double share = static_cast<double>(count) / static_cast<double>(cloud.points.size() + 1);
  m_cloud.setPointSize(share > 0.6 ? 2.0 : share > 0.2 ? 3.0 : 4.0);
  m_cloud.show(std::span(cloud.points).first(count), std::span(cloud.colours).first(count));
}

void VtkScene::showBoxes() {
  const Result* result = m_display ? m_display->result.get() : nullptr;
  showLines(m_boundsBox,
            result ? edgesOf(boxOf(m_bounds).corners()) : std::vector<Eigen::Vector3d>());
  std::vector<Eigen::Vector3d> edges;
  const auto add = [&](const OrientedBox& box) {
    const auto more = edgesOf(box.corners());
    edges.insert(edges.end(), more.begin(), more.end());
  };
  if (result && result->load) add(*result->load);
  for (const Watched& watched : result ? result->watched : std::vector<Watched>()) {
    if (watched.object != WatchedObject::Load && watched.box) add(*watched.box);
  }
  showLines(m_loadBox, edges);
}

void VtkScene::showNearest() {
  const Result* result = m_display ? m_display->result.get() : nullptr;
  m_nearestPoint.clear();
  m_nearestEnds.clear();
  if (!result || !result->clearance.nearest) return showLines(m_nearestLine, {});
  const Nearest& nearest = *result->clearance.nearest;
  m_nearestEnds.push_back(nearest.onEnvironment.cast<float>());
  m_nearestPoint.show(m_nearestEnds, {});
  showLines(m_nearestLine, {nearest.onLoad, nearest.onEnvironment});
}

void VtkScene::resetView(double aspect) {
  m_aspect = aspect;
  m_viewMoved = false;
  const OrientedBox box = boxOf(m_bounds);
  // From behind the camera and a little above it and to its left, so that depth can be told.
  const Eigen::Vector3d ahead = Eigen::Vector3d(0.35, 0.4, 1.0).normalized();
  const Eigen::Vector3d side = ahead.cross(worldUp).normalized();
  const Eigen::Vector3d up = side.cross(ahead);
  const double slope = std::tan(viewAngle / 2 * M_PI / 180.0);
  double distance = 0.0;
  for (const Eigen::Vector3d& corner : box.corners()) {
    const Eigen::Vector3d c = corner - box.centre;
    const double needed =
        std::max(std::abs(c.dot(side)) / (slope * aspect), std::abs(c.dot(up)) / slope);
    distance = std::max(distance, needed - c.dot(ahead));
  }
  const Eigen::Vector3d eye = box.centre - 1.08 * distance * ahead;
  vtkCamera* camera = m_renderer->GetActiveCamera();
  camera->SetFocalPoint(box.centre.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(worldUp.data());
}

void VtkScene::keepBoundsInView(double aspect) {
  if (m_viewMoved) {
    m_aspect = aspect;
  } else {
    resetView(aspect);
  }
}

void VtkScene::orbit(double azimuth, double elevation) {
  vtkCamera* camera = m_renderer->GetActiveCamera();
  const Eigen::Vector3d focus = vectorOf(camera->GetFocalPoint());
  const Eigen::Vector3d arm = vectorOf(camera->GetPosition()) - focus;
  const double now = std::asin(std::clamp(arm.normalized().dot(worldUp), -1.0, 1.0)) * 180 / M_PI;
  const double turn = std::clamp(now + elevation, -steepest, steepest) - now;
  const Eigen::Vector3d side = worldUp.cross(arm).normalized();
  constexpr double degree = M_PI / 180.0;
  const Eigen::Vector3d turned = Eigen::AngleAxisd(azimuth * degree, worldUp) *
                                 (Eigen::AngleAxisd(-turn * degree, side) * arm);
  const Eigen::Vector3d eye = focus + turned;
  camera->SetPosition(eye.data());
  camera->SetViewUp(worldUp.data());
  m_viewMoved = true;
}

void VtkScene::pan(double right, double down, double viewHeight) {
  vtkCamera* camera = m_renderer->GetActiveCamera();
  const Eigen::Vector3d focus = vectorOf(camera->GetFocalPoint());
  const Eigen::Vector3d eye = vectorOf(camera->GetPosition());
  const Eigen::Vector3d ahead = (focus - eye).normalized();
  const Eigen::Vector3d side = ahead.cross(worldUp).normalized();
  const Eigen::Vector3d up = side.cross(ahead);
  const double seen = 2 * (focus - eye).norm() * std::tan(viewAngle / 2 * M_PI / 180.0);
  const Eigen::Vector3d by = (up * down - side * right) * (seen / std::max(1.0, viewHeight));
  const Eigen::Vector3d newFocus = focus + by;
  const Eigen::Vector3d newEye = eye + by;
  camera->SetFocalPoint(newFocus.data());
  camera->SetPosition(newEye.data());
  m_viewMoved = true;
}

void VtkScene::zoom(double factor) {
  vtkCamera* camera = m_renderer->GetActiveCamera();
  const Eigen::Vector3d focus = vectorOf(camera->GetFocalPoint());
  const Eigen::Vector3d arm = vectorOf(camera->GetPosition()) - focus;
  const double reach = boxOf(m_bounds).size.norm();
  const double length = std::clamp(arm.norm() / factor, reach * 1e-3, reach * 20);
  const Eigen::Vector3d eye = focus + arm.normalized() * length;
  camera->SetPosition(eye.data());
  m_viewMoved = true;
}

}  // namespace boomwatch
