#include <QtTest>
#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "open_source.h"
#include "pipeline/pipeline.h"
#include "sources/cloud_file.h"
#include "sources/frame_source.h"
#include "support/build_paths.h"
#include "support/compare_near.h"
#include "support/real_data.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

std::shared_ptr<const Cloud> cloudOf(const std::filesystem::path& file) {
  const auto source = openSource("map:" + file.string());
  return source->next(std::chrono::milliseconds(0)).frame->cloud;
}

QString refusal(const std::filesystem::path& file) {
  return errorOf([&] { openSource("map:" + file.string()); });
}

const QByteArray slope =
    "ncols 3\nnrows 2\nxllcorner 500000\nyllcorner 5000000\ncellsize 2\nNODATA_value -9999\n"
    "1 2 3\n4 5 -9999\n";

}  // namespace

class TestMapSource : public QObject {
  Q_OBJECT
 private slots:
  void aGridIsSeenFromAbove();
  void betweenCellsItIsInterpolated();
  void aPictureIsDescribed();
  void isTheEnvironmentOfALoad();
  void refuses_data();
  void refuses();
  void terrainFromTheAir();
};

void TestMapSource::aGridIsSeenFromAbove() {
  const TemporaryFolder folder;
  folder.write("slope.asc", slope);
  const auto cloud = cloudOf(
      folder.write("slope.yaml", "file: slope.asc\nkind: height\ncamera_height: 20\nspacing: 2\n"));
  QCOMPARE(cloud->width, 3);
  QCOMPARE(cloud->height, 2);
  // The first value is the north-west corner: up in the picture, left.
  QCOMPARE(cloud->at(0, 0), Eigen::Vector3f(-2.0F, -1.0F, 19.0F));
  QCOMPARE(cloud->at(1, 1), Eigen::Vector3f(0.0F, 1.0F, 15.0F));
  QVERIFY(!isMeasured(cloud->at(2, 1)));
  QVERIFY(!cloud->camera);
}

void TestMapSource::betweenCellsItIsInterpolated() {
  const TemporaryFolder folder;
  const auto cloud = cloudOf(folder.write("slope.asc", slope));
  QCOMPARE(cloud->width, 150);
  // 10 m above the highest, 5: along the first row a slope of 1 in 2.
  for (int column = 25; column < 125; ++column) {
    const Eigen::Vector3f& p = cloud->at(column, 0);
    BW_COMPARE_NEAR(p.z(), 15.0F - (2.0F + p.x() / 2.0F), 1e-4F);
  }
  QVERIFY(!isMeasured(cloud->at(120, 60)));
}

void TestMapSource::aPictureIsDescribed() {
  const TemporaryFolder folder;
  cv::Mat depth(20, 30, CV_16UC1, cv::Scalar(4000));
  depth.at<std::uint16_t>(0, 0) = 0;
  cv::imwrite((folder.path() / "depth.png").string(), depth);
  const auto cloud = cloudOf(folder.write(
      "map.yaml",
      "file: depth.png\nkind: depth\nmetres_per_pixel: 0.1\nleft: 1\ntop: -2\nspacing: 0.1"));
  QCOMPARE(cloud->width, 30);
  QVERIFY(!isMeasured(cloud->at(0, 0)));
  QVERIFY((cloud->at(29, 19) - Eigen::Vector3f(3.95F, -0.05F, 4.0F)).norm() < 1e-4F);
}

void TestMapSource::isTheEnvironmentOfALoad() {
  const TemporaryFolder folder;
  QByteArray flat = "ncols 6\nnrows 6\ncellsize 1\n";
  for (int n = 0; n < 36; ++n) flat += "100 ";
  const auto source = openSource("map:" + folder.write("flat.asc", flat).string());
  Parameters parameters;
  parameters.bounds.zMax = 12.0;
  parameters.load = {.source = LoadSource::Manual, .z = 6.0};
  Pipeline pipeline;
  Result result;
  for (int n = 0; n < 6; ++n) {
    result = pipeline.process(source->next(std::chrono::milliseconds(0)).frame, parameters);
  }
  QVERIFY(result.clearance.nearest);
  const double error = result.clearance.nearest->distance - (10.0 - 6.15);
  BW_COMPARE_NEAR(error, 0.0, result.clearance.nearest->quantisation + 1e-4);
}

void TestMapSource::refuses_data() {
  QTest::addColumn<QByteArray>("name");
  QTest::addColumn<QByteArray>("content");
  QTest::addColumn<QByteArray>("part");
  const auto add = [](const char* title, const char* name, const char* content, const char* part) {
    QTest::newRow(title) << QByteArray(name) << QByteArray(content) << QByteArray(part);
  };
  add("no columns", "a.asc", "nrows 2\ncellsize 1\n1 2\n", "'ncols'");
  add("too short", "a.asc", "ncols 2\nnrows 2\ncellsize 1\n1 2 3\n", "ends before");
  add("too long", "a.asc", "ncols 1\nnrows 1\ncellsize 1\n1 2\n", "line 4");
  add("a word", "a.asc", "ncols 2\nnrows 1\ncellsize 1\n1 x\n", "'x' is not a number");
  add("claims too much", "a.asc", "ncols 90000\nnrows 90000\ncellsize 1\n1\n", "too short");
  add("nothing known", "a.asc", "ncols 1\nnrows 1\ncellsize 1\nNODATA_value 7\n7\n", "no cell");
  add("too many points", "a.asc", "ncols 1\nnrows 2\ncellsize 90000\n1 2\n", "spacing");
  add("empty", "a.asc", "", "a.asc");
  add("another kind", "a.tif", "xx", "not a map");
  add("no kind", "a.yaml", "file: x.png\n", "'kind'");
  add("no file", "a.yaml", "kind: depth\n", "'file'");
  add("file is missing", "a.yaml", "kind: depth\nfile: x.png\n", "x.png");
  add("unknown key", "a.yaml", "kind: depth\nfiel: x.png\n", "'fiel'");
  add("not a number", "a.yaml", "kind: depth\nfile: b.png\nmetres_per_pixel: much\n", "'much'");
  add("no scale", "a.yaml", "kind: depth\nfile: b.png\n", "'metres_per_pixel'");
  add("colours", "a.yaml", "kind: depth\nfile: c.png\nmetres_per_pixel: 1\n", "one channel");
  add("a list", "a.yaml", "- 1\n", "not a map's description");
  add("not YAML", "a.yaml", "a: [\n", "not YAML");
}

void TestMapSource::refuses() {
  QFETCH(QByteArray, name);
  QFETCH(QByteArray, content);
  QFETCH(QByteArray, part);
  const TemporaryFolder folder;
  cv::imwrite((folder.path() / "b.png").string(), cv::Mat(4, 4, CV_16UC1, cv::Scalar(1000)));
  cv::imwrite((folder.path() / "c.png").string(), cv::Mat(4, 4, CV_8UC3, cv::Scalar(9, 9, 9)));
  const QString message = refusal(folder.write(name, content));
  COMPARE_CONTAINS(message, part);
}

/// ISPRS's airborne laser points, put into a grid of 1 m here: the map must go through them.
void TestMapSource::terrainFromTheAir() {
  const auto file = sharedData("terrain_isprs_als/samp11-utm-ground.pcd").toStdString();
  if (!std::filesystem::exists(file)) QSKIP("the terrain of ../shared/data is not here");
  const auto ground = readCloudFile(file).cloud;
  Eigen::AlignedBox3f box;
  for (const auto& p : ground->points) {
    if (isMeasured(p)) box.extend(p);
  }
  const int columns = static_cast<int>(box.sizes().x()) + 1;
  const int rows = static_cast<int>(box.sizes().y()) + 1;
  cv::Mat heights(rows, columns, CV_64FC1, cv::Scalar(-9999));
  for (const auto& p : ground->points) {
    if (!isMeasured(p)) continue;
    const int column = static_cast<int>(p.x() - box.min().x());
    const int row = rows - 1 - static_cast<int>(p.y() - box.min().y());
    heights.at<double>(row, column) = static_cast<double>(p.z());
  }
  QByteArray grid = "ncols " + QByteArray::number(columns) + "\nnrows " + QByteArray::number(rows) +
                    "\ncellsize 1\nNODATA_value -9999\n";
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      grid += QByteArray::number(heights.at<double>(row, column), 'f', 3) + " ";
    }
  }
  const TemporaryFolder folder;
  folder.write("terrain.asc", grid);
  const auto cloud = cloudOf(folder.write(
      "terrain.yaml", "file: terrain.asc\nkind: height\ncamera_height: 500\nspacing: 1\n"));
  int compared = 0;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double height = heights.at<double>(row, column);
      const Eigen::Vector3f& p = cloud->at(column, row);
      if (height < -9000) continue;
      if (!isMeasured(p)) continue;  // a neighbour is not known
      BW_COMPARE_NEAR(static_cast<double>(p.z()), 500.0 - height, 1e-2);
      ++compared;
    }
  }
  QVERIFY2(compared > 1000, qPrintable(QString::number(compared)));
}

BOOMWATCH_TEST(TestMapSource)
#include "test_map_source.moc"
