#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace boomwatch {

/// "768 x 576", as messages about pictures say it.
inline std::string sizeText(cv::Size size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

}  // namespace boomwatch
