#include <QDirIterator>
#include <QtTest>
#include <functional>
#include <map>
#include <opencv2/imgproc.hpp>

#include "load/load_detector.h"
#include "sources/cloud_file.h"
#include "support/real_data.h"
#include "support/test_registry.h"
#include "tracking/tool_point.h"

using namespace boomwatch;
using Eigen::Vector3f;

namespace {

constexpr double depthNoise = 0.0014;  // a Kinect's, 1/m
constexpr Bounds everywhere{-10, 10, -10, 10, 0, 20};

/// There is no tool in these pictures: the tool point lies on the thing itself.
LoadDetection boxAt(const Cloud& cloud, const Vector3f& tool, double maxSize) {
  LoadParameters parameters;
  parameters.shape = LoadShape::Box;
  parameters.toolSize = 0.0;
  parameters.maxSize = maxSize;
  return detectLoad(cloud, tool, depthNoise, everywhere, parameters);
}

double enclosedShare(const OrientedBox& box, const Points& points) {
  const auto inside = std::count_if(points.begin(), points.end(), [&](const Vector3f& p) {
    return box.contains(p.cast<double>());
  });
  return static_cast<double>(inside) / static_cast<double>(points.size());
}

/// Of `points` the one seen nearest to their middle.
Vector3f middleOf(const Points& points) {
  Vector3f mean = Vector3f::Zero();
  for (const Vector3f& p : points) mean += p / static_cast<float>(points.size());
  const auto off = [&](const Vector3f& p) { return (p / p.z() - mean / mean.z()).norm(); };
  return *std::min_element(points.begin(), points.end(),
                           [&](const Vector3f& a, const Vector3f& b) { return off(a) < off(b); });
}

/// What was measured inside an outline that was drawn by hand into the picture, nearer than
/// `depth`.
Points inside(const Cloud& cloud, const std::vector<cv::Point>& outline, float depth = 20.0F) {
  Points points;
  for (int row = 0; row < cloud.height; ++row) {
    for (int column = 0; column < cloud.width; ++column) {
      const Vector3f& p = cloud.at(column, row);
      const cv::Point2f pixel(static_cast<float>(column), static_cast<float>(row));
      if (!isMeasured(p) || p.z() > depth) continue;
      if (cv::pointPolygonTest(outline, pixel, false) > 0.0) points.push_back(p);
    }
  }
  return points;
}

QString pclExample(const QString& name) {
  QDirIterator files(QStringLiteral("/usr/share/doc/python3-pcl"), {name}, QDir::Files,
                     QDirIterator::Subdirectories);
  return files.hasNext() ? files.next() : QString();
}

/// Some clouds have y up and z backwards.
Cloud turned(const Cloud& cloud) {
  Cloud result = cloud;
  for (Vector3f& p : result.points) p = {p.x(), -p.y(), -p.z()};
  return result;
}

/// Labels are written by hand: 1 to 9 is the table, and then ten numbers an object, from 20 on.
Points labelled(const CloudFile& file, unsigned first, unsigned last) {
  Points points;
  for (std::size_t k = 0; k < file.labels.size(); ++k) {
    const Vector3f& p = file.cloud->points[k];
    if (file.labels[k] >= first && file.labels[k] <= last && isMeasured(p)) points.push_back(p);
  }
  return points;
}

/// Height above the plane that fits `floor` best; what lies far off that is left out.
std::function<double(const Vector3f&)> heightAbove(const Points& floor) {
  constexpr float off = 0.03F;
  Vector3f plane = Vector3f::Zero();  // z = plane . (x, y, 1)
  for (int round = 0; round < 3; ++round) {
    Eigen::Matrix3f left = Eigen::Matrix3f::Zero();
    Vector3f right = Vector3f::Zero();
    for (const Vector3f& p : floor) {
      const Vector3f row(p.x(), p.y(), 1.0F);
      if (!isMeasured(p) || (round > 0 && std::abs(p.z() - plane.dot(row)) > off)) continue;
      left += row * row.transpose();
      right += row * p.z();
    }
    plane = left.ldlt().solve(right);
  }
  const float length = std::hypot(plane.x(), plane.y(), 1.0F);
  return
      [=](const Vector3f& p) { return (plane.dot(Vector3f(p.x(), p.y(), 1.0F)) - p.z()) / length; };
}

/// The box of the thing at `tool`, if it encloses its `points`.
std::optional<OrientedBox> enclosing(const Points& points, const Cloud& cloud, const Vector3f& tool,
                                     double maxSize) {
  const LoadDetection found = boxAt(cloud, tool, maxSize);
  if (!found.box) {
    qWarning("refused: %s", std::string(toString(found.fault)).c_str());
    return std::nullopt;
  }
  const Eigen::Vector3d& size = found.box->size;
  const double enclosed = enclosedShare(*found.box, points);
  qInfo("%.3f x %.3f x %.3f m, encloses %.1f %%", size.x(), size.y(), size.z(), 100.0 * enclosed);
  return enclosed >= 0.95 ? found.box : std::nullopt;
}

}  // namespace

/// The load detector on what real sensors saw: boxes, a carton, a mug and a person, as stand-ins
/// for loads.
class TestRealLoads : public QObject {
  Q_OBJECT
 private slots:
  /// On a table, which must not be taken for a part of them. Of two that stand on each other
  /// nothing says that they are not one. Looked for up to 0.36 m around it, test3's first goes over
  /// into what is beside it, and is refused.
  void aLabelledBoxIsEnclosed_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<unsigned>("first");
    QTest::addColumn<unsigned>("last");
    QTest::addColumn<double>("maxSize");
    QTest::newRow("learn0 1") << QStringLiteral("learn0") << 20U << 29U << 0.6;
    QTest::newRow("learn0 2") << QStringLiteral("learn0") << 30U << 39U << 0.6;
    QTest::newRow("test3 1") << QStringLiteral("test3") << 20U << 29U << 0.5;
    QTest::newRow("test3 2") << QStringLiteral("test3") << 30U << 39U << 0.6;
    QTest::newRow("learn20, stacked") << QStringLiteral("learn20") << 20U << 39U << 0.6;
  }
  void aLabelledBoxIsEnclosed() {
    QFETCH(QString, name);
    QFETCH(unsigned, first);
    QFETCH(unsigned, last);
    QFETCH(double, maxSize);
    const QString path = sharedData(QStringLiteral("pcd_labelled_mosd/%1.pcd").arg(name));
    REQUIRE_DATA(path);
    const CloudFile file = readCloudFile(path.toStdString());
    const Points points = labelled(file, first, last);
    QVERIFY(points.size() > 1000);
    const auto box = enclosing(points, *file.cloud, middleOf(points), maxSize);
    QVERIFY(box);
    const Points table = labelled(file, 1, 9);
    QVERIFY(table.size() > 1000);
    QVERIFY(enclosedShare(*box, table) < 0.005);
  }

  /// By a stereo camera whose floor was recorded without the box as well. The floor by itself is no
  /// load.
  void aBoxOnAFloorIsEnclosedAndNoMore() {
    const QString path = sharedData(QStringLiteral("pcd_boxes_oakd/calibration/%1.ply"));
    REQUIRE_DATA(path.arg(QStringLiteral("box")));
    const auto read = [&](const char* name) {
      return turned(*readCloudFile(path.arg(QLatin1String(name)).toStdString()).cloud);
    };
    const Cloud floor = read("calibration"), cloud = read("box");
    const auto height = heightAbove(floor.points);
    Points points;
    for (const Vector3f& p : cloud.points) {
      if (isMeasured(p) && height(p) > 0.04 && p.x() < 0.5F) points.push_back(p);
    }
    QVERIFY(points.size() > 3000);
    const auto box = enclosing(points, cloud, middleOf(points), 1.2);
    QVERIFY(box);
    std::vector<double> heights;
    for (const Vector3f& p : points) heights.push_back(height(p));
    std::ranges::nth_element(heights, heights.begin() + std::ssize(heights) / 2);
    const double high = heights[heights.size() / 2];
    qInfo("its top is %.3f m above the floor", high);
    QVERIFY(box->size.minCoeff() < 1.3 * high);
    QVERIFY(!boxAt(floor, middleOf(floor.points), 1.2).box);
  }

  /// By a stereo camera, on a table. Its volume is not known, but no mug is larger than this with
  /// its handle.
  void aMugIsEnclosedAndNoMore() {
    constexpr double largest = 0.13;
    const QString path =
        sharedData(QStringLiteral("pcd_organised_pcl/table_scene_mug_stereo_textured.pcd"));
    REQUIRE_DATA(path);
    const Cloud cloud = *readCloudFile(path.toStdString()).cloud;
    const Points points = inside(cloud, {{340, 250},
                                         {355, 243},
                                         {370, 234},
                                         {428, 240},
                                         {448, 258},
                                         {437, 275},
                                         {432, 300},
                                         {432, 340},
                                         {425, 356},
                                         {408, 366},
                                         {385, 369},
                                         {365, 363},
                                         {350, 348},
                                         {349, 300},
                                         {341, 265}});
    QVERIFY(points.size() > 5000);
    const auto tool = toolPointAt(cloud, {395, 320});
    QVERIFY(tool);
    const auto box = enclosing(points, cloud, *tool, 0.25);
    QVERIFY(box);
    QVERIFY(box->size.maxCoeff() < largest);
  }

  /// The nearest of five, who stands 0.5 m before the others; the feet are out of the picture.
  void aPersonIsEnclosedAndNoMore() {
    const QString path = sharedData(QStringLiteral("pcd_organised_pcl/five_people.pcd"));
    REQUIRE_DATA(path);
    const Cloud cloud = *readCloudFile(path.toStdString()).cloud;
    const Points points = inside(
        cloud, {{445, 470}, {465, 200}, {500, 45}, {570, 45}, {610, 150}, {570, 470}}, 2.15F);
    QVERIFY(points.size() > 20000);
    const auto tool = toolPointAt(cloud, {540, 250});
    QVERIFY(tool);
    const auto box = enclosing(points, cloud, *tool, 2.5);
    QVERIFY(box);
    const Eigen::Vector3d& size = box->size;
    QVERIFY(size.maxCoeff() < 1.8 && size.prod() < 1.8 * 0.6 * 0.35);
  }

  /// A half-gallon carton is 95 mm square and 248 mm high with its gable.
  void aMilkCartonIsEnclosedAndNoMore() {
    const QString path = pclExample(QStringLiteral("milk_cartoon_all_small_clorox.pcd"));
    if (path.isEmpty()) QSKIP("python3-pcl does not bring the carton");
    constexpr double volume = 0.095 * 0.095 * 0.248;
    const Cloud cloud = turned(*readCloudFile(path.toStdString()).cloud);
    const Points points = inside(
        cloud, {{240, 92}, {250, 72}, {303, 62}, {321, 97}, {319, 206}, {278, 222}, {248, 205}});
    QVERIFY(points.size() > 3000);
    const auto tool = toolPointAt(cloud, {285, 150});
    QVERIFY(tool);
    const auto box = enclosing(points, cloud, *tool, 0.6);
    QVERIFY(box);
    qInfo("%.2f of the carton's volume", box->size.prod() / volume);
    QVERIFY(box->size.prod() < 1.3 * volume);
  }

  void theFloorBesideTheCartonIsNoLoad() {
    const QString path = pclExample(QStringLiteral("milk_cartoon_all_small_clorox.pcd"));
    if (path.isEmpty()) QSKIP("python3-pcl does not bring the carton");
    const Cloud cloud = turned(*readCloudFile(path.toStdString()).cloud);
    const auto tool = toolPointAt(cloud, {320, 300});
    QVERIFY(tool);
    QVERIFY(!boxAt(cloud, *tool, 0.6).box);
  }
};

BOOMWATCH_TEST(TestRealLoads)
#include "test_real_loads.moc"
