#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace boomwatch {

/// What to write, and where.
struct DemoExport {
  std::string demo;                   ///< as behind "demo:", e.g. "yard,seed=7"
  std::optional<std::size_t> frames;  ///< all that the demo has when absent
  std::filesystem::path folder;       ///< must not exist, or be empty
  bool truthImages = false;           ///< demo:yard: also depth, disparity and kinds as images
};

/// Called after each frame; false stops the export.
using ExportProgress = std::function<bool(std::size_t done, std::size_t all)>;

/// Writes a demo as an ordinary recording that `stereo:FOLDER` (a stereo pair: left/, right/,
/// calibration.yaml, timestamps.txt) or `depth:FOLDER` (else: colour/, depth/, intrinsics.yaml)
/// reads, with truth.jsonl (a line a frame, see truthJson). With truthImages also truth/depth
/// (16 bits, millimetres), truth/disparity (16 bits, 256 a pixel; both 0 where there is none) and
/// truth/kind (a YardKind).
///
/// All is written into FOLDER.partial, which gets its name at the end; false when it was stopped.
/// Whatever was stopped or failed is removed. Throws Error when demo, frames or folder cannot be
/// used, and std::runtime_error, naming the file, when writing fails.
bool exportDemo(const DemoExport& what, const ExportProgress& progress);

}  // namespace boomwatch
