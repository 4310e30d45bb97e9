#pragma once

#include <QString>
#include <map>
#include <string>

#include "load/load_detector.h"
#include "support/load_scene.h"

/// How far a detector is from the truth of simulated poses.
namespace boomwatch::load_scene {

inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::infinity();
  const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + k, values.end());
  return values[static_cast<std::size_t>(k)];
}

/// The bounds of these scenes: wide enough for every pose.
inline Bounds wideBounds() { return {-10, 10, -10, 10, 0, 15}; }

struct Errors {
  std::vector<double> axis;    ///< degrees
  std::vector<double> centre;  ///< metres
  std::vector<double> radius;  ///< share of the truth, as the next
  std::vector<double> length;
  std::map<std::string, int> refused;
  int poses = 0;
  int badly = 0;  ///< found where it is not: by more than 15 degrees or 0.3 m

  std::size_t found() const { return axis.size(); }
  void add(const OrientedBox& box, const Cylinder& log) {
    const double cosine = std::min(1.0, std::abs(box.rotation.col(0).dot(log.axis)));
    axis.push_back(std::acos(cosine) * 180.0 / std::numbers::pi);
    centre.push_back((box.centre - log.centre).norm());
    radius.push_back(std::abs(box.size.y() / 2.0 / log.radius - 1.0));
    length.push_back(std::abs(box.size.x() / log.length - 1.0));
    badly += axis.back() > 15.0 || centre.back() > 0.3 ? 1 : 0;
  }
  QString text() const {
    const auto pair = [](const std::vector<double>& values, double unit) {
      return QStringLiteral("%1 (90 %: %2)")
          .arg(unit * quantile(values, 0.5), 0, 'f', 2)
          .arg(unit * quantile(values, 0.9), 0, 'f', 2);
    };
    QString text = QStringLiteral(
                       "%1 of %2 found, %7 badly; medians: axis %3 deg, centre %4 cm, "
                       "radius %5 %, length %6 %; refused:")
                       .arg(found())
                       .arg(poses)
                       .arg(pair(axis, 1), pair(centre, 100), pair(radius, 100), pair(length, 100))
                       .arg(badly);
    for (const auto& [fault, count] : refused) {
      text += QStringLiteral(" %1 %2").arg(QString::fromStdString(fault)).arg(count);
    }
    return text;
  }
};

/// Absent where the grapple is hidden.
inline std::optional<LoadDetection> detectIn(const LoadScene& scene, unsigned seed,
                                             const LoadParameters& parameters = {}) {
  const Cloud cloud = cloudOf(scene, seed);
  const auto tool = toolPointOf(scene, cloud, seed);
  if (!tool) return std::nullopt;
  return detectLoad(cloud, *tool, scene.depthNoise(), wideBounds(), parameters);
}

/// Adds `poses` logs in grapples that are not hidden, from seed `first` on.
inline void addPoses(Errors& errors, unsigned first, int poses) {
  for (unsigned seed = first; poses > 0; ++seed) {
    const LoadScene scene = logInGrapple(seed);
    const auto found = detectIn(scene, seed);
    if (!found) continue;
    --poses;
    ++errors.poses;
    if (found->box) {
      errors.add(*found->box, *scene.log);
    } else {
      ++errors.refused[std::string(toString(found->fault))];
    }
  }
}

/// How many of `poses` empty grapples, from seed `first` on, are taken for a load.
inline int falseLoads(unsigned first, int poses) {
  int count = 0;
  for (unsigned seed = first; poses > 0; ++seed) {
    const auto found = detectIn(emptyGrapple(seed), seed);
    if (!found) continue;
    --poses;
    if (!found->box) continue;
    ++count;
    qInfo("empty grapple %u is taken for a load", seed);
  }
  return count;
}

}  // namespace boomwatch::load_scene
