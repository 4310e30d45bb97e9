// The file of a ToolModel, all numbers little-endian:
//   "BWTOOL\r\n" (the line end shows a transfer as text), u32 version, f64 width, f64 height,
//   u32 patch width, u32 patch height, u32 positives, u32 negatives, u32 leaves;
//   positives, negatives: pixels row by row;
//   leaves, those that saw anything: u32 index, rising, u16 positive, u16 negative;
//   u64 FNV-1a hash of all before.
#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <string_view>

#include "base/error.h"
#include "files/file_bytes.h"
#include "tracking/tool_model.h"
#include "tracking/tool_model_file.h"

namespace boomwatch {
namespace {

constexpr std::string_view magic = "BWTOOL\r\n";
constexpr std::uint32_t version = 1;
constexpr std::size_t hashBytes = 8;
constexpr double maxTool = 1e5;
constexpr std::size_t maxFile = 4 << 20;
constexpr std::size_t allLeaves = ToolModel::ferns * ToolModel::leavesPerFern;
constexpr std::size_t leafBytes = 4 + 2 + 2;

std::uint64_t hashOf(std::string_view bytes) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char byte : bytes) {
    hash ^= static_cast<unsigned char>(byte);
    hash *= 1099511628211ULL;
  }
  return hash;
}

template <std::unsigned_integral Number>
void put(std::string& out, Number number) {
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    out.push_back(static_cast<char>(number >> (8 * i) & 0xFF));
  }
}

void put(std::string& out, double number) { put(out, std::bit_cast<std::uint64_t>(number)); }

void put(std::string& out, const std::vector<cv::Mat>& patches) {
  for (const cv::Mat& patch : patches) {
    for (int row = 0; row < patch.rows; ++row) {
      out.append(patch.ptr<char>(row), static_cast<std::size_t>(patch.cols));
    }
  }
}

/// Takes numbers and patches from the front of the bytes. The caller knows that they suffice.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : m_bytes(bytes) {}

  template <std::unsigned_integral Number>
  Number take() {
    Number number = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      number |= static_cast<Number>(static_cast<Number>(static_cast<unsigned char>(m_bytes[i]))
                                    << (8 * i));
    }
    m_bytes.remove_prefix(sizeof(Number));
    return number;
  }
  double takeDouble() { return std::bit_cast<double>(take<std::uint64_t>()); }

  std::vector<cv::Mat> takePatches(std::size_t count, cv::Size size) {
    std::vector<cv::Mat> patches(count);
    const auto area = static_cast<std::size_t>(size.area());
    for (cv::Mat& patch : patches) {
      patch.create(size, CV_8UC1);
      std::copy_n(m_bytes.data(), area, patch.ptr<char>());
      m_bytes.remove_prefix(area);
    }
    return patches;
  }
  std::size_t left() const { return m_bytes.size(); }

 private:
  std::string_view m_bytes;
};

struct Header {
  cv::Size2d size;
  cv::Size patch;
  std::size_t positives = 0;
  std::size_t negatives = 0;
  std::size_t leaves = 0;

  static constexpr std::size_t bytes = 2 * 8 + 5 * 4;
};

Header takeHeader(Bytes& bytes) {
  Header header;
  header.size.width = bytes.takeDouble();
  header.size.height = bytes.takeDouble();
  header.patch.width = static_cast<int>(bytes.take<std::uint32_t>());
  header.patch.height = static_cast<int>(bytes.take<std::uint32_t>());
  header.positives = bytes.take<std::uint32_t>();
  header.negatives = bytes.take<std::uint32_t>();
  header.leaves = bytes.take<std::uint32_t>();
  return header;
}

bool isPossible(const Header& header) {
  const auto possibleSide = [](double side) { return side >= 1.0 && side <= maxTool; };
  if (!possibleSide(header.size.width) || !possibleSide(header.size.height)) return false;
  ToolModel model;
  model.size = header.size;
  return header.patch == model.patchSize() && header.positives <= ToolModel::maxPositives &&
         header.negatives <= ToolModel::maxNegatives && header.leaves <= allLeaves;
}

std::size_t bytesBehind(const Header& header) {
  return (header.positives + header.negatives) * static_cast<std::size_t>(header.patch.area()) +
         header.leaves * leafBytes;
}

void putLeaves(std::string& out, const std::vector<FernLeaf>& leaves) {
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    if (leaves[i] == FernLeaf()) continue;
    put(out, static_cast<std::uint32_t>(i));
    put(out, leaves[i].positive);
    put(out, leaves[i].negative);
  }
}

/// False when they are not in order.
bool takeLeaves(Bytes& bytes, std::size_t count, std::vector<FernLeaf>& leaves) {
  std::size_t next = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t index = bytes.take<std::uint32_t>();
    if (index < next || index >= leaves.size()) return false;
    leaves[index].positive = bytes.take<std::uint16_t>();
    leaves[index].negative = bytes.take<std::uint16_t>();
    next = index + 1;
  }
  return true;
}

}  // namespace

void saveToolModel(const ToolModel& model, const std::string& file) {
  std::string bytes(magic);
  put(bytes, version);
  put(bytes, model.size.width);
  put(bytes, model.size.height);
  put(bytes, static_cast<std::uint32_t>(model.patchSize().width));
  put(bytes, static_cast<std::uint32_t>(model.patchSize().height));
  put(bytes, static_cast<std::uint32_t>(model.positives.size()));
  put(bytes, static_cast<std::uint32_t>(model.negatives.size()));
  const auto unused = std::ranges::count(model.leaves, FernLeaf());
  put(bytes, static_cast<std::uint32_t>(model.leaves.size() - static_cast<std::size_t>(unused)));
  put(bytes, model.positives);
  put(bytes, model.negatives);
  putLeaves(bytes, model.leaves);
  put(bytes, hashOf(bytes));
  if (replaceFile(file, bytes)) return;
  throw Error(file, "the tool model cannot be written",
              "Check that the folder exists, may be written to and is not full.");
}

ToolModel loadToolModel(const std::string& file) {
  const std::string content = readFileBytes(file, maxFile);
  if (!content.starts_with(magic)) {
    throw Error(file, "this is not a tool model", "Choose a file that this program saved as one.");
  }
  const Error damaged(file, "the tool model is truncated or damaged", "Copy or save it again.");
  Bytes bytes(std::string_view(content).substr(magic.size()));
  if (bytes.left() < sizeof(version)) throw damaged;
  if (const auto found = bytes.take<std::uint32_t>(); found != version) {
    throw Error(
        file,
        "this tool model has version " + std::to_string(found) + ", not " + std::to_string(version),
        "Train the tool again.");
  }
  if (bytes.left() < Header::bytes + hashBytes) throw damaged;
  const std::string_view hashed = std::string_view(content).substr(0, content.size() - hashBytes);
  Bytes end(std::string_view(content).substr(hashed.size()));
  if (end.take<std::uint64_t>() != hashOf(hashed)) throw damaged;
  const Header header = takeHeader(bytes);
  if (!isPossible(header) || bytes.left() != bytesBehind(header) + hashBytes) throw damaged;
  ToolModel model;
  model.size = header.size;
  model.positives = bytes.takePatches(header.positives, header.patch);
  model.negatives = bytes.takePatches(header.negatives, header.patch);
  if (!takeLeaves(bytes, header.leaves, model.leaves)) throw damaged;
  return model;
}

}  // namespace boomwatch
