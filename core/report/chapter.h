#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <variant>
#include <vector>

#include "report/figure.h"
#include "report/text_table.h"

namespace boomwatch {

/// Rows as the report and a CSV file show them.
struct Table {
  std::string file;     ///< name without extension
  std::string caption;  ///< a sentence
  Cells headings;
  std::vector<Cells> rows;
  std::size_t texts = 1;  ///< the first columns, which are words; the others are numbers
  bool inReport = true;   ///< false: long, and only a file
};

/// A picture as it is, CV_8UC1.
struct Picture {
  std::string file;  ///< name without extension
  std::string caption;
  cv::Mat image;
};

/// What one experiment found, in the order in which it is to be read. Strings are paragraphs of
/// Markdown.
struct Chapter {
  std::string title;
  std::vector<std::variant<std::string, Table, Figure, Picture>> items;
};

}  // namespace boomwatch
