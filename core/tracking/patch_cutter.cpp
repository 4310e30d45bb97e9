#include "tracking/patch_cutter.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tracking/tld_tuning.h"

namespace boomwatch {
namespace {

constexpr TldTuning tuning;

}  // namespace

PatchCutter::PatchCutter(const cv::Mat& grey, const cv::Rect2d& box, cv::Size patch)
    : m_patch(patch) {
  const cv::Size2d border(box.width * tuning.cutMargin, box.height * tuning.cutMargin);
  const cv::Point first(cvFloor(box.x - border.width), cvFloor(box.y - border.height));
  const cv::Point last(cvCeil(box.x + box.width + border.width),
                       cvCeil(box.y + box.height + border.height));
  const cv::Rect wanted(first, last);
  const cv::Rect there = wanted & cv::Rect(cv::Point(), grey.size());
  cv::Mat around;
  if (there.empty()) {
    around = cv::Mat::zeros(wanted.size(), CV_8UC1);
  } else {
    cv::copyMakeBorder(grey(there), around, there.y - wanted.y, wanted.br().y - there.br().y,
                       there.x - wanted.x, wanted.br().x - there.br().x, cv::BORDER_REPLICATE);
  }
  const double scaleX = tuning.oversampling * patch.width / box.width;
  const double scaleY = tuning.oversampling * patch.height / box.height;
  const cv::Size size(std::max(1, cvRound(wanted.width * scaleX)),
                      std::max(1, cvRound(wanted.height * scaleY)));
  cv::resize(around, m_around, size, 0.0, 0.0, scaleX < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
  // 2 x 2 pixels of these are one of the patch, which ScanLevels smooths by 1 2 1.
  cv::GaussianBlur(m_around, m_around, cv::Size(0, 0), tuning.cutBlur);
  m_centre = {(box.x + box.width / 2.0 - wanted.x) * size.width / wanted.width,
              (box.y + box.height / 2.0 - wanted.y) * size.height / wanted.height};
}

cv::Mat PatchCutter::cut(const Warp& warp) const {
  const double cosine = std::cos(warp.angle) * warp.scale * tuning.oversampling;
  const double sine = std::sin(warp.angle) * warp.scale * tuning.oversampling;
  const cv::Point2d centre(m_centre.x + warp.shift.x * m_patch.width * tuning.oversampling,
                           m_centre.y + warp.shift.y * m_patch.height * tuning.oversampling);
  // Pixel centres lie at halves.
  const double column = m_patch.width / 2.0 - 0.5;
  const double row = m_patch.height / 2.0 - 0.5;
  const cv::Matx23d toAround(cosine, -sine, centre.x - 0.5 - cosine * column + sine * row,  //
                             sine, cosine, centre.y - 0.5 - sine * column - cosine * row);
  cv::Mat patch;
  cv::warpAffine(m_around, patch, toAround, m_patch, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                 cv::BORDER_REPLICATE);
  return patch;
}

Eigen::VectorXf normalised(const cv::Mat& patch) {
  Eigen::VectorXf values(static_cast<Eigen::Index>(patch.total()));
  Eigen::Index next = 0;
  for (int row = 0; row < patch.rows; ++row) {
    const uchar* pixels = patch.ptr(row);
    for (int column = 0; column < patch.cols; ++column) values[next++] = pixels[column];
  }
  values.array() -= values.mean();
  const float length = values.norm();
  if (length > 0.0F) values /= length;
  return values;
}

double varianceOf(const cv::Mat& patch) {
  cv::Scalar mean, deviation;
  cv::meanStdDev(patch, mean, deviation);
  return deviation[0] * deviation[0];
}

}  // namespace boomwatch
