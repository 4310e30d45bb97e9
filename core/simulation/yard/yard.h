#pragma once

#include <array>
#include <memory>

#include "frame/stereo_rig.h"
#include "simulation/yard/yard_options.h"
#include "simulation/yard/yard_picture.h"
#include "simulation/yard/yard_truth.h"

namespace boomwatch {

/// What both cameras see at one moment, without weather and sensor.
struct YardShot {
  std::array<YardPicture, 2> eyes;  ///< left, right; only left unless the view is stereo
};

/// The forestry yard: its things, where they are at a time, and what cameras on the machine's mast
/// see of them. All is decided by the options; everything but the constructor is const and pure.
class Yard {
 public:
  static constexpr double rate = 20.0;      ///< frames a second
  static constexpr double baseline = 0.24;  ///< metres

  /// Plants the yard and paints what does not move: about a second.
  explicit Yard(const YardOptions& options);

  /// Several threads inside.
  YardShot shootAt(double time) const;
  /// `shot` must be of the same time.
  YardTruth truthAt(double time, const YardShot& shot) const;
  /// Camera frame.
  OrientedBox loadAt(double time) const;

  /// 0: left, 1: right.
  const YardEye& eye(std::size_t side) const { return m_eyes[side]; }
  const StereoRig& rig() const { return m_rig; }

 private:
  /// Camera frame.
  Parts movingAt(double time) const;
  /// A place on the ground (yard frame), camera frame.
  Eigen::Vector3d yardAt(double x, double z) const;
  Parts toCamera(const Parts& parts) const;

  YardOptions m_options;
  std::shared_ptr<const YardLayout> m_layout;  ///< shared with the truth of its frames
  CranePath m_path;
  Eigen::Matrix3d m_level;  ///< from the camera's to the yard frame
  std::array<YardEye, 2> m_eyes;
  std::shared_ptr<const YardShadows> m_shadows;  ///< of what does not move
  std::array<YardPicture, 2> m_still;            ///< what does not move, as each eye sees it
  StereoRig m_rig;
};

}  // namespace boomwatch
