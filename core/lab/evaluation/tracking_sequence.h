#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "lab/evaluation/ground_truth.h"
#include "sources/image_stream.h"

namespace boomwatch {

/// A recording in which it is known where the target is.
struct TrackingSequence {
  std::string name;                     ///< of its folder
  std::unique_ptr<ImageStream> images;  ///< at least as many as `truth` has entries
  GroundTruth truth;                    ///< one entry a picture; the target is seen in at least one
};

/// Opens a folder with pictures (in img/, or one video) and their ground truth (readGroundTruth()).
/// Throws Error naming the folder or file when one of them is missing, they do not agree in number,
/// or a line cannot be read.
TrackingSequence openTrackingSequence(const std::filesystem::path& folder);

/// `path`, made canonical, when it holds pictures or ground truth, otherwise the folders in it that
/// do, in natural order. Throws Error naming `path` when there is none.
std::vector<std::filesystem::path> trackingSequencesIn(const std::filesystem::path& path);

}  // namespace boomwatch
