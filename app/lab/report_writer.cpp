#include "lab/report_writer.h"

#include <QBrush>
#include <QBuffer>
#include <QImage>
#include <variant>

#include "chart.h"
#include "report/text_table.h"

namespace boomwatch {
namespace {

void writePng(const std::filesystem::path& file, const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  writeBytes(file, {reinterpret_cast<const std::uint8_t*>(bytes.constData()),
                    static_cast<std::size_t>(bytes.size())});
}

/// Every sample of every line, for those who want to draw it themselves.
std::string csvOf(const Figure& figure) {
  const Cells heading{"series", figure.x.title, figure.y.title};
  std::string text = csvLine(heading);
  for (const Series& series : figure.series) {
    for (const Sample& sample : series.samples) {
      const Cells row{series.name, fixedText(sample.x, 6), fixedText(sample.y, 6)};
      text += csvLine(row);
    }
  }
  return text;
}

}  // namespace

ReportWriter::ReportWriter(const PartialFolder& folder, const std::string& title)
    : m_folder(folder), m_text("# " + title + "\n") {}

void ReportWriter::add(const std::string& paragraph) {
  m_text.append("\n").append(paragraph).append("\n");
}

void ReportWriter::addPicture(const std::string& name, const std::string& file) {
  m_text.append("\n![").append(name).append("](").append(file).append(".png)\n");
}

void ReportWriter::add(const Chapter& chapter) {
  m_text.append("\n## ").append(chapter.title).append("\n");
  for (const auto& item : chapter.items) {
    std::visit([this](const auto& known) { add(known); }, item);
  }
}

void ReportWriter::add(const Table& table) {
  std::string csv = csvLine(table.headings);
  for (const Cells& row : table.rows) csv += csvLine(row);
  const std::string file = table.file + ".csv";
  writeText(m_folder.path() / file, csv);
  m_text.append("\n").append(table.caption).append(" ");
  m_text.append("([").append(file).append("](").append(file).append("))\n");
  if (!table.inReport) return;
  m_text.append("\n").append(markdownLine(table.headings));
  m_text += markdownRule(table.headings.size(), table.texts);
  for (const Cells& row : table.rows) m_text += markdownLine(row);
}

void ReportWriter::add(const Figure& figure) {
  writePng(m_folder.path() / (figure.file + ".png"), chartImage(figure));
  writeText(m_folder.path() / (figure.file + "_figure.csv"), csvOf(figure));
  addPicture(figure.title, figure.file);
}

void ReportWriter::add(const Picture& picture) {
  const cv::Mat& grey = picture.image;
  const QImage image(grey.data, grey.cols, grey.rows, static_cast<qsizetype>(grey.step),
                     QImage::Format_Grayscale8);
  writePng(m_folder.path() / (picture.file + ".png"), image);
  addPicture(picture.caption, picture.file);
  add(picture.caption);
}

void ReportWriter::close() const { writeText(m_folder.path() / "report.md", m_text); }

}  // namespace boomwatch
