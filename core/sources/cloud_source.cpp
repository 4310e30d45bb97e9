#include "sources/cloud_source.h"

#include "base/error.h"
#include "sources/cloud_file.h"
#include "sources/file_sequence.h"
#include "sources/indexed_source.h"
#include "sources/pinhole_fit.h"

namespace boomwatch {
namespace {

constexpr double assumedRate = 10.0;

class CloudSource : public IndexedSource {
 public:
  CloudSource(std::string address, std::vector<std::filesystem::path> files)
      : IndexedSource(std::move(address), files.size(), assumedRate),
        m_files(std::move(files)),
        m_stamps(stampsOf(m_files, assumedRate)) {}

 protected:
  ReadResult read(std::size_t index) override {
    try {
      CloudFile file = readCloudFile(m_files[index]);
      auto frame = std::make_shared<Frame>();
      frame->sequence = index;
      frame->stamp = m_stamps[index];
      frame->left = std::move(file.image);
      giveCamera(*file.cloud);
      frame->cloud = std::move(file.cloud);
      return ok(std::move(frame));
    } catch (const Error& error) {
      return bad(error.what());
    }
  }

 private:
  /// The files do not say their camera. It is fitted to the first organised cloud, and again only
  /// when the size changes.
  void giveCamera(Cloud& cloud) {
    if (!cloud.organised()) return;
    const bool fits =
        m_camera && m_camera->width == cloud.width && m_camera->height == cloud.height;
    if (!fits) m_camera = fitPinhole(cloud);
    cloud.camera = m_camera;
  }

  std::vector<std::filesystem::path> m_files;
  std::vector<double> m_stamps;
  std::optional<PinholeCamera> m_camera;
};

}  // namespace

std::unique_ptr<FrameSource> openCloudSource(const std::filesystem::path& path,
                                             const std::string& address) {
  std::error_code fault;
  if (path.empty()) {
    throw Error(address, "no path is given", "Give cloud:FILE or cloud:FOLDER, of PCD or PLY.");
  }
  if (!std::filesystem::exists(path, fault)) {
    throw Error(path.string(), "there is no such file or folder", "Check the path.");
  }
  if (!std::filesystem::is_directory(path, fault)) {
    readCloudFile(path);  // says now, not at the first frame, that it cannot be read
    return std::make_unique<CloudSource>(address, std::vector{path});
  }
  auto files = listFiles(path, isCloudFile);
  if (files.empty()) {
    throw Error(path.string(), "there is no .pcd or .ply file in this folder", "Check the path.");
  }
  return std::make_unique<CloudSource>(address, std::move(files));
}

}  // namespace boomwatch
