#include "sources/depth_recording.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "files/bounded_image.h"
#include "files/file_bytes.h"
#include "files/line_reader.h"
#include "sources/file_sequence.h"

namespace boomwatch {
namespace {

namespace fs = std::filesystem;

constexpr double assumedRate = 10.0;
constexpr double maxGap = 0.02;  // seconds between a depth and a colour image
constexpr std::size_t maxList = std::size_t{1} << 26;
constexpr std::string_view depthSuffix = "_depth";

struct ListedImage {
  double stamp = 0.0;
  fs::path file;
};

bool isFile(const fs::path& file) {
  std::error_code fault;
  return fs::is_regular_file(file, fault);
}

bool isFolder(const fs::path& folder) {
  std::error_code fault;
  return fs::is_directory(folder, fault);
}

fs::path findIntrinsics(const fs::path& folder) {
  for (const char* name : {"intrinsics", "camera", "calibration"}) {
    for (const char* extension : {".yaml", ".yml", ".xml", ".json"}) {
      fs::path file = folder / (std::string(name) + extension);
      if (isFile(file)) return file;
    }
  }
  return {};
}

DepthCalibration requireIntrinsics(const fs::path& folder) {
  const fs::path file = findIntrinsics(folder);
  if (!file.empty()) return readDepthCalibration(file);
  throw Error(
      folder.string(), "there are no intrinsics",
      "Put an intrinsics.yaml with camera_matrix, or fx, fy, cx and cy, beside the images.");
}

/// Lines of "stamp file"; '#' begins a comment.
std::vector<ListedImage> readList(const fs::path& list) {
  const std::string text = readFileBytes(list, maxList);
  std::vector<ListedImage> images;
  LineReader lines(text);
  while (const auto textLine = lines.next()) {
    const auto line = words(*textLine);
    if (line.empty() || line[0].starts_with('#')) continue;
    const auto stamp = toNumber<double>(line[0]);
    if (line.size() < 2 || !stamp || !std::isfinite(*stamp)) {
      throw Error(list.string() + ", line " + std::to_string(lines.lineNumber()),
                  "this is not a stamp and a file", "Write 'seconds file' lines.");
    }
    images.push_back({*stamp, list.parent_path() / line[1]});
  }
  std::ranges::stable_sort(images, {}, &ListedImage::stamp);
  return images;
}

fs::path nearestInTime(const std::vector<ListedImage>& images, double stamp) {
  const auto after = std::ranges::lower_bound(images, stamp, {}, &ListedImage::stamp);
  const ListedImage* best = nullptr;
  if (after != images.end()) best = &*after;
  if (after != images.begin()) {
    const ListedImage& before = *std::prev(after);
    if (!best || stamp - before.stamp < best->stamp - stamp) best = &before;
  }
  const bool near = best && std::abs(best->stamp - stamp) <= maxGap;
  return near ? best->file : fs::path();
}

DepthRecording tumRecording(const fs::path& folder) {
  DepthRecording recording;
  recording.calibration = {{0, 0, 525.0, 525.0, 319.5, 239.5}, 5000.0};
  if (const fs::path file = findIntrinsics(folder); !file.empty()) {
    recording.calibration = readDepthCalibration(file);
  }
  std::vector<ListedImage> colours;
  if (isFile(folder / "rgb.txt")) colours = readList(folder / "rgb.txt");
  for (const ListedImage& depth : readList(folder / "depth.txt")) {
    recording.frames.push_back({depth.file, nearestInTime(colours, depth.stamp), {}, depth.stamp});
  }
  return recording;
}

void setStamps(const std::vector<fs::path>& files, DepthRecording& recording) {
  const std::vector<double> stamps = stampsOf(files, assumedRate);
  for (std::size_t k = 0; k < files.size(); ++k) recording.frames[k].stamp = stamps[k];
}

bool isPairedDepth(const fs::path& file) {
  return hasImageExtension(file) && file.stem().string().ends_with(depthSuffix);
}

DepthRecording pairedRecording(const fs::path& folder) {
  DepthRecording recording;
  std::vector<fs::path> names;
  bool allHaveTheirOwn = true;
  for (const fs::path& depth : listFiles(folder, isPairedDepth)) {
    std::string name = depth.stem().string();
    name.resize(name.size() - depthSuffix.size());
    DepthFrameFiles files{depth, {}, {}, 0.0};
    for (const char* extension : {".jpg", ".png", ".jpeg"}) {
      const fs::path colour = folder / (name + extension);
      if (files.colour.empty() && isFile(colour)) files.colour = colour;
    }
    const fs::path intrinsics = folder / (name + "_camera.xml");
    if (isFile(intrinsics)) files.intrinsics = intrinsics;
    allHaveTheirOwn = allHaveTheirOwn && !files.intrinsics.empty();
    names.push_back(folder / (name + ".png"));
    recording.frames.push_back(std::move(files));
  }
  if (!allHaveTheirOwn) recording.calibration = requireIntrinsics(folder);
  setStamps(names, recording);
  return recording;
}

fs::path colourFolder(const fs::path& folder) {
  for (const char* name : {"colour", "color", "rgb", "images"}) {
    if (isFolder(folder / name)) return folder / name;
  }
  return {};
}

void matchColours(const std::vector<fs::path>& colours, const fs::path& folder,
                  DepthRecording& recording) {
  std::map<std::string, fs::path> byName;
  for (const fs::path& colour : colours) byName.emplace(colour.stem().string(), colour);
  bool anyMatches = false;
  for (DepthFrameFiles& frame : recording.frames) {
    const auto found = byName.find(frame.depth.stem().string());
    if (found == byName.end()) continue;
    frame.colour = found->second;
    anyMatches = true;
  }
  if (anyMatches || colours.empty()) return;
  if (colours.size() != recording.frames.size()) {
    throw Error(folder.string(),
                "no name of its " + std::to_string(colours.size()) +
                    " images is that of a depth image, and there are " +
                    std::to_string(recording.frames.size()) + " of those",
                "Name the images of a frame alike.");
  }
  for (std::size_t k = 0; k < colours.size(); ++k) recording.frames[k].colour = colours[k];
}

DepthRecording folderRecording(const fs::path& folder) {
  DepthRecording recording;
  recording.calibration = requireIntrinsics(folder);
  const std::vector<fs::path> depths = listFiles(folder / "depth", hasImageExtension);
  for (const fs::path& depth : depths) recording.frames.push_back({depth, {}, {}, 0.0});
  setStamps(depths, recording);
  if (const fs::path colours = colourFolder(folder); !colours.empty()) {
    matchColours(listFiles(colours, hasImageExtension), colours, recording);
  }
  return recording;
}

double rateOf(const std::vector<DepthFrameFiles>& frames) {
  std::vector<double> stamps(frames.size());
  std::ranges::transform(frames, stamps.begin(), &DepthFrameFiles::stamp);
  return meanRate(stamps, assumedRate);
}

}  // namespace

DepthRecording findDepthRecording(const fs::path& folder) {
  if (!isFolder(folder)) {
    throw Error(folder.string(), "there is no such folder", "Check the path.");
  }
  DepthRecording recording;
  if (isFile(folder / "depth.txt")) {
    recording = tumRecording(folder);
  } else if (!listFiles(folder, isPairedDepth).empty()) {
    recording = pairedRecording(folder);
  } else if (isFolder(folder / "depth")) {
    recording = folderRecording(folder);
  }
  if (recording.frames.empty()) {
    throw Error(folder.string(), "there are no depth images",
                "Give a folder with depth.txt, NAME_depth.png files or a folder depth.");
  }
  recording.rate = rateOf(recording.frames);
  return recording;
}

}  // namespace boomwatch
