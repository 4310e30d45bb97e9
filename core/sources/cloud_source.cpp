#include "sources/cloud_source.h"

#include "base/error.h"
#include "sources/cloud_file.h"
#include "sources/file_sequence.h"
#include "sources/indexed_source.h"

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
      frame->cloud = std::move(file.cloud);
      return ok(std::move(frame));
    } catch (const Error& error) {
      return bad(error.what());
    }
  }

 private:
  std::vector<std::filesystem::path> m_files;
  std::vector<double> m_stamps;
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
