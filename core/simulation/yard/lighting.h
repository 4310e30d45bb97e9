#pragma once

#include "simulation/yard/yard_eye.h"

namespace boomwatch {

/// Which places bodies keep the sun from. Camera frame; `level` turns it into the yard frame.
class YardShadows {
 public:
  /// Within `reach` metres of `middle`; elsewhere there are none.
  YardShadows(const Parts& parts, const Eigen::Matrix3d& level, const Eigen::Vector3d& middle,
              double reach);

  /// 0: in full shadow, 1: none. Edges are soft. `normal` is that of the surface there.
  float sunAt(const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const;

 private:
  Eigen::Matrix3d m_toSun;  ///< from the camera frame to one that looks along the light
  YardEye m_eye;
  cv::Mat m_depth;
};

/// A bright day with thin clouds: the light on a surface, of full light 1.
struct Lighting {
  float sky = 0.0F;  ///< from all over the sky, and thrown back by the ground
  float sun = 0.0F;  ///< in no shadow
};
/// `normal` in the yard frame.
Lighting lightingOf(const Eigen::Vector3d& normal);

}  // namespace boomwatch
