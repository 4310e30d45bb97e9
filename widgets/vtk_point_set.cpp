#include "vtk_point_set.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>
#include <numeric>

namespace boomwatch {
namespace {

static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float), "points are three floats in a row");

/// VTK takes a pointer to what it may change; as the owner of nothing (save = 1) it does not.
template <class Array, class Value>
void lend(Array* array, const Value* values, std::size_t count) {
  array->SetArray(const_cast<Value*>(values), static_cast<vtkIdType>(count), 1);
}

}  // namespace

VtkPointSet::VtkPointSet(double pointSize)
    : m_actor(vtkSmartPointer<vtkActor>::New()), m_data(vtkSmartPointer<vtkPolyData>::New()) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(m_data);
  m_actor->SetMapper(mapper);
  m_actor->ForceOpaqueOn();
  setPointSize(pointSize);
  m_actor->GetProperty()->LightingOff();
  m_actor->VisibilityOff();
}

VtkPointSet::~VtkPointSet() { clear(); }

void VtkPointSet::show(std::span<const Eigen::Vector3f> points,
                       std::span<const DrawnCloud::Rgba> colours) {
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  vtkNew<vtkPoints> vtkPointsOfFrame;
  if (!points.empty()) lend(coordinates.Get(), points.front().data(), 3 * points.size());
  vtkPointsOfFrame->SetData(coordinates);
  m_data->SetPoints(vtkPointsOfFrame);
  if (colours.size() == points.size() && !points.empty()) {
    vtkNew<vtkUnsignedCharArray> rgba;
    rgba->SetNumberOfComponents(4);
    lend(rgba.Get(), colours.front().data(), 4 * colours.size());
    m_data->GetPointData()->SetScalars(rgba);
  } else {
    m_data->GetPointData()->SetScalars(nullptr);
  }
  showVertices(points.size());
  m_actor->SetVisibility(!points.empty());
}

/// One cell that holds every point: its list of indices is the same for every frame.
void VtkPointSet::showVertices(std::size_t count) {
  if (count > m_vertices.size()) {
    m_vertices.resize(count);
    std::iota(m_vertices.begin(), m_vertices.end(), 0);
  }
  vtkNew<vtkCellArray> cells;
  if (count > 0) {
    vtkNew<vtkTypeInt32Array> indices;
    lend(indices.Get(), m_vertices.data(), count);
    vtkNew<vtkTypeInt32Array> offsets;
    offsets->InsertNextValue(0);
    offsets->InsertNextValue(static_cast<std::int32_t>(count));
    cells->SetData(offsets, indices);
  }
  m_data->SetVerts(cells);
  m_data->Modified();
}

void VtkPointSet::setColour(const QColor& colour) {
  m_actor->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
}

void VtkPointSet::setPointSize(double pixels) {
  m_actor->GetProperty()->SetPointSize(static_cast<float>(pixels));
}

}  // namespace boomwatch
