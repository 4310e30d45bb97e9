#include "sources/stereo_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "base/error.h"
#include "files/bounded_image.h"
#include "files/line_reader.h"
#include "sources/file_sequence.h"
#include "sources/image_sequence.h"
#include "sources/video_stream.h"

namespace boomwatch {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;

// Seconds that the shutters of a pair may differ; at 1 m/s a load moves 2 cm meanwhile.
constexpr double maxSkew = 0.02;

struct FolderNames {
  const char* left;
  const char* right;
  CameraPair cameras = CameraPair::First;
};
constexpr std::array folderNames{FolderNames{"left", "right"},
                                 FolderNames{"image_l", "image_r"},
                                 FolderNames{"image_left", "image_right"},
                                 FolderNames{"image_0", "image_1"},
                                 FolderNames{"image_2", "image_3", CameraPair::Second},
                                 FolderNames{"image_00", "image_01"},
                                 FolderNames{"cam0", "cam1"}};

enum class Side { Neither, Left, Right };
using Rule = Side (*)(const std::string& stem);

Side byWord(const std::string& stem) {
  const std::string name = lower(stem);
  const bool left = name.find("left") != std::string::npos;
  const bool right = name.find("right") != std::string::npos;
  return left == right ? Side::Neither : left ? Side::Left : Side::Right;
}

Side byLetter(const std::string& stem) {
  const std::string name = lower(stem);
  if (stem.ends_with("L") || name.ends_with("_l") || name.ends_with("-l")) return Side::Left;
  if (stem.ends_with("R") || name.ends_with("_r") || name.ends_with("-r")) return Side::Right;
  return Side::Neither;
}

// Middlebury's names; its sets of 2001 to 2005 number the views, and pair 2 with 6 or 1 with 5.
Side byView(const std::string& stem) {
  if (stem == "im0" || stem == "im2" || stem == "view1") return Side::Left;
  if (stem == "im1" || stem == "im6" || stem == "view5") return Side::Right;
  return Side::Neither;
}

std::pair<Paths, Paths> split(const Paths& files, Rule rule) {
  std::pair<Paths, Paths> sides;
  for (const auto& file : files) {
    const Side side = rule(file.stem().string());
    if (side == Side::Left) sides.first.push_back(file);
    if (side == Side::Right) sides.second.push_back(file);
  }
  return sides;
}

void checkNumbers(const StereoFiles& files) {
  const auto first = numberIn(files.left.front()), last = numberIn(files.left.back());
  if (!first || first == last) return;  // names that do not count
  for (std::size_t i = 0; i < files.left.size(); ++i) {
    const auto left = stampFromName(files.left[i].stem().string());
    const auto right = stampFromName(files.right[i].stem().string());
    const bool fits = left && right ? std::abs(*left - *right) <= maxSkew
                                    : numberIn(files.left[i]) == numberIn(files.right[i]);
    if (fits) continue;
    throw Error(files.left[i].string(),
                "by order its partner would be " + files.right[i].filename().string() +
                    ", which has another number",
                "Remove the pictures that have no partner.");
  }
}

void checkCounts(const StereoFiles& files) {
  const auto left = files.left.size(), right = files.right.size();
  if (left + right == 0) {
    throw Error(files.folder.string(), "there are no pictures for left and right",
                "Pictures are read from PNG, JPEG, BMP, PGM and PPM files.");
  }
  if (left != right) {
    throw Error(files.folder.string(),
                "there are " + std::to_string(left) + " left and " + std::to_string(right) +
                    " right pictures",
                "Each left picture needs a right one: complete them, or remove what is extra.");
  }
  if (!files.video) checkNumbers(files);
}

// KITTI's raw recordings and EuRoC keep the pictures one folder deeper.
Paths picturesBelow(const fs::path& folder) {
  const auto files = imagesIn(folder);
  return files.empty() && fs::is_directory(folder / "data") ? imagesIn(folder / "data") : files;
}

const FolderNames* folderPairIn(const fs::path& folder) {
  const auto isPair = [&](const FolderNames& names) {
    return fs::is_directory(folder / names.left) && fs::is_directory(folder / names.right);
  };
  const auto found = std::ranges::find_if(folderNames, isPair);
  return found == folderNames.end() ? nullptr : &*found;
}

/// Videos or pictures that lie side by side in the folder; several videos a side are possible.
std::optional<StereoFiles> filePairIn(const fs::path& folder) {
  const Paths videos = listFiles(folder, hasVideoExtension);
  const Paths pictures = imagesIn(folder);
  for (const bool video : {true, false}) {
    for (const Rule rule : {byWord, byLetter, byView}) {
      auto [left, right] = split(video ? videos : pictures, rule);
      if (left.empty() || right.empty()) continue;
      return StereoFiles{folder, left, right, video, CameraPair::First};
    }
  }
  return std::nullopt;
}

StereoFiles filesOfFolder(const fs::path& folder) {
  if (const FolderNames* names = folderPairIn(folder)) {
    return {folder, picturesBelow(folder / names->left), picturesBelow(folder / names->right),
            false, names->cameras};
  }
  if (auto files = filePairIn(folder)) {
    if (files->video && (files->left.size() > 1 || files->right.size() > 1)) {
      throw Error(folder.string(), "there are several left or right videos",
                  "Name the two: stereo:LEFT,RIGHT");
    }
    return *files;
  }
  throw Error(folder.string(), "there is no left and right in it",
              "Give a folder that holds left/ and right/, left.mp4 and right.mp4, or left01.png "
              "and right01.png, or name the two: stereo:LEFT,RIGHT");
}

StereoFiles filesOfPair(const fs::path& left, const fs::path& right) {
  const bool folders = fs::is_directory(left) && fs::is_directory(right);
  const bool videos = hasVideoExtension(left) && hasVideoExtension(right);
  const fs::path folder = left.parent_path();
  if (folders) return {folder, picturesBelow(left), picturesBelow(right), false, CameraPair::First};
  if (videos || (hasImageExtension(left) && hasImageExtension(right))) {
    return {folder, {left}, {right}, videos, CameraPair::First};
  }
  throw Error(left.string() + ", " + right.string(), "these are not two of a kind",
              "Give two folders of pictures, two videos or two pictures.");
}

fs::path clean(const fs::path& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

StereoFiles find(const std::string& path) {
  const std::string remedy = "Give stereo:FOLDER or stereo:LEFT,RIGHT.";
  if (path.empty()) throw Error("stereo:", "no path is given", remedy);
  if (fs::is_directory(path)) return filesOfFolder(clean(path));
  // A path may itself hold a comma.
  for (auto comma = path.find(','); comma != std::string::npos; comma = path.find(',', comma + 1)) {
    const std::string left = path.substr(0, comma), right = path.substr(comma + 1);
    if (!left.empty() && !right.empty() && fs::exists(left) && fs::exists(right)) {
      return filesOfPair(clean(left), clean(right));
    }
  }
  throw Error(path, fs::exists(path) ? "this is not a folder" : "there is no such folder", remedy);
}

}  // namespace

bool holdsStereoPair(const fs::path& folder) {
  try {
    return folderPairIn(folder) || filePairIn(folder);
  } catch (const std::runtime_error&) {  // of the disk, or Error of a folder that is closed to us
    return false;
  }
}

StereoFiles findStereoFiles(const std::string& path) {
  try {
    StereoFiles files = find(path);
    checkCounts(files);
    return files;
  } catch (const fs::filesystem_error& fault) {
    throw Error(path, fault.code().message(), "Check the path and its permissions.");
  }
}

}  // namespace boomwatch
