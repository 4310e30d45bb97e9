#include "files/opencv_file.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <boost/property_tree/xml_parser.hpp>
#include <sstream>

#include "base/error.h"
#include "files/file_bytes.h"
#include "files/line_reader.h"

namespace boomwatch {
namespace {

constexpr std::size_t maxFile = 1 << 20;
constexpr std::ptrdiff_t maxTags = 5000;  // Boost's parser takes stack for every nested one
constexpr const char* remedy = "Write the file anew as OpenCV's YAML or XML.";

void addMatrix(const std::string& name, std::string_view rowsText, std::string_view columnsText,
               const std::vector<std::string_view>& data, OpencvFile& result) {
  const auto rows = toNumber<int>(rowsText), columns = toNumber<int>(columnsText);
  if (!rows || !columns || *rows < 1 || *columns < 1) return;
  if (static_cast<double>(*rows) * *columns != static_cast<double>(data.size())) return;
  cv::Mat matrix(*rows, *columns, CV_64FC1);
  for (std::size_t k = 0; k < data.size(); ++k) {
    const auto value = toNumber<double>(data[k]);
    if (!value) return;
    matrix.ptr<double>()[k] = *value;
  }
  result.matrices[name] = matrix;
}

void addNumber(const std::string& name, std::string_view text, OpencvFile& result) {
  const auto parts = words(text);
  const auto value = parts.size() == 1 ? toNumber<double>(parts[0]) : std::nullopt;
  if (value) result.numbers[name] = *value;
}

void addYaml(const std::string& name, const YAML::Node& value, OpencvFile& result) {
  if (value.IsScalar()) addNumber(name, value.Scalar(), result);
  if (!value.IsMap()) return;
  const YAML::Node rows = value["rows"], columns = value["cols"], data = value["data"];
  if (!rows || !columns || !data || !rows.IsScalar() || !columns.IsScalar()) return;
  std::vector<std::string_view> texts;
  if (!data.IsSequence()) return;
  for (const YAML::Node& number : data) {
    if (!number.IsScalar()) return;
    texts.push_back(number.Scalar());
  }
  addMatrix(name, rows.Scalar(), columns.Scalar(), texts, result);
}

OpencvFile parseYaml(const std::string& text, const std::string& where) {
  OpencvFile result;
  try {
    const YAML::Node root = YAML::Load(text);
    if (!root.IsMap()) throw Error(where, "it holds no keys", remedy);
    for (const auto& entry : root) {
      if (entry.first.IsScalar()) addYaml(entry.first.Scalar(), entry.second, result);
    }
  } catch (const YAML::Exception& fault) {
    const std::string line =
        fault.mark.is_null() ? "" : ", line " + std::to_string(fault.mark.line + 1);
    throw Error(where + line, "not YAML: " + fault.msg, remedy);
  }
  return result;
}

OpencvFile parseXml(const std::string& text, const std::string& where) {
  if (std::ranges::count(text, '<') > maxTags) throw Error(where, "it has too many tags", remedy);
  OpencvFile result;
  boost::property_tree::ptree tree;
  try {
    std::istringstream stream(text);
    boost::property_tree::read_xml(stream, tree);
  } catch (const boost::property_tree::xml_parser_error& fault) {
    throw Error(where + ", line " + std::to_string(fault.line()), "not XML: " + fault.message(),
                remedy);
  }
  const auto root = tree.get_child_optional("opencv_storage");
  if (!root) throw Error(where, "it has no tag 'opencv_storage'", remedy);
  for (const auto& [name, value] : *root) {
    addNumber(name, value.data(), result);
    std::string data = value.get<std::string>("data", "");
    std::ranges::replace(data, '\n', ' ');
    const auto rows = value.get<std::string>("rows", "");
    const auto columns = value.get<std::string>("cols", "");
    addMatrix(name, rows, columns, words(data), result);
  }
  return result;
}

}  // namespace

OpencvFile readOpencvFile(const std::filesystem::path& file) {
  const std::string text = readFileBytes(file, maxFile);
  const bool isXml = file.extension() == ".xml";
  return isXml ? parseXml(text, file.string()) : parseYaml(text, file.string());
}

}  // namespace boomwatch
