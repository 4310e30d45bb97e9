#include <QtTest>
#include <filesystem>

#include "files/file_bytes.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"
#include "tracking/learnt_patches.h"
#include "tracking/tool_model.h"
#include "tracking/tool_model_file.h"

using namespace boomwatch;

/// The model of TLD as a value and as a file.
class TestToolModel : public QObject {
  Q_OBJECT
 private slots:
  void comesBackFromItsFile();
  void truncatedAtEveryByte();
  void everyFlippedByteIsNoticed();
  void foreignAndNewerFiles();
  void failedSaveLeavesTheOldFile();
  void mergesInEqualShares();
  void refusesToMergeOtherShapes();
  void forgetsWhatIsReplaced();

 private:
  static QByteArray bytesOf(const std::filesystem::path& file) {
    return QByteArray::fromStdString(readFileBytes(file, 1 << 20));
  }
  TemporaryFolder m_folder;
};

namespace {

cv::Mat noise(cv::Size size, unsigned seed) {
  cv::Mat patch(size, CV_8UC1);
  cv::RNG(seed).fill(patch, cv::RNG::UNIFORM, 0, 256);
  return patch;
}

ToolModel modelOf(std::size_t positives, std::size_t negatives, unsigned seed = 0) {
  ToolModel model;
  model.size = {41.5, 30.25};
  const cv::Size patch = model.patchSize();
  for (unsigned i = 0; i < positives; ++i) model.positives.push_back(noise(patch, seed + i + 1));
  for (unsigned i = 0; i < negatives; ++i) model.negatives.push_back(noise(patch, seed + i + 900));
  model.leaves[3] = {7, 2};
  model.leaves.back() = {65535, 1};
  return model;
}

}  // namespace

void TestToolModel::comesBackFromItsFile() {
  const ToolModel model = modelOf(5, 9);
  const std::string file = m_folder.path("tool.model").string();
  saveToolModel(model, file);
  const ToolModel loaded = loadToolModel(file);
  QVERIFY(loaded == model);
  QVERIFY(!(loaded == modelOf(5, 9, 1)));
  // Three quarters of 15 x 15 pixels as wide as high.
  QCOMPARE(loaded.patchSize().width, 18);
  QCOMPARE(loaded.patchSize().height, 13);
}

void TestToolModel::truncatedAtEveryByte() {
  const std::string file = m_folder.path("short.model").string();
  saveToolModel(modelOf(1, 1), file);
  const QByteArray bytes = bytesOf(file);
  for (auto length = bytes.size() - 1; length >= 0; --length) {
    std::filesystem::resize_file(file, static_cast<std::uintmax_t>(length));
    COMPARE_CONTAINS(errorOf([&] { loadToolModel(file); }), "short.model");
  }
}

void TestToolModel::everyFlippedByteIsNoticed() {
  const std::string file = m_folder.path("good.model").string();
  saveToolModel(modelOf(1, 1), file);
  const QByteArray good = bytesOf(file);
  for (qsizetype at = 0; at < good.size(); ++at) {
    for (const int bit : {0, 7}) {
      QByteArray bytes = good;
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << bit));
      const auto damaged = m_folder.write("flipped.model", bytes);
      COMPARE_CONTAINS(errorOf([&] { loadToolModel(damaged.string()); }), "flipped.model");
    }
  }
}

void TestToolModel::foreignAndNewerFiles() {
  const auto errorFor = [&](const QByteArray& bytes) {
    const auto file = m_folder.write("other.model", bytes);
    return errorOf([&] { loadToolModel(file.string()); });
  };
  COMPARE_CONTAINS(errorFor("\x89PNG\r\n\x1a\n and more than enough bytes"), "not a tool model");
  COMPARE_CONTAINS(errorFor(QByteArray("BWTOOL\r\n\x02\0\0\0", 12) + QByteArray(200, 'x')),
                   "version 2");
  COMPARE_CONTAINS(errorFor(QByteArray("BWTOOL\r\n\x01\0\0\0", 12) + QByteArray(200, '\xFF')),
                   "damaged");
  COMPARE_CONTAINS(errorOf([&] { loadToolModel(m_folder.path("absent").string()); }), "absent");
}

void TestToolModel::failedSaveLeavesTheOldFile() {
  const std::string nowhere = m_folder.path("no/such/folder/tool.model").string();
  COMPARE_CONTAINS(errorOf([&] { saveToolModel(modelOf(1, 1), nowhere); }), "cannot be written");
}

void TestToolModel::mergesInEqualShares() {
  const std::vector<ToolModel> models = {modelOf(ToolModel::maxPositives, 10),
                                         modelOf(ToolModel::maxPositives, 20, 5000)};
  const ToolModel merged = mergeToolModels(models);
  QCOMPARE(merged.size, models[0].size);
  QCOMPARE(merged.positives.size(), ToolModel::maxPositives);
  QCOMPARE(merged.negatives.size(), std::size_t{30});
  QCOMPARE(merged.leaves[3].positive, std::uint16_t{14});
  QCOMPARE(merged.leaves[3].negative, std::uint16_t{4});
  // 2 x 65535 against 2: halved together.
  QCOMPARE(merged.leaves.back().positive, std::uint16_t{65535});
  QCOMPARE(merged.leaves.back().negative, std::uint16_t{1});
  QVERIFY(mergeToolModels(std::span(models).first(1)) == models[0]);
}

void TestToolModel::refusesToMergeOtherShapes() {
  COMPARE_CONTAINS(errorOf([] { mergeToolModels({}); }), "none to merge");
  std::vector<ToolModel> models = {modelOf(1, 1), ToolModel()};
  models[1].size = {30.0, 60.0};
  COMPARE_CONTAINS(errorOf([&] { mergeToolModels(models); }), "one shape");
}

void TestToolModel::forgetsWhatIsReplaced() {
  const cv::Size size(15, 15);
  LearntPatches patches({}, size, 20);
  const cv::Mat oldest = noise(size, 1);
  const cv::Mat rare = noise(size, 2);
  patches.add(oldest);
  patches.add(rare);
  // A thousand that are all like the first, but for one pixel.
  for (int i = 0; i < 1000; ++i) {
    cv::Mat alike = oldest.clone();
    alike.at<uchar>(i % 15, i / 15 % 15) ^= 64;
    patches.add(alike);
    QVERIFY(patches.patches().size() <= 20);
  }
  QCOMPARE(cv::norm(patches.patches()[0], oldest), 0.0);
  QCOMPARE(cv::norm(patches.patches()[1], rare), 0.0);
}

BOOMWATCH_TEST(TestToolModel)
#include "test_tool_model.moc"
