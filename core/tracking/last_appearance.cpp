#include "tracking/last_appearance.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tracking/detection.h"
#include "tracking/last_appearance_tuning.h"
#include "tracking/patch_cutter.h"

namespace boomwatch {
namespace {

constexpr LastAppearanceTuning tuning;

cv::Rect2d withRim(const cv::Rect2d& box) {
  return {box.x - tuning.rim * box.width, box.y - tuning.rim * box.height,
          (1 + 2 * tuning.rim) * box.width, (1 + 2 * tuning.rim) * box.height};
}

double correlation(const cv::Mat& image, const cv::Mat& patch) {
  cv::Mat fit;
  double best = -1.0;
  cv::matchTemplate(image, patch, fit, cv::TM_CCOEFF_NORMED);
  cv::minMaxLoc(fit, nullptr, &best);
  return best;
}

}  // namespace

void LastAppearance::remember(const cv::Mat& grey, const cv::Rect2d& box) {
  const cv::Rect seen = cv::Rect(withRim(box)) & cv::Rect({}, grey.size());
  const double scale = std::min(1.0, tuning.side / std::sqrt(withRim(box).area()));
  const cv::Size size(cvRound(seen.width * scale), cvRound(seen.height * scale));
  const double shown = (box & cv::Rect2d(seen)).area();
  if (std::min(size.width, size.height) < tuning.minPatch || shown < tuning.minShown * box.area()) {
    return;
  }
  cv::Mat patch;
  cv::resize(grey(seen), patch, size, 0.0, 0.0, cv::INTER_AREA);
  if (varianceOf(patch) < tuning.minVariance) return;
  m_patch = patch;
  m_scale = scale;
  m_tool = {(box.x - seen.x) * scale, (box.y - seen.y) * scale, box.width * scale,
            box.height * scale};
}

LastAppearance::Level LastAppearance::levelOf(const cv::Mat& grey, double size) const {
  Level level;
  level.scale = m_scale / size;
  const cv::Size scaled(cvRound(grey.cols * level.scale), cvRound(grey.rows * level.scale));
  if (scaled.width < m_patch.cols || scaled.height < m_patch.rows) return level;
  cv::resize(grey, level.image, scaled, 0.0, 0.0,
             level.scale < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
  cv::matchTemplate(level.image, m_patch, level.fit, cv::TM_CCOEFF_NORMED);
  return level;
}

/// Correlation of the tool without its rim; the patch lies at `at`, to a pixel.
double LastAppearance::toolAlone(const cv::Mat& image, cv::Point at) const {
  const cv::Rect tool = cv::Rect(m_tool) & cv::Rect({}, m_patch.size());
  const cv::Rect around(tool.tl() + at - cv::Point(1, 1), tool.size() + cv::Size(2, 2));
  const cv::Rect region = around & cv::Rect({}, image.size());
  if (tool.empty() || region.width < tool.width || region.height < tool.height) return -1.0;
  return correlation(image(region), m_patch(tool));
}

std::optional<LastAppearance::Place> LastAppearance::bestOf(
    const std::vector<Level>& levels) const {
  std::optional<Place> best;
  cv::Rect2d whole;  // tool and rim
  for (const Level& level : levels) {
    if (level.fit.empty()) continue;
    double likeness = 0.0;
    cv::Point at;
    cv::minMaxLoc(level.fit, nullptr, &likeness, nullptr, &at);
    if (best && likeness <= best->likeness) continue;
    const double pixel = 1.0 / level.scale;
    best = Place{{(at.x + m_tool.x) * pixel, (at.y + m_tool.y) * pixel, m_tool.width * pixel,
                  m_tool.height * pixel},
                 likeness,
                 -1.0,
                 toolAlone(level.image, at)};
    whole = {at.x * pixel, at.y * pixel, m_patch.cols * pixel, m_patch.rows * pixel};
  }
  if (!best) return std::nullopt;
  for (const Level& level : levels) {
    if (level.fit.empty()) continue;
    // Upper left corners of all patches that cover at least half of the best place.
    const cv::Rect near(cvRound(whole.x * level.scale) - m_patch.cols / 2,
                        cvRound(whole.y * level.scale) - m_patch.rows / 2, m_patch.cols,
                        m_patch.rows);
    cv::Mat elsewhere(level.fit.size(), CV_8UC1, cv::Scalar(255));
    elsewhere(near & cv::Rect({}, level.fit.size())).setTo(0);
    double likeness = -1.0;
    if (cv::countNonZero(elsewhere) > 0) {
      cv::minMaxLoc(level.fit, nullptr, &likeness, nullptr, nullptr, elsewhere);
    }
    best->second = std::max(best->second, likeness);
  }
  return best;
}

std::optional<cv::Rect2d> LastAppearance::find(const cv::Mat& grey) {
  if (m_patch.empty()) return std::nullopt;
  std::vector<Level> levels;
  levels.reserve(std::size(tuning.sizes));
  for (const double size : tuning.sizes) levels.push_back(levelOf(grey, size));
  const std::optional<Place> best = bestOf(levels);
  if (!best) return std::nullopt;
  const bool back =
      m_maxLikeness && best->toolAlone >= tuning.alike &&
      best->likeness >=
          std::max(tuning.alike, std::max(best->second, *m_maxLikeness) + tuning.lead);
  m_recent.push_back(best->likeness);
  if (m_recent.size() > tuning.comesBackIn) {
    m_maxLikeness = std::max(m_maxLikeness.value_or(-1.0), m_recent.front());
    m_recent.pop_front();
  }
  const bool twice = back && m_last && overlap(m_last->box, best->box) >= tuning.samePlace;
  m_last = back ? best : std::nullopt;
  return twice ? std::optional(best->box) : std::nullopt;
}

bool LastAppearance::recognises(const cv::Mat& grey, const cv::Rect2d& box) const {
  if (m_patch.empty()) return false;
  const double pixel = box.width / m_tool.width;  // image pixels per patch pixel
  const cv::Rect2d whole(box.x - m_tool.x * pixel, box.y - m_tool.y * pixel, m_patch.cols * pixel,
                         m_patch.rows * pixel);
  const cv::Rect seen(whole);
  if ((seen & cv::Rect({}, grey.size())) != seen || seen.empty()) return false;
  cv::Mat now;
  cv::resize(grey(seen), now, m_patch.size(), 0.0, 0.0, cv::INTER_AREA);
  return correlation(now, m_patch) >= tuning.alike && toolAlone(now, {}) >= tuning.alike;
}

}  // namespace boomwatch
