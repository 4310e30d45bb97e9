#include "simulation/yard/yard_ground.h"

#include <algorithm>
#include <cmath>

#include "simulation/yard/dice.h"
#include "simulation/yard/texture.h"

namespace boomwatch {

using Eigen::Vector3d;

YardGround::YardGround(std::uint64_t seed, double depth) : m_y(std::size_t{columns} * rows) {
  Dice dice(seed, 11);
  const Eigen::Vector3f place(static_cast<float>(dice.uniform(0, 50)), 0.5F,
                              static_cast<float>(dice.uniform(0, 50)));
  m_highest = depth;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double x = left + cell * column, z = near + cell * row;
      const Eigen::Vector3f at(static_cast<float>(x), 0.0F, static_cast<float>(z));
      double bumps = 0.22 * static_cast<double>(noiseAt(place + at / 3.5F)) +
                     0.07 * static_cast<double>(noiseAt(place + at / 1.1F));
      // The wood behind stands on a bank.
      bumps += 0.06 * std::max(0.0, z - 12.0) - 0.05 * std::max(0.0, z - 30.0);
      double& y = m_y[static_cast<std::size_t>(row * columns + column)];
      y = depth - bumps;
      m_highest = std::min(m_highest, y);
    }
  }
}

double YardGround::yAt(double x, double z) const {
  const double c = std::clamp((x - left) / cell, 0.0, columns - 1.001);
  const double r = std::clamp((z - near) / cell, 0.0, rows - 1.001);
  const int column = static_cast<int>(c), row = static_cast<int>(r);
  const double s = c - column, t = r - row;
  const double a = corner(column, row).y(), b = corner(column + 1, row).y();
  const double d = corner(column, row + 1).y(), e = corner(column + 1, row + 1).y();
  // The cell's diagonal goes from b to d.
  return s + t <= 1.0 ? a + s * (b - a) + t * (d - a) : e + (1 - s) * (d - e) + (1 - t) * (b - e);
}

Vector3d YardGround::normalAt(double x, double z) const {
  constexpr double step = 0.3;
  const double slopeX = (yAt(x + step, z) - yAt(x - step, z)) / (2 * step);
  const double slopeZ = (yAt(x, z + step) - yAt(x, z - step)) / (2 * step);
  return Vector3d(slopeX, -1.0, slopeZ).normalized();
}

void YardGround::addCell(std::vector<Triangle>& triangles, int column, int row) const {
  const Vector3d a = corner(column, row), b = corner(column + 1, row);
  const Vector3d d = corner(column, row + 1), e = corner(column + 1, row + 1);
  triangles.push_back({a, b, d});
  triangles.push_back({e, d, b});
}

std::vector<YardGround::Triangle> YardGround::triangles() const {
  std::vector<Triangle> all;
  all.reserve(std::size_t{2} * (columns - 1) * (rows - 1));
  for (int row = 0; row + 1 < rows; ++row) {
    for (int column = 0; column + 1 < columns; ++column) addCell(all, column, row);
  }
  return all;
}

std::vector<YardGround::Triangle> YardGround::triangles(double xMin, double xMax, double zMin,
                                                        double zMax) const {
  const auto index = [](double at, double from, int count) {
    return static_cast<int>(std::clamp(std::floor((at - from) / cell), -1.0, count - 1.0));
  };
  std::vector<Triangle> some;
  for (int row = std::max(0, index(zMin, near, rows) - 1);
       row <= std::min(rows - 2, index(zMax, near, rows) + 1); ++row) {
    for (int column = std::max(0, index(xMin, left, columns) - 1);
         column <= std::min(columns - 2, index(xMax, left, columns) + 1); ++column) {
      addCell(some, column, row);
    }
  }
  return some;
}

}  // namespace boomwatch
