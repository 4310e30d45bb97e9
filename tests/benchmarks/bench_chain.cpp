// The whole chain with a tracker on a stereo pair of the thesis's size, against OpenCV's matcher
// alone on the same pictures: what is left is everything but stereo matching.
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "base/freed_memory.h"
#include "benchmark.h"
#include "frame/stereo_rig.h"
#include "parameters/parameter_table.h"
#include "parameters/parameter_text.h"
#include "pipeline/pipeline.h"

namespace bench = boomwatch::bench;
using boomwatch::Frame;
using boomwatch::FramePtr;
using boomwatch::StereoRig;

namespace {

constexpr int width = 768;
constexpr int height = 576;
constexpr double focal = 700.0;
constexpr int frames = 40;
constexpr int warmUp = 8;  // the model is known, the tracker has begun
const cv::Size toolSize(60, 80);

cv::Mat texture(cv::Size size, std::uint64_t seed) {
  cv::Mat coarse(size / 4, CV_8UC1), fine;
  cv::RNG(seed).fill(coarse, cv::RNG::UNIFORM, 0, 255);
  cv::resize(coarse, fine, size, 0, 0, cv::INTER_CUBIC);
  return fine;
}

std::shared_ptr<const StereoRig> rig() {
  auto made = std::make_shared<StereoRig>();
  made->imageSize = {width, height};
  made->leftMatrix = made->rightMatrix = {focal, 0, width / 2.0, 0, focal, height / 2.0, 0, 0, 1};
  made->translation = {-0.3, 0, 0};
  made->rectified = true;
  return made;
}

/// What a camera sees of a floor from 10 m (top) to 4 m (bottom), as the right one sees it too.
cv::Mat seenFromTheRight(const cv::Mat& left) {
  cv::Mat x(left.size(), CV_32FC1), y(left.size(), CV_32FC1), right;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      x.at<float>(row, column) =
          static_cast<float>(column) + 20.0F + 30.0F * static_cast<float>(row) / height;
      y.at<float>(row, column) = static_cast<float>(row);
    }
  }
  cv::remap(left, right, x, y, cv::INTER_LINEAR, cv::BORDER_REFLECT);
  return right;
}

cv::Rect toolAt(int frame) { return {{300 + 3 * frame, 200 + frame}, toolSize}; }

/// A tool 3.5 m away goes across the picture; a little noise, as every camera has.
std::vector<FramePtr> recording() {
  const cv::Mat floor = texture({width, height}, 1), tool = texture(toolSize, 2);
  const cv::Mat right = seenFromTheRight(floor);
  const auto both = rig();
  std::vector<FramePtr> made;
  for (int k = 0; k < frames; ++k) {
    auto frame = std::make_shared<Frame>();
    frame->sequence = static_cast<std::uint64_t>(k);
    frame->stamp = k / 20.0;
    frame->left = floor.clone();
    frame->right = right.clone();
    tool.copyTo(frame->left(toolAt(k)));
    tool.copyTo(frame->right(toolAt(k) - cv::Point(60, 0)));
    frame->rig = both;
    cv::RNG random(static_cast<std::uint64_t>(k) + 3);
    for (cv::Mat* image : {&frame->left, &frame->right}) {
      cv::Mat noise(image->size(), CV_8UC1);
      random.fill(noise, cv::RNG::UNIFORM, 0, 4);
      *image += noise;
    }
    made.push_back(frame);
  }
  return made;
}

double median(std::vector<double> times) {
  std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
  return times[times.size() / 2];
}

double milliseconds(std::chrono::steady_clock::duration time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

/// One frame of the chain beside one match by OpenCV alone, again and again.
void compare(const std::string& tracker, const std::vector<FramePtr>& recorded) {
  boomwatch::Parameters parameters;
  if (!tracker.empty()) boomwatch::setParameter(parameters, "tracker", tracker);
  parameters.load.source = boomwatch::LoadSource::Manual;
  parameters.load.z = 3.5;
  boomwatch::Pipeline pipeline;
  if (!tracker.empty()) pipeline.order(boomwatch::TrackBox{cv::Rect2d(toolAt(0))});
  const int block = parameters.stereo.blockSize, area = block * block;
  const auto peer = cv::StereoSGBM::create(
      0, parameters.stereo.disparities, block, 8 * area, 32 * area, parameters.stereo.consistency,
      parameters.stereo.preFilterCap, parameters.stereo.uniqueness, parameters.stereo.speckleWindow,
      parameters.stereo.speckleRange, cv::StereoSGBM::MODE_SGBM_3WAY);
  std::vector<double> chain, match;
  int seen = 0;
  for (const FramePtr& frame : recorded) {
    const auto start = std::chrono::steady_clock::now();
    const boomwatch::Result result = pipeline.process(frame, parameters);
    const auto between = std::chrono::steady_clock::now();
    cv::Mat disparity;
    peer->compute(frame->left, frame->right, disparity);
    const auto end = std::chrono::steady_clock::now();
    if (result.tool.box) ++seen;
    if (frame->sequence < warmUp) continue;
    chain.push_back(milliseconds(between - start));
    match.push_back(milliseconds(end - between));
  }
  const std::string name = "chain_" + (tracker.empty() ? "no_tracker" : tracker);
  const double rest = median(chain) - median(match);
  bench::print((name + "_frame").c_str(), median(chain), "ms", "-");
  bench::print((name + "_sgbm_alone").c_str(), median(match), "ms", "-");
  bench::print((name + "_without_matching").c_str(), rest, "ms", "<=30");
  bench::print((name + "_without_matching_over_sgbm").c_str(), rest / median(match), "x", "<=1");
  if (!tracker.empty()) bench::print((name + "_seen").c_str(), 100.0 * seen / frames, "%", ">=90");
}

}  // namespace

int main() {
  boomwatch::keepFreedMemory();  // as the program does; the peer has it, too
  const auto recorded = recording();
  for (const char* tracker : {"", "tld", "klt", "cmt", "csrt"}) compare(tracker, recorded);
  return 0;
}
