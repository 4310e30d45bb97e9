#include "simulation/convex_pair.h"

#include <Eigen/QR>
#include <algorithm>
#include <vector>

namespace boomwatch {
namespace {

/// A point of the Minkowski difference a - b.
struct Difference {
  Eigen::Vector3d point, onA;
};

/// At most four points and the weights with which they make `nearest`.
class Simplex {
 public:
  explicit Simplex(const Difference& point) : m_points{point}, m_weights{1.0} {}

  std::size_t size() const { return m_points.size(); }

  Eigen::Vector3d nearest() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < size(); ++k) sum += m_weights[k] * m_points[k].point;
    return sum;
  }

  /// The point of body a that belongs to `nearest`.
  Eigen::Vector3d nearestOnA() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < size(); ++k) sum += m_weights[k] * m_points[k].onA;
    return sum;
  }

  /// Adds a point and moves `nearest` to the point of the hull that is nearest to the origin.
  void add(const Difference& point) {
    m_points.push_back(point);
    m_weights.push_back(0.0);
    while (true) {
      const Eigen::VectorXd affine = affineWeights();
      if (affine.minCoeff() > negligible) {
        m_weights.assign(affine.begin(), affine.end());
        return;
      }
      moveToBoundary(affine);
      if (size() == 1) return;
    }
  }

 private:
  static constexpr double negligible = 1e-12;

  /// The weights, of sum 1, of the point of the affine hull that is nearest to the origin.
  Eigen::VectorXd affineWeights() const {
    const auto edges = static_cast<Eigen::Index>(size()) - 1;
    // Edges rather than the points' Gram matrix, which loses half of the digits where the bodies
    // almost touch.
    Eigen::Matrix3Xd matrix(3, edges);
    for (Eigen::Index k = 0; k < edges; ++k) {
      matrix.col(k) = m_points[static_cast<std::size_t>(k) + 1].point - m_points[0].point;
    }
    Eigen::VectorXd weights(edges + 1);
    weights.tail(edges) = matrix.colPivHouseholderQr().solve(-m_points[0].point);
    weights[0] = 1.0 - weights.tail(edges).sum();
    return weights;
  }

  /// Goes from the present weights towards `affine` until one is 0, and drops what has none.
  void moveToBoundary(const Eigen::VectorXd& affine) {
    double step = 1.0;
    std::size_t leaves = 0;
    for (std::size_t k = 0; k < size(); ++k) {
      const double target = affine[static_cast<Eigen::Index>(k)];
      if (target > negligible) continue;
      const double fraction =
          std::min(1.0, m_weights[k] / std::max(m_weights[k] - target, negligible));
      if (fraction <= step) {
        step = fraction;
        leaves = k;
      }
    }
    for (std::size_t k = 0; k < size(); ++k) {
      m_weights[k] += step * (affine[static_cast<Eigen::Index>(k)] - m_weights[k]);
    }
    m_points.erase(m_points.begin() + static_cast<std::ptrdiff_t>(leaves));
    m_weights.erase(m_weights.begin() + static_cast<std::ptrdiff_t>(leaves));
    double sum = 0.0;
    for (const double weight : m_weights) sum += weight;
    for (double& weight : m_weights) weight /= sum;
  }

  std::vector<Difference> m_points;
  std::vector<double> m_weights;
};

}  // namespace

ConvexPair nearestPair(const Support& a, const Support& b) {
  constexpr double tolerance = 1e-6;
  constexpr int maxSteps = 200;
  const auto difference = [&](const Eigen::Vector3d& direction) -> Difference {
    const Eigen::Vector3d onA = a(direction);
    return {onA - b(-direction), onA};
  };
  Simplex simplex(difference(Eigen::Vector3d::UnitX()));
  const auto found = [&]() -> ConvexPair {
    const Eigen::Vector3d nearest = simplex.nearest(), onA = simplex.nearestOnA();
    return {nearest.norm(), onA, onA - nearest};
  };
  for (int step = 0; step < maxSteps; ++step) {
    const Eigen::Vector3d nearest = simplex.nearest();
    const double distance = nearest.norm();
    if (distance < tolerance) return {};
    const Difference farther = difference(-nearest);
    if (distance - nearest.dot(farther.point) / distance < tolerance) return found();
    simplex.add(farther);
    if (simplex.size() == 4) return {};  // the origin lies within
  }
  return found();
}

double convexDistance(const Support& a, const Support& b) { return nearestPair(a, b).distance; }

Support supportOf(const OrientedBox& box) {
  return [box](const Eigen::Vector3d& direction) -> Eigen::Vector3d {
    const Eigen::Vector3d local = box.rotation.transpose() * direction;
    const Eigen::Vector3d half = box.size / 2;
    return box.centre + box.rotation * (local.array() < 0.0).select(-half, half);
  };
}

}  // namespace boomwatch
