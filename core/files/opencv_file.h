#pragma once

#include <filesystem>
#include <map>
#include <opencv2/core.hpp>
#include <string>

namespace boomwatch {

/// The numbers and matrices at the top of a file as OpenCV's FileStorage writes it.
struct OpencvFile {
  std::map<std::string, double> numbers;
  std::map<std::string, cv::Mat> matrices;  ///< CV_64FC1
};

/// Reads YAML, XML (by the extension .xml) or JSON. What is neither a number nor a matrix of one
/// channel, and matrices whose `data` is not `rows` times `cols` long, are left out.
///
/// cv::FileStorage is not used: OpenCV 4.6 ends the program on some damaged XML files and allocates
/// what `rows` and `cols` claim. Throws Error naming the file (and line) when it cannot be parsed.
OpencvFile readOpencvFile(const std::filesystem::path& file);

}  // namespace boomwatch
