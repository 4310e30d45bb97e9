#include "stereo/row_alignment.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "base/median.h"
#include "base/point_flow.h"

namespace boomwatch {
namespace {

// A calibration that is worse than this gives no disparities to begin at.
constexpr double maxRows = 8.0;
constexpr std::size_t minMatches = 60;
constexpr double maxTurn = std::numbers::pi / 180.0;
// A factory's focal lengths drift apart by a thousandth or so as the cameras warm. Rows show that
// less well than they show a turn, so it is held to what is likely, as if only `minMatches`
// were independent of each other.
constexpr double likelyFocal = 0.001;
constexpr double rowNoise = 0.3;

/// What a turn by (about x, about z) and a longer focal length do to the row of a right ray, to
/// first order, pixels; then what may be mistaken for it: a turn about y.
cv::Vec4d rowPer(const RowMatch& match, const cv::Matx33d& camera) {
  const double f = camera(1, 1);
  const double x = (match.right.x - camera(0, 2)) / camera(0, 0);
  const double y = (match.right.y - camera(1, 2)) / f;
  return {-f * (1.0 + y * y), f * x, f * y, f * x * y};
}

double rowsApart(const RowMatch& match) { return match.right.y - match.left.y; }

/// Least squares of the rows by those four, without matches that are off by more than three times
/// the median.
cv::Vec4d fitted(const std::vector<RowMatch>& matches, const cv::Matx33d& camera) {
  cv::Vec4d terms = cv::Vec4d::all(0.0);
  for (int round = 0; round < 10; ++round) {
    std::vector<double> rest;
    for (const RowMatch& m : matches) {
      rest.push_back(std::abs(rowsApart(m) - rowPer(m, camera).dot(terms)));
    }
    const double scale = std::max(3.0 * medianOf(std::vector(rest)), 0.05);
    cv::Matx44d normal = cv::Matx44d::eye() * 1e-6;
    const double alike = static_cast<double>(matches.size()) / minMatches;
    normal(2, 2) = alike * rowNoise * rowNoise / (likelyFocal * likelyFocal);
    cv::Vec4d sum = cv::Vec4d::all(0.0);
    for (std::size_t k = 0; k < matches.size(); ++k) {
      if (rest[k] > scale) continue;
      const cv::Vec4d row = rowPer(matches[k], camera);
      normal += row * row.t();
      sum += rowsApart(matches[k]) * row;
    }
    terms = normal.solve(sum, cv::DECOMP_CHOLESKY);
  }
  return terms;
}

std::vector<cv::Point2f> cornersWithDisparity(const cv::Mat& left, const cv::Mat& disparity) {
  constexpr int most = 500;
  constexpr int apart = 12;
  std::vector<cv::Point2f> corners;
  cv::goodFeaturesToTrack(left, corners, most, 0.01, apart, disparity == disparity);
  return corners;
}

}  // namespace

std::vector<RowMatch> matchRows(const cv::Mat& left, const cv::Mat& right,
                                const cv::Mat& disparity) {
  const std::vector<cv::Point2f> corners = cornersWithDisparity(left, disparity);
  std::vector<RowMatch> matches;
  if (corners.empty()) return matches;
  std::vector<cv::Point2f> guess = corners;
  for (cv::Point2f& p : guess) p.x -= disparity.at<float>(cvRound(p.y), cvRound(p.x));
  const FlowSearch search{
      {15, 15}, 1, {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 30, 0.005}};
  for (const FollowedPoint& point : followPoints(left, right, corners, search, guess)) {
    const cv::Point2f corner = corners[point.index];
    if (!(point.error < 0.2)) continue;
    if (std::abs(point.position.x - guess[point.index].x) > 2.0F) continue;
    if (std::abs(point.position.y - corner.y) > maxRows) continue;
    matches.push_back({corner, point.position});
  }
  return matches;
}

bool RowFit::worthwhile() const {
  constexpr double minGain = 0.2;
  cv::Vec3d angles;
  cv::Rodrigues(turn, angles);
  return residue - remaining > minGain && cv::norm(angles) < maxTurn;
}

std::optional<RowFit> fitRows(const std::vector<RowMatch>& matches, const cv::Matx33d& camera) {
  if (matches.size() < minMatches) return std::nullopt;
  const cv::Vec4d terms = fitted(matches, camera);
  const cv::Vec4d applied(terms[0], terms[1], terms[2], 0.0);
  std::vector<double> before, after;
  for (const RowMatch& match : matches) {
    before.push_back(std::abs(rowsApart(match)));
    after.push_back(std::abs(rowsApart(match) - rowPer(match, camera).dot(applied)));
  }
  RowFit fit{medianOf(before), medianOf(after)};
  cv::Rodrigues(cv::Vec3d(-terms[0], 0.0, -terms[1]), fit.turn);
  fit.focal = 1.0 + terms[2];
  return fit;
}

void RowAlignment::look(const cv::Mat& left, const cv::Mat& right, const cv::Mat& disparity,
                        const cv::Matx33d& camera) {
  if (done()) return;
  const std::vector<RowMatch> matches = matchRows(left, right, disparity);
  m_matches.insert(m_matches.end(), matches.begin(), matches.end());
  if (++m_frames < frames) return;
  m_fit = fitRows(m_matches, camera);
  m_matches = {};
}

}  // namespace boomwatch
