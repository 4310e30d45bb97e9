#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "environment/environment_model.h"
#include "frame/oriented_box.h"

/// Models and boxes that the collision tests and their benchmark share.
namespace boomwatch::scenes {

using Random = std::mt19937;

inline double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Occupies the cell with the surface nearest to `z`.
inline void occupy(EnvironmentModel& model, int column, int row, double z) {
  model.set(column, row, 0.6F, model.geometry().levelOf(z));
}

/// A floor at `z` in every cell.
inline EnvironmentModel flatFloor(const GridGeometry& geometry, double z) {
  EnvironmentModel model(geometry);
  for (int j = 0; j < geometry.rows(); ++j) {
    for (int i = 0; i < geometry.columns(); ++i) occupy(model, i, j, z);
  }
  return model;
}

/// Hilly, rough ground, 6 to 8 m away.
inline EnvironmentModel unevenGround(const GridGeometry& geometry, Random& random) {
  EnvironmentModel model(geometry);
  for (int j = 0; j < geometry.rows(); ++j) {
    for (int i = 0; i < geometry.columns(); ++i) {
      const double x = geometry.xOf(i), y = geometry.yOf(j);
      const double hills = 7.0 + 0.5 * std::sin(0.9 * x) + 0.3 * std::cos(1.3 * y + 0.4 * x);
      occupy(model, i, j, hills + uniform(random, -0.03, 0.03));
    }
  }
  return model;
}

/// `count` round trunks of `radius` metres with their near ends 2 to 5 m from the camera.
inline void addTrunks(EnvironmentModel& model, Random& random, int count, double radius) {
  const GridGeometry& g = model.geometry();
  const Bounds& b = g.bounds();
  for (int n = 0; n < count; ++n) {
    const double x = uniform(random, b.xMin, b.xMax), y = uniform(random, b.yMin, b.yMax);
    const double z = uniform(random, 2.0, 5.0);
    for (int j = g.rowOf(y - radius); j <= g.rowOf(y + radius); ++j) {
      for (int i = g.columnOf(x - radius); i <= g.columnOf(x + radius); ++i) {
        if (!g.contains(i, j)) continue;
        if (std::hypot(g.xOf(i) - x, g.yOf(j) - y) <= radius) occupy(model, i, j, z);
      }
    }
  }
}

/// The thesis's kind of scene: ground and trunks, with `holes` (a share) never observed.
inline EnvironmentModel forest(const GridGeometry& geometry, Random& random, int trunks,
                               double holes = 0.0) {
  EnvironmentModel model = unevenGround(geometry, random);
  addTrunks(model, random, trunks, 0.15);
  for (int j = 0; j < geometry.rows(); ++j) {
    for (int i = 0; i < geometry.columns(); ++i) {
      if (uniform(random, 0, 1) < holes) model.set(i, j, 0.0F, 0);
    }
  }
  return model;
}

inline Eigen::Matrix3d anyTurn(Random& random) {
  std::normal_distribution<double> normal;
  return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
      .normalized()
      .toRotationMatrix();
}

/// A load as the job has it, 2 x 0.3 x 0.3 m or a little smaller, anyhow turned, in the bounds.
inline OrientedBox anyLoad(const Bounds& b, Random& random) {
  OrientedBox box;
  box.centre = {uniform(random, b.xMin, b.xMax), uniform(random, b.yMin, b.yMax),
                uniform(random, b.zMin, b.zMax)};
  box.size = {uniform(random, 0.5, 2.0), uniform(random, 0.1, 0.3), uniform(random, 0.1, 0.3)};
  box.rotation = anyTurn(random);
  return box;
}

}  // namespace boomwatch::scenes
