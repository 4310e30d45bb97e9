#pragma once

#include <string>

#include "report/chapter.h"
#include "report/partial_folder.h"

namespace boomwatch {

/// Writes chapters as a report: Markdown, with figures as PNG and tables as CSV beside it.
/// Everything throws std::runtime_error, naming the file, when it cannot be written.
class ReportWriter {
 public:
  ReportWriter(const PartialFolder& folder, const std::string& title);

  /// Paragraphs before the first chapter.
  void add(const std::string& paragraph);
  /// Its tables and figures are written at once.
  void add(const Chapter& chapter);
  /// Writes report.md.
  void close() const;

 private:
  void add(const Table& table);
  void add(const Figure& figure);
  void add(const Picture& picture);
  void addPicture(const std::string& name, const std::string& file);

  const PartialFolder& m_folder;
  std::string m_text;
};

}  // namespace boomwatch
