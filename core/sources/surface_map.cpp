#include "sources/surface_map.h"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "base/error.h"
#include "files/bounded_image.h"
#include "files/file_bytes.h"
#include "files/line_reader.h"

namespace boomwatch {
namespace {

constexpr std::size_t maxGridFile = 256U << 20;
constexpr std::size_t maxDescription = 1U << 20;
constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
constexpr double standsAbove = 10.0;  ///< metres, unless a camera height is given

/// Values as stored, and how large a cell is where the file says so.
struct RawGrid {
  cv::Mat values;  ///< CV_32FC1, NaN: not known
  std::optional<double> cell;
};

/// The lines of an ESRI ASCII grid before its values: names (in small letters) and numbers.
std::map<std::string, double> readGridHeader(LineReader& lines, const std::string& name) {
  std::map<std::string, double> header;
  LineReader ahead = lines;
  while (const auto line = ahead.next()) {
    const auto found = words(*line);
    if (found.empty() || toNumber<double>(found[0])) break;
    const auto value = found.size() == 2 ? toNumber<double>(found[1]) : std::nullopt;
    if (!value) {
      throw Error(name + ", line " + std::to_string(ahead.lineNumber()), "not a name and a number",
                  "Give an ESRI ASCII grid.");
    }
    header[lower(found[0])] = *value;
    lines = ahead;
  }
  return header;
}

RawGrid readAsciiGrid(const std::filesystem::path& file) {
  const std::string name = file.string();
  const std::string text = readFileBytes(file, maxGridFile);
  LineReader lines(text);
  const auto header = readGridHeader(lines, name);
  const auto number = [&](const char* key, double low, double high) {
    const auto found = header.find(key);
    if (found == header.end() || !(found->second >= low && found->second <= high)) {
      throw Error(name, std::string("'") + key + "' is missing or out of range",
                  "Give an ESRI ASCII grid: ncols, nrows, cellsize, then the values.");
    }
    return found->second;
  };
  const double columns = number("ncols", 1, 1e5), rows = number("nrows", 1, 1e5);
  // A value takes two characters at least: what the file claims, it must be able to hold.
  if (columns * rows > static_cast<double>(text.size()) || columns * rows > maxImage) {
    throw Error(name, "it is too short for ncols times nrows values", "Check the file.");
  }
  const auto noData = header.find("nodata_value");
  RawGrid grid{cv::Mat(static_cast<int>(rows), static_cast<int>(columns), CV_32FC1),
               number("cellsize", 1e-4, 1e5)};
  auto* next = grid.values.ptr<float>();
  float* const end = next + grid.values.total();
  while (const auto line = lines.next()) {
    for (const std::string_view word : words(*line)) {
      const auto value = toNumber<double>(word);
      if (!value || next == end) {
        throw Error(name + ", line " + std::to_string(lines.lineNumber()),
                    next == end ? "there are more than ncols times nrows values"
                                : "'" + std::string(word.substr(0, 40)) + "' is not a number",
                    "Check the file.");
      }
      const bool known = noData == header.end() || *value != noData->second;
      *next++ = known ? static_cast<float>(*value) : unknown;
    }
  }
  if (next != end) throw Error(name, "the file ends before its last value", "Check the file.");
  return grid;
}

RawGrid readPicture(const std::filesystem::path& file, bool zeroIsUnknown) {
  const cv::Mat picture = readImage(file, PixelDepth::AsStored);
  if (picture.channels() != 1) {
    throw Error(
        file.string(),
        "a map is a picture of one channel, this one has " + std::to_string(picture.channels()),
        "Save it as grey, 8 or 16 bits.");
  }
  RawGrid grid;
  picture.convertTo(grid.values, CV_32FC1);
  if (zeroIsUnknown) grid.values.setTo(unknown, picture == 0);
  return grid;
}

/// The description with every key checked.
class Description {
 public:
  explicit Description(const std::filesystem::path& file) : m_name(file.string()) {
    YAML::Node root;
    try {
      root = YAML::Load(readFileBytes(file, maxDescription));
    } catch (const YAML::Exception& fault) {
      throw Error(m_name, "not YAML: " + fault.msg, "Write 'key: value' lines.");
    }
    if (!root.IsMap()) throw Error(m_name, "not a map's description", "Write 'key: value' lines.");
    for (const auto& entry : root) read(entry.first, entry.second);
  }

  std::optional<std::string> text(const char* key) const {
    const auto found = m_values.find(key);
    return found == m_values.end() ? std::nullopt : std::optional(found->second);
  }
  std::optional<double> number(const char* key, double low, double high) const {
    const auto value = text(key);
    if (!value) return std::nullopt;
    const auto parsed = toNumber<double>(*value);
    if (!parsed || !(*parsed >= low && *parsed <= high)) {
      throw Error(m_name + ", '" + key + "'",
                  "'" + value->substr(0, 40) + "' is not a number in its range",
                  "Give a number of metres.");
    }
    return parsed;
  }
  [[noreturn]] void refuse(const std::string& what, const std::string& cure) const {
    throw Error(m_name, what, cure);
  }

 private:
  void read(const YAML::Node& key, const YAML::Node& value) {
    static constexpr std::string_view keys[] = {
        "file", "kind", "metres_per_unit", "metres_per_pixel", "camera_height",
        "left", "top",  "spacing"};
    const std::string name = key.IsScalar() ? key.Scalar() : "";
    if (std::find(std::begin(keys), std::end(keys), name) == std::end(keys)) {
      refuse("'" + name.substr(0, 40) + "' is not a key of a map",
             "The keys are file, kind, metres_per_unit, metres_per_pixel, camera_height, left, top "
             "and spacing.");
    }
    if (!value.IsScalar()) refuse("'" + name + "' has no single value", "Give one value.");
    m_values[name] = value.Scalar();
  }

  std::string m_name;
  std::map<std::string, std::string, std::less<>> m_values;
};

void toDepth(cv::Mat& heights, std::optional<double> cameraHeight, const std::string& name) {
  double highest = -std::numeric_limits<double>::infinity();
  for (auto it = heights.begin<float>(); it != heights.end<float>(); ++it) {
    if (std::isfinite(*it)) highest = std::max(highest, static_cast<double>(*it));
  }
  if (!std::isfinite(highest)) throw Error(name, "no cell of it has a value", "Check the file.");
  heights = cameraHeight.value_or(highest + standsAbove) - heights;
}

SurfaceMap centred(cv::Mat z, double cell) {
  SurfaceMap map{std::move(z), 0.0, 0.0, cell};
  map.left = -cell * map.z.cols / 2;
  map.top = -cell * map.z.rows / 2;
  return map;
}

SurfaceMap readDescribed(const std::filesystem::path& file) {
  const Description description(file);
  const std::string kind = description.text("kind").value_or("");
  if (kind != "height" && kind != "depth") {
    description.refuse("'kind' must be height or depth", "Add 'kind: height' or 'kind: depth'.");
  }
  const auto named = description.text("file");
  if (!named) description.refuse("'file' is missing", "Name the grid or the picture.");
  const std::filesystem::path data = file.parent_path() / *named;
  const bool grid = lowerExtension(data) == ".asc";
  RawGrid raw = grid ? readAsciiGrid(data) : readPicture(data, kind == "depth");
  const auto perPixel = description.number("metres_per_pixel", 1e-4, 1e4);
  if (perPixel) raw.cell = perPixel;
  if (!raw.cell) {
    description.refuse("'metres_per_pixel' is missing", "Say how large a pixel of the map is.");
  }
  raw.values *= description.number("metres_per_unit", 1e-6, 1e3).value_or(grid ? 1.0 : 1e-3);
  if (kind == "height") {
    toDepth(raw.values, description.number("camera_height", -1e5, 1e5), data.string());
  }
  SurfaceMap map = centred(raw.values, *raw.cell);
  map.left = description.number("left", -1e5, 1e5).value_or(map.left);
  map.top = description.number("top", -1e5, 1e5).value_or(map.top);
  map.spacing = description.number("spacing", 1e-3, 1e3).value_or(map.spacing);
  return map;
}

}  // namespace

SurfaceMap readSurfaceMap(const std::filesystem::path& file) {
  const std::string extension = lowerExtension(file);
  if (extension == ".yaml" || extension == ".yml") return readDescribed(file);
  if (extension != ".asc") {
    throw Error(
        file.string(), "not a map",
        "Give an ESRI ASCII grid (.asc), or a YAML file that describes a grid or a picture.");
  }
  RawGrid raw = readAsciiGrid(file);
  toDepth(raw.values, std::nullopt, file.string());
  return centred(raw.values, *raw.cell);
}

}  // namespace boomwatch
