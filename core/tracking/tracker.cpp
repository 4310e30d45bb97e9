#include "tracking/tracker.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "base/error.h"
#include "base/size_text.h"

namespace boomwatch {
namespace {

std::string boxText(const cv::Rect2d& box) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "tool box " << box.x << "," << box.y << "," << box.width << "," << box.height;
  return text.str();
}

}  // namespace

std::string_view toString(TrackState state) {
  switch (state) {
    case TrackState::Idle:
      return "idle";
    case TrackState::Tracked:
      return "tracked";
    case TrackState::Refound:
      return "refound";
    case TrackState::Lost:
      return "lost";
  }
  return "";
}

std::string_view toString(LearningState state) {
  switch (state) {
    case LearningState::None:
      return "none";
    case LearningState::Off:
      return "off";
    case LearningState::On:
      return "on";
    case LearningState::Suspended:
      return "suspended";
  }
  return "";
}

void Tracker::start(const ToolModel&) {
  throw Error("tracker", "this kind keeps no model of the tool",
              "Set tracker to tld, or begin with a box.");
}

bool isTrackable(const cv::Mat& image) {
  return !image.empty() && (image.type() == CV_8UC1 || image.type() == CV_8UC3);
}

void requireStart(const cv::Mat& image, const cv::Rect2d& box) {
  if (!isTrackable(image)) {
    throw Error("tool box", "there is no picture to find it in",
                "Open a source with a picture first.");
  }
  const bool finite = std::isfinite(box.x) && std::isfinite(box.y) && std::isfinite(box.width) &&
                      std::isfinite(box.height);
  if (!finite || !(box.width >= Tracker::minSide && box.height >= Tracker::minSide)) {
    throw Error(boxText(box), "it is smaller than 8 x 8 pixels",
                "Draw a box that encloses the tool.");
  }
  if (box.x < 0.0 || box.y < 0.0 || box.x + box.width > image.cols ||
      box.y + box.height > image.rows) {
    throw Error(boxText(box), "it reaches outside the picture of " + sizeText(image.size()),
                "Draw it inside.");
  }
}

cv::Mat greyOf(const cv::Mat& image) {
  if (image.type() == CV_8UC1) return image;
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

}  // namespace boomwatch
