#include "lab/evaluation/tracking_sequence.h"

#include <algorithm>

#include "base/error.h"
#include "sources/file_sequence.h"
#include "sources/image_sequence.h"
#include "sources/video_stream.h"

namespace boomwatch {
namespace {

namespace fs = std::filesystem;

bool isFolder(const fs::path& path) {
  std::error_code fault;
  return fs::is_directory(path, fault);
}

bool looksLikeSequence(const fs::path& folder) {
  return groundTruthFile(folder) || isFolder(folder / "img") ||
         !listFiles(folder, hasVideoExtension).empty();
}

std::unique_ptr<ImageStream> openPictures(const fs::path& folder) {
  if (isFolder(folder / "img")) {
    auto files = imagesIn(folder / "img");
    if (!files.empty()) return std::make_unique<ImageSequence>(std::move(files));
  }
  const auto videos = listFiles(folder, hasVideoExtension);
  if (videos.size() == 1) return std::make_unique<VideoStream>(videos.front());
  throw Error(folder.string(),
              videos.empty() ? "there are neither pictures in img/ nor a video"
                             : "there is more than one video",
              "A sequence is a folder with img/ or one video, and its ground truth.");
}

[[noreturn]] void refuseCounts(const fs::path& folder, const std::string& pictures,
                               std::size_t lines) {
  throw Error(
      folder.string(),
      "there are " + pictures + " pictures and " + std::to_string(lines) + " lines of ground truth",
      "There must be one line a picture.");
}

/// A video may only estimate how many pictures it holds: what counts is what can be read.
void checkCounts(const fs::path& folder, ImageStream& images, std::size_t lines) {
  const bool counted = dynamic_cast<ImageSequence*>(&images) != nullptr;
  if (counted && images.count() != lines) {
    refuseCounts(folder, std::to_string(images.count()), lines);
  }
  if (counted) return;
  if (images.read(lines - 1).image.empty()) refuseCounts(folder, "fewer", lines);
  if (!images.read(lines).end) refuseCounts(folder, "more", lines);
}

}  // namespace

TrackingSequence openTrackingSequence(const fs::path& folder) {
  TrackingSequence sequence;
  sequence.name = (folder / "").parent_path().filename().string();
  sequence.images = openPictures(folder);
  const auto size = sequence.images->size();
  if (!size) {
    throw Error(folder.string(), "its first picture cannot be read", "Copy the recording again.");
  }
  sequence.truth = readGroundTruth(folder, *size);
  checkCounts(folder, *sequence.images, sequence.truth.size());
  if (std::ranges::none_of(sequence.truth, [](const auto& box) { return box.has_value(); })) {
    throw Error(folder.string(), "the target is seen in no picture",
                "At least one line of the ground truth must be a box.");
  }
  return sequence;
}

std::vector<fs::path> trackingSequencesIn(const fs::path& given) {
  if (!isFolder(given)) {
    throw Error(given.string(), "there is no such folder",
                "Name a folder with pictures and ground truth, or a folder of such.");
  }
  const fs::path path = fs::canonical(given);  // "." and "name/" have no name
  if (looksLikeSequence(path)) return {path};
  std::vector<fs::path> folders;
  std::error_code fault;
  for (fs::directory_iterator it(path, fault), end; !fault && it != end; it.increment(fault)) {
    if (isFolder(it->path()) && looksLikeSequence(it->path())) folders.push_back(it->path());
  }
  if (folders.empty()) {
    throw Error(path.string(), "there is no sequence in it",
                "A sequence is a folder with img/ or one video, and its ground truth.");
  }
  std::ranges::sort(folders, [](const fs::path& a, const fs::path& b) {
    return naturalOrder(a.filename().native(), b.filename().native());
  });
  return folders;
}

}  // namespace boomwatch
