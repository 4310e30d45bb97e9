#include "simulation/yard/yard_source.h"

#include "simulation/yard/depth_cloud.h"

namespace boomwatch {
namespace {

constexpr int exposuresOfBlur = 5;  // odd

}  // namespace

YardSource::YardSource(const std::string& options, const std::string& address)
    : YardSource(parseYardOptions(options, address), address) {}

YardSource::YardSource(const YardOptions& options, const std::string& address)
    : IndexedSource(address, options.frames, Yard::rate),
      m_options(options),
      m_yard(options),
      m_sensor(options),
      m_rig(std::make_shared<StereoRig>(m_yard.rig())) {}

YardFrame YardSource::at(std::size_t index) const {
  const double time = static_cast<double>(index) / Yard::rate;
  YardShot shot = m_yard.shootAt(time);
  auto frame = std::make_shared<Frame>();
  frame->sequence = index;
  frame->stamp = time;
  const auto truth = std::make_shared<const YardTruth>(m_yard.truthAt(time, shot));
  if (m_options.blur > 0.0) addBlur(shot, time);
  frame->left = shot.eyes[0].colour;
  m_sensor.expose(frame->left, m_yard.eye(0), index);
  if (m_options.as == YardView::Stereo) {
    frame->right = shot.eyes[1].colour;
    m_sensor.expose(frame->right, m_yard.eye(1), index);
    frame->rig = m_rig;
  } else {
    frame->cloud = cloudOf(measured(*truth, index), m_yard.eye(0).camera);
  }
  frame->load = truth->load;
  frame->tool = boxAround(truth->toolPoint);
  frame->trueDistance = truth->nearest.pair.distance;
  return {std::move(frame), truth};
}

/// The link, the rotator and the upper half of the grapple: as little background as can be.
cv::Rect2d YardSource::boxAround(const Eigen::Vector3d& toolPoint) const {
  constexpr double half = 0.28, above = 0.14, below = 0.55;  // metres
  const PinholeCamera& camera = m_yard.eye(0).camera;
  const double scale = camera.fx / toolPoint.z();
  return {camera.cx + (toolPoint.x() - half) * scale, camera.cy + (toolPoint.y() - above) * scale,
          2 * half * scale, (above + below) * scale};
}

/// The mean of the pictures while the shutter is open, of which `shot` is the middle one.
void YardSource::addBlur(YardShot& shot, double time) const {
  std::array<cv::Mat, 2> sums;
  for (std::size_t eye = 0; eye < sums.size(); ++eye) {
    shot.eyes[eye].colour.convertTo(sums[eye], CV_16U);
  }
  for (int k = 0; k < exposuresOfBlur; ++k) {
    if (k == exposuresOfBlur / 2) continue;
    const double share = (k + 0.5) / exposuresOfBlur - 0.5;
    const YardShot part = m_yard.shootAt(time + share * m_options.blur / Yard::rate);
    for (std::size_t eye = 0; eye < sums.size(); ++eye) {
      if (sums[eye].empty()) continue;
      cv::add(sums[eye], part.eyes[eye].colour, sums[eye], cv::noArray(), CV_16U);
    }
  }
  for (std::size_t eye = 0; eye < sums.size(); ++eye) {
    if (!sums[eye].empty()) {
      sums[eye].convertTo(shot.eyes[eye].colour, CV_8U, 1.0 / exposuresOfBlur);
    }
  }
}

cv::Mat YardSource::measured(const YardTruth& truth, std::size_t index) const {
  cv::Mat depth = truth.depth.clone();
  if (m_options.depthNoise > 0.0) {
    addDepthNoise(depth, m_options.depthNoise, truth.depthTimesDisparity,
                  depthNoiseStream(m_options.seed, index));
  }
  if (m_options.as == YardView::Depth) roundToMillimetres(depth);
  return depth;
}

}  // namespace boomwatch
