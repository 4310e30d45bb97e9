#include "tracking/picture_halves.h"

#include <opencv2/imgproc.hpp>

namespace boomwatch {

cv::Mat PictureHalves::resized(cv::Size size) {
  std::size_t i = 0;
  while (size.width * 2 <= m_halves[i].cols && size.height * 2 <= m_halves[i].rows) {
    if (++i < m_halves.size()) continue;
    cv::Mat half;
    cv::resize(m_halves.back(), half, m_halves.back().size() / 2, 0.0, 0.0, cv::INTER_AREA);
    m_halves.push_back(half);
  }
  cv::Mat result;
  cv::resize(m_halves[i], result, size, 0.0, 0.0, cv::INTER_LINEAR);
  return result;
}

}  // namespace boomwatch
