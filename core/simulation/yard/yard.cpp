#include "simulation/yard/yard.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "simulation/yard/clutter.h"

namespace boomwatch {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double pitch = 18.0 * std::numbers::pi / 180.0;  // how far the cameras look down

constexpr double shadowed = 14.0;  // z up to which what moves throws a shadow

/// Columns: the camera's axes in the level yard frame.
Matrix3d levelOf(double down) {
  Matrix3d level;
  level << 1, 0, 0, 0, std::cos(down), std::sin(down), 0, -std::sin(down), std::cos(down);
  return level;
}

StereoRig rigOf(const PinholeCamera& camera) {
  StereoRig rig;
  rig.imageSize = {camera.width, camera.height};
  rig.leftMatrix = {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
  rig.rightMatrix = rig.leftMatrix;
  rig.translation = {-Yard::baseline, 0, 0};
  rig.rectified = true;
  return rig;
}

/// With four samples a pixel: textures and edges as a lens would show them.
YardPicture paintStill(const YardEye& eye, const YardGround& ground, const Parts& parts,
                       const YardShadows& shadows) {
  const auto painted = [&](const YardEye& from) {
    YardPicture picture = paintGround(from, ground, shadows);
    paint(from, parts, shadows, picture);
    return picture;
  };
  YardEye fine = eye;
  fine.camera =
      PinholeCamera::centred(2 * eye.camera.width, 2 * eye.camera.height, 2 * eye.camera.fx);
  YardPicture picture = painted(eye);
  cv::resize(painted(fine).colour, picture.colour, picture.colour.size(), 0, 0, cv::INTER_AREA);
  return picture;
}

YardApproach inCamera(YardApproach approach, const Matrix3d& level) {
  approach.pair.onA = level.transpose() * approach.pair.onA;
  approach.pair.onB = level.transpose() * approach.pair.onB;
  return approach;
}

/// The crane keeps clear of branches as well.
YardLayout withBoughsAtRest(YardLayout layout) {
  for (const Bough& bough : layout.boughs) {
    for (Part part : bough.parts) {
      part.kind = YardKind::Tree;
      layout.fixed.push_back(part);
    }
  }
  layout.boughs.clear();
  return layout;
}

/// Without clutter the branches hold still.
std::shared_ptr<const YardLayout> layoutOf(const YardOptions& options) {
  YardLayout layout(options.seed);
  return std::make_shared<YardLayout>(options.clutter ? std::move(layout)
                                                      : withBoughsAtRest(std::move(layout)));
}

/// What is large enough.
Parts throwingShadows(const Parts& parts) {
  Parts large;
  std::ranges::copy_if(parts, std::back_inserter(large), [](const Part& part) {
    return part.kind != YardKind::Bird && part.kind != YardKind::Leaf;
  });
  return large;
}

}  // namespace

Yard::Yard(const YardOptions& options)
    : m_options(options),
      m_layout(layoutOf(options)),
      m_path(withBoughsAtRest(*m_layout), options.seed, options.path,
             static_cast<double>(options.frames) / rate + 1.0),
      m_level(levelOf(pitch)) {
  m_eyes[0].level = m_eyes[1].level = m_level;
  m_eyes[1].eye = {baseline, 0, 0};
  m_rig = rigOf(m_eyes[0].camera);
  const Parts fixed = toCamera(m_layout->fixed);
  // The shadows of the wood behind begin where the yard ends.
  m_shadows = std::make_shared<YardShadows>(fixed, m_level, yardAt(0.0, 12.0), 18.0);
  const std::size_t eyes = options.as == YardView::Stereo ? 2 : 1;
  for (std::size_t k = 0; k < eyes; ++k) {
    m_still[k] = paintStill(m_eyes[k], m_layout->ground, fixed, *m_shadows);
  }
}

Eigen::Vector3d Yard::yardAt(double x, double z) const {
  return m_level.transpose() * Vector3d(x, m_layout->ground.yAt(x, z), z);
}

Parts Yard::toCamera(const Parts& parts) const {
  Parts moved;
  moved.reserve(parts.size());
  for (const Part& part : parts) moved.push_back(turned(part, m_level.transpose()));
  return moved;
}

Parts Yard::movingAt(double time) const {
  const CranePose pose = m_path.at(time);
  Parts parts = m_layout->crane.partsAt(pose, m_layout->log);
  parts.push_back(logAt(pose, m_layout->log));
  const auto add = [&](const Parts& more) { parts.insert(parts.end(), more.begin(), more.end()); };
  if (m_options.person) add(personAt(m_layout->walk, m_layout->ground, time));
  if (m_options.clutter) {
    add(boughsAt(m_layout->boughs, time));
    add(clutterAt(m_options.seed, time));
  }
  return toCamera(parts);
}

YardShot Yard::shootAt(double time) const {
  const Parts moving = movingAt(time);
  const YardShadows shadows(throwingShadows(moving), m_level, yardAt(0.0, 7.0), 8.0);
  YardShot shot;
  for (std::size_t k = 0; k < shot.eyes.size(); ++k) {
    if (m_still[k].colour.empty()) continue;
    shot.eyes[k] = m_still[k].clone();
    shade(m_eyes[k], shadows, shadowed, shot.eyes[k]);
    paint(m_eyes[k], moving, *m_shadows, shot.eyes[k]);
  }
  return shot;
}

OrientedBox Yard::loadAt(double time) const {
  return loadBoxOf(turned(logAt(m_path.at(time), m_layout->log), m_level.transpose()));
}

YardTruth Yard::truthAt(double time, const YardShot& shot) const {
  const CranePose pose = m_path.at(time);
  const Part log = logAt(pose, m_layout->log);
  YardTruth truth;
  truth.kind = shot.eyes[0].kind;
  truth.depth = shot.eyes[0].depth.clone();
  truth.depth.setTo(std::numeric_limits<float>::quiet_NaN(), truth.depth > YardTruth::farthest);
  truth.depthTimesDisparity = m_eyes[0].camera.fx * baseline;
  truth.toolPoint = m_level.transpose() * toolPointAt(pose);
  const Eigen::Vector2d toolPixel = m_eyes[0].camera.project(truth.toolPoint);
  truth.toolPixel = {toolPixel.x(), toolPixel.y()};
  Parts tool = toCamera(m_layout->crane.partsAt(pose, m_layout->log));
  std::erase_if(tool, [](const Part& part) { return part.kind != YardKind::Tool; });
  const cv::Mat silhouette = silhouetteOf(m_eyes[0], tool);
  truth.toolBox = cv::boundingRect(silhouette);
  const int covered = cv::countNonZero(silhouette);
  const int visible = cv::countNonZero(truth.kind == static_cast<double>(YardKind::Tool));
  truth.toolVisible = covered > 0 ? static_cast<double>(visible) / covered : 0.0;
  truth.load = loadAt(time);
  truth.log = cylinderOf(turned(log, m_level.transpose()));
  const OrientedBox load = loadBoxOf(log);
  const YardObstacles obstacles(*m_layout);
  truth.nearest = inCamera(obstacles.nearest(load), m_level);
  if (m_options.person) {
    truth.person =
        nearestOf(truth.load, toCamera(personAt(m_layout->walk, m_layout->ground, time)));
  }
  truth.everything = [layout = m_layout, level = m_level, load] {
    std::vector<YardApproach> all = YardObstacles(*layout).all(load);
    for (YardApproach& approach : all) approach = inCamera(approach, level);
    return all;
  };
  truth.branch = nearestOf(truth.load, toCamera(boughsAt(m_layout->boughs, time)));
  return truth;
}

}  // namespace boomwatch
