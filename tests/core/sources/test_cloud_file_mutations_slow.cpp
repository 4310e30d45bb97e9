#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <functional>
#include <random>

#include "pipeline/parameter_checks.h"
#include "pipeline/preset_file.h"
#include "sources/cloud_file.h"
#include "sources/depth_calibration.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

constexpr int changedCopies = 3000;

QByteArray contents(const std::filesystem::path& file) {
  QFile in(QString::fromStdString(file.string()));
  if (!in.open(QIODevice::ReadOnly)) qFatal("cannot read a file just written");
  return in.readAll();
}

/// One to four bytes changed, a piece cut out, a piece doubled, or a number of the text replaced.
QByteArray mutated(QByteArray bytes, std::mt19937& random) {
  const auto below = [&](qsizetype n) { return qsizetype(random() % std::uint32_t(n)); };
  switch (random() % 5) {
    case 0:
      bytes.remove(below(bytes.size()), 1 + below(16));
      break;
    case 1: {
      const qsizetype at = below(bytes.size());
      bytes.insert(at, bytes.mid(at, 1 + below(16)));
      break;
    }
    case 2: {
      const char* numbers[] = {"-1",         "0",        "4294967295", "99999999999999999999",
                               "2147483648", "50000000", "nan",        "9223372036854775807"};
      qsizetype at = below(bytes.size());
      while (at < bytes.size() && !std::isdigit(static_cast<unsigned char>(bytes[at]))) ++at;
      qsizetype end = at;
      while (end < bytes.size() && std::isdigit(static_cast<unsigned char>(bytes[end]))) ++end;
      bytes.replace(at, end - at, numbers[random() % std::size(numbers)]);
      break;
    }
    default:
      for (qsizetype k = below(4); k >= 0; --k) bytes[below(bytes.size())] = char(random());
  }
  return bytes;
}

/// What a reader makes of any bytes: an answer or an Error, nothing else. Returns how many were
/// answers.
int readEveryMutation(const QString& name, const QByteArray& original,
                      const std::function<void(const std::filesystem::path&)>& read) {
  const TemporaryFolder folder;
  int answers = 0;
  const auto attempt = [&](const QByteArray& bytes) {
    const auto file = folder.write(name, bytes);
    answers += errorOf([&] { read(file); }).isEmpty();
  };
  for (qsizetype length = 0; length <= original.size(); ++length) attempt(original.left(length));
  std::mt19937 random(11);
  for (int k = 0; k < changedCopies; ++k) attempt(mutated(original, random));
  return answers;
}

void readSoundly(const std::filesystem::path& file) {
  const CloudFile read = readCloudFile(file);
  const Cloud& cloud = *read.cloud;
  QVERIFY(cloud.width > 0 && cloud.height > 0);
  QCOMPARE(cloud.size(), std::size_t(cloud.width) * std::size_t(cloud.height));
  // A byte of LZF gives at most 88; a scalar takes at least one byte, a point three scalars.
  QVERIFY(cloud.size() <= 88 * std::filesystem::file_size(file));
  QVERIFY(read.image.empty() || read.image.size() == cv::Size(cloud.width, cloud.height));
  QVERIFY(read.labels.empty() || read.labels.size() == cloud.size());
  for (const auto& p : cloud.points) QVERIFY(isMeasured(p) || p.array().isNaN().all());
}

}  // namespace

class TestCloudFileMutations : public QObject {
  Q_OBJECT
 private slots:
  void noPcdBreaksTheReader_data() {
    QTest::addColumn<int>("encoding");
    QTest::newRow("ascii") << 0;
    QTest::newRow("binary") << 1;
    QTest::newRow("compressed") << 2;
  }
  void noPcdBreaksTheReader() {
    QFETCH(int, encoding);
    pcl::PointCloud<pcl::PointXYZRGBL> cloud(4, 3);
    for (std::size_t k = 0; k < cloud.size(); ++k) {
      cloud[k].getVector3fMap() = Eigen::Vector3f(0.1F * float(k), -1.0F, 3.0F);
      cloud[k].rgba = 0xff102030U;
      cloud[k].label = 7;
    }
    const TemporaryFolder folder;
    const auto file = folder.path("sound.pcd");
    pcl::PCDWriter writer;
    if (encoding == 0) writer.writeASCII(file.string(), cloud);
    if (encoding == 1) writer.writeBinary(file.string(), cloud);
    if (encoding == 2) writer.writeBinaryCompressed(file.string(), cloud);
    QVERIFY(readEveryMutation("changed.pcd", contents(file), readSoundly) > 0);
  }

  void noPlyBreaksTheReader_data() {
    QTest::addColumn<QByteArray>("body");
    QTest::newRow("ascii") << QByteArray(
        "1 2 3 4 5 6\n1.5 2.5 3.5 7 8 9\n0 0 0 0 0 0\n-1 2 nan 1 2 3\n");
    QTest::newRow("binary_little_endian") << QByteArray(4 * 15, '@');
    QTest::newRow("binary_big_endian") << QByteArray(4 * 15, '@');
  }
  void noPlyBreaksTheReader() {
    QFETCH(QByteArray, body);
    const QByteArray bytes =
        QByteArray("ply\nformat ") + QTest::currentDataTag() +
        " 1.0\ncomment by hand\nobj_info num_cols 2\nobj_info num_rows 2\nelement vertex 4\n"
        "property float x\nproperty float y\nproperty float z\nproperty uchar red\n"
        "property uchar green\nproperty uchar blue\nelement face 0\n"
        "property list uchar int vertex_indices\nend_header\n" +
        body;
    QVERIFY(readEveryMutation("changed.ply", bytes, readSoundly) > 0);
  }

  void noPresetBreaksTheReader() {
    const TemporaryFolder folder;
    savePreset(folder.path("sound.yaml"), {});
    const auto read = [](const std::filesystem::path& file) { validate(loadPreset(file)); };
    QVERIFY(readEveryMutation("changed.yaml", contents(folder.path("sound.yaml")), read) > 0);
  }

  void noIntrinsicsBreakTheReader_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("yaml") << QByteArray(
        "%YAML:1.0\n---\ncamera_matrix: !!opencv-matrix\n  rows: 3\n  cols: 3\n  dt: d\n"
        "  data: [ 525., 0., 320., 0., 525., 240., 0., 0., 1. ]\ndepth_factor: 1000.\n");
    QTest::newRow("xml") << QByteArray(
        "<?xml version=\"1.0\"?>\n<opencv_storage>\n<intrinsic type_id=\"opencv-matrix\">\n"
        "<rows>3</rows><cols>3</cols><dt>f</dt>\n"
        "<data>525. 0. 320. 0. 525. 240. 0. 0. 1.</data></intrinsic>\n</opencv_storage>\n");
    QTest::newRow("json") << QByteArray("{\"fx\": 525.0, \"fy\": 525, \"cx\": 320, \"cy\": 240}");
  }
  void noIntrinsicsBreakTheReader() {
    QFETCH(QByteArray, bytes);
    const auto read = [](const std::filesystem::path& file) {
      const auto [camera, unitsPerMetre] = readDepthCalibration(file);
      QVERIFY(camera.fx > 0.0 && camera.fy > 0.0 && unitsPerMetre > 0.0);
    };
    const QString name = QString("changed.") + QTest::currentDataTag();
    QVERIFY(readEveryMutation(name, bytes, read) > 0);
  }
};

BOOMWATCH_TEST(TestCloudFileMutations)
#include "test_cloud_file_mutations_slow.moc"
