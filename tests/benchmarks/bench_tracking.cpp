// Our TLD against OpenCV's on a rendered sequence: a textured target that moves, turns and grows
// before a textured wall.
#include <opencv2/tracking.hpp>

#include <opencv2/imgproc.hpp>
#include <opencv2/tracking/tracking_legacy.hpp>
#include <vector>

#include "benchmark.h"
#include "tracking/tld_tracker.h"

namespace bench = boomwatch::bench;

namespace {

cv::Mat texture(cv::Size size, double grain, unsigned seed) {
  cv::Mat noise(size, CV_8UC3);
  cv::RNG(seed).fill(noise, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(noise, noise, {}, grain);
  cv::normalize(noise, noise, 0, 255, cv::NORM_MINMAX);
  return noise;
}

constexpr int side = 60;

std::vector<cv::Mat> pictures(int count) {
  const cv::Mat wall = texture({640, 480}, 3.0, 1);
  const cv::Mat target = texture({side, side}, 1.5, 2);
  std::vector<cv::Mat> images;
  for (int frame = 0; frame < count; ++frame) {
    cv::Mat turn =
        cv::getRotationMatrix2D({side / 2.0F, side / 2.0F}, 0.2 * frame, 1.0 + 0.002 * frame);
    turn.at<double>(0, 2) += 100.0 + 2.0 * frame;
    turn.at<double>(1, 2) += 150.0 + 1.0 * frame;
    images.push_back(wall.clone());
    cv::warpAffine(target, images.back(), turn, wall.size(), cv::INTER_LINEAR,
                   cv::BORDER_TRANSPARENT);
  }
  return images;
}

}  // namespace

int main() {
  constexpr int frames = 40;
  const std::vector<cv::Mat> images = pictures(frames);
  const cv::Rect2d box(100.0, 150.0, side, side);
  const double ours = bench::medianMilliseconds(3, [&] {
    boomwatch::TldTracker tracker;
    tracker.start(images.front(), box);
    for (int i = 1; i < frames; ++i) tracker.track(images[static_cast<std::size_t>(i)]);
  });
  const double theirs = bench::medianMilliseconds(3, [&] {
    const auto tracker = cv::legacy::TrackerTLD::create();
    tracker->init(images.front(), box);
    cv::Rect2d found;
    for (int i = 1; i < frames; ++i) tracker->update(images[static_cast<std::size_t>(i)], found);
  });
  bench::print("tld_frame", ours / (frames - 1), "ms", "-");
  bench::print("tld_faster_than_opencv", theirs / ours, "times", ">=2");
}
