#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "frame/frame.h"
#include "parameters/parameters.h"
#include "stereo/stereo_stage.h"

namespace boomwatch {

/// A frame whose picture is ready and whose cloud is still to be made.
struct MatchedFrame {
  RectifiedPair pair;  ///< `left` alone where the frame brings its own cloud
  cv::Mat disparity;   ///< as matchDisparity() gives it; empty unless stereo
  std::string fault;   ///< English: why there can be no cloud; empty if there was no fault
};

/// The picture and the points of one frame. Camera frame, metres.
struct SensedFrame {
  cv::Mat image;  ///< left, rectified: CV_8UC1 or CV_8UC3; empty if there is no picture
  /// For the model: without flying pixels. Organised where the source is. Null on a fault.
  std::shared_ptr<const Cloud> cloud;
  /// For tool and load: with the flying pixels, because their rims are among them. Null on a fault.
  std::shared_ptr<const Cloud> whole;
  std::optional<double> rowResidue, rowsCorrected;  ///< see StereoResult; absent unless stereo
  std::string fault;  ///< English: why there is no cloud; empty if there is one
};

/// How much of an inverse depth a matcher may take from the background at an object's rim, 1/m.
/// 0 unless stereo.
double inverseDepthSmear(const SensedFrame& sensed);

/// The depth error, +- metres, that the matching's noise makes at depth `z`. Absent unless stereo.
std::optional<double> depthUncertainty(const SensedFrame& sensed, double z);

/// Turns a frame into a picture and a cloud. Two steps, because a tracker needs the picture only:
/// it can work during the second. Faults of a frame are values. Used by one thread.
class SensingStage {
 public:
  /// First step: rectify and match, where the frame is a stereo pair.
  MatchedFrame match(const Frame& frame, const StereoParameters& parameters);

  /// Second step, of what match() gave for the same frame: reproject the disparities, or smooth the
  /// depth of the cloud that the frame brings.
  SensedFrame reproject(const Frame& frame, const MatchedFrame& matched,
                        const Parameters& parameters);

 private:
  StereoStage m_stereo;  ///< rectification maps, and what the first frames showed of the rows
};

}  // namespace boomwatch
