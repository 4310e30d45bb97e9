#include <pcl/io/pcd_io.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>

#include <QDirIterator>
#include <QtTest>
#include <map>
#include <numeric>
#include <random>

#include "cloud/clusters.h"
#include "cloud/voxel_grid.h"
#include "support/real_data.h"
#include "support/test_registry.h"

using boomwatch::Clusters;
using boomwatch::Points;
using Eigen::Vector3f;

namespace {

using Labels = std::vector<std::int32_t>;

/// Labels in the order in which the points first name them, whatever they were called before.
Labels renamed(const Labels& labels) {
  std::map<std::int32_t, std::int32_t> names;
  Labels result;
  for (const auto label : labels) {
    const auto next = static_cast<std::int32_t>(names.size());
    result.push_back(label < 0 ? label : names.emplace(label, next).first->second);
  }
  return result;
}

Labels labelsOfPcl(const Points& points, float tolerance) {
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (const auto& p : points) cloud->push_back({p.x(), p.y(), p.z()});
  const pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>(false));
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
  extraction.setSearchMethod(tree);
  extraction.setClusterTolerance(tolerance);
  extraction.setMinClusterSize(1);
  extraction.setMaxClusterSize(std::numeric_limits<pcl::uindex_t>::max());
  extraction.setInputCloud(cloud);
  std::vector<pcl::PointIndices> found;
  extraction.extract(found);
  Labels labels(points.size(), -1);
  for (std::size_t c = 0; c < found.size(); ++c) {
    for (const auto i : found[c].indices) {
      labels[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(c);
    }
  }
  return renamed(labels);
}

/// Every pair of points, in floats.
Labels labelsByBruteForce(const Points& points, float tolerance) {
  Labels labels(points.size());
  std::iota(labels.begin(), labels.end(), 0);
  const float limit = tolerance * tolerance;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vector3f d = points[i] - points[j];
      if (d.x() * d.x() + d.y() * d.y() + d.z() * d.z() >= limit) continue;
      std::replace(labels.begin(), labels.end(), labels[i], labels[j]);
    }
  }
  return renamed(labels);
}

Points randomPoints(std::size_t count, float extent, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> coordinate(-extent, extent);
  Points points;
  while (points.size() < count) {
    points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  }
  return points;
}

Points measuredPoints(const QString& pcd) {
  pcl::PointCloud<pcl::PointXYZ> cloud;
  Points points;
  if (pcl::io::loadPCDFile(pcd.toStdString(), cloud) != 0) return points;
  for (const auto& p : cloud) {
    if (boomwatch::isMeasured(p.getVector3fMap())) points.emplace_back(p.x, p.y, p.z);
  }
  return points;
}

QStringList cloudsBelow(const QString& folder) {
  QStringList files;
  QDirIterator entries(folder, {"*.pcd"}, QDir::Files, QDirIterator::Subdirectories);
  while (entries.hasNext()) files << entries.next();
  files.sort();
  return files;
}

/// PCL takes a second for 100,000 points, and far longer where a ball holds many.
void compareWithPcl(const QString& folder, std::initializer_list<float> tolerances) {
  const QStringList files = cloudsBelow(folder);
  QVERIFY(!files.isEmpty());
  for (const QString& file : files) {
    const Points raw = measuredPoints(file);
    QVERIFY2(!raw.empty(), qPrintable(file));
    for (const float tolerance : tolerances) {
      const Points points = boomwatch::voxelCentroids(raw, tolerance / 2.5, Vector3f::Zero());
      const Clusters clusters = boomwatch::euclideanClusters(points, tolerance);
      QVERIFY2(clusters.labels == labelsOfPcl(points, tolerance),
               qPrintable(QString("%1 at %2 m").arg(file).arg(double(tolerance))));
    }
  }
}

}  // namespace

class TestClusters : public QObject {
  Q_OBJECT

 private slots:
  void agreesWithPclOnRandomPoints_data() {
    QTest::addColumn<float>("extent");
    QTest::addColumn<float>("tolerance");
    QTest::newRow("nearly all alone") << 10.0F << 0.2F;
    QTest::newRow("some chains") << 3.0F << 0.2F;
    QTest::newRow("near the point where all join") << 1.7F << 0.2F;
    QTest::newRow("all in one") << 1.0F << 0.2F;
    QTest::newRow("a few cells") << 0.2F << 0.2F;
    QTest::newRow("one millimetre") << 0.01F << 0.001F;
    QTest::newRow("ten metres") << 200.0F << 10.0F;
  }
  void agreesWithPclOnRandomPoints() {
    QFETCH(float, extent);
    QFETCH(float, tolerance);
    for (unsigned seed = 0; seed < 5; ++seed) {
      const Points points = randomPoints(5000, extent, seed);
      QCOMPARE(boomwatch::euclideanClusters(points, tolerance).labels,
               labelsOfPcl(points, tolerance));
    }
  }

  void agreesWithPclWherePointsAreDuplicated() {
    Points points = randomPoints(1000, 1.5F, 7);
    const Points copies = points;
    points.insert(points.end(), copies.begin(), copies.end());
    points.insert(points.end(), 500, copies.front());
    QCOMPARE(boomwatch::euclideanClusters(points, 0.2F).labels, labelsOfPcl(points, 0.2F));
  }

  void agreesWithBruteForceOnPointsSpacedByTheTolerance() {
    // Quantised coordinates put many pairs at the tolerance to the last bit.
    for (const float step : {0.1F, 0.125F, 0.04F, 1.0F / 3.0F}) {
      Points points;
      for (const auto& p : randomPoints(400, 6.0F, 11)) {
        points.push_back(step * p.array().round().matrix());
      }
      for (const float tolerance : {step, std::nextafter(step, 1.0F), 1.5F * step, 1.74F * step}) {
        QCOMPARE(boomwatch::euclideanClusters(points, tolerance).labels,
                 labelsByBruteForce(points, tolerance));
      }
    }
  }

  void aStepOfExactlyTheToleranceDoesNotJoin() {
    const Points points{{0, 0, 0}, {0.5F, 0, 0}};
    QCOMPARE(boomwatch::euclideanClusters(points, 0.5F).sizes.size(), std::size_t{2});
    QCOMPARE(boomwatch::euclideanClusters(points, std::nextafter(0.5F, 1.0F)).sizes.size(),
             std::size_t{1});
  }

  void labelsAreInOrderOfFirstAppearanceAndSizesCount() {
    const Points points{
        {5, 0, 0}, {0, 0, 0}, boomwatch::unmeasuredPoint(), {5.05F, 0, 0}, {9, 9, 9}};
    const Clusters clusters = boomwatch::euclideanClusters(points, 0.1F);
    QCOMPARE(clusters.labels, (Labels{0, 1, Clusters::noCluster, 0, 2}));
    QCOMPARE(clusters.sizes, (Labels{2, 1, 1}));
  }

  void takesWhateverItIsFed() {
    const float infinity = std::numeric_limits<float>::infinity();
    QVERIFY(boomwatch::euclideanClusters({}, 0.1F).sizes.empty());
    QCOMPARE(boomwatch::euclideanClusters(Points{{1, 2, 3}}, 0.1F).labels, (Labels{0}));
    QCOMPARE(boomwatch::euclideanClusters(Points(100'000, {1, 2, 3}), 0.1F).sizes,
             (Labels{100'000}));
    const Points nothing(5, boomwatch::unmeasuredPoint());
    QCOMPARE(boomwatch::euclideanClusters(nothing, 0.1F).labels, Labels(5, Clusters::noCluster));
    QCOMPARE(boomwatch::euclideanClusters(Points{{infinity, 0, 0}, {0, 0, 0}}, 0.1F).labels,
             (Labels{Clusters::noCluster, 0}));
    for (const float tolerance : {0.0F, -1.0F, std::nanf("")}) {
      QCOMPARE(boomwatch::euclideanClusters(Points(3, {1, 2, 3}), tolerance).labels,
               (Labels{0, 1, 2}));
    }
    QCOMPARE(boomwatch::euclideanClusters(Points{{-1, 0, 0}, {1, 0, 0}}, infinity).labels,
             (Labels{0, 0}));
  }

  void aHugeExtentCostsNeitherMemoryNorPrecision() {
    Points points = randomPoints(2000, 0.01F, 3);
    const Labels near = labelsOfPcl(points, 0.001F);
    QVERIFY(*std::max_element(near.begin(), near.end()) > 10);
    for (const float far : {1e6F, 1e12F, 3e38F}) {
      Points spread = points;
      spread.emplace_back(-far, far, far);
      spread.emplace_back(far, -far, -far);
      Labels expected = near;
      expected.push_back(*std::max_element(near.begin(), near.end()) + 1);
      expected.push_back(expected.back() + 1);
      QCOMPARE(boomwatch::euclideanClusters(spread, 0.001F).labels, expected);
    }
  }

  void twoDenseSheetsJustOutOfReachEndInTime() {
    // Each is one cell's worth of points; the product of their sizes would take minutes.
    Points points;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> coordinate(0.0F, 5.0F);
    for (int i = 0; i < 200'000; ++i) {
      points.emplace_back(coordinate(random), coordinate(random), i % 2 ? 0.0F : 10.001F);
    }
    QCOMPARE(boomwatch::euclideanClusters(points, 10.0F).sizes, (Labels{100'000, 100'000}));
  }

  void agreesWithPclOnOrganisedClouds() {
    const QString folder = sharedData("pcd_organised_pcl");
    REQUIRE_DATA(folder);
    compareWithPcl(folder, {0.02F, 0.04F, 0.1F});
  }
  void agreesWithPclOnLabelledTables() {
    const QString folder = sharedData("pcd_labelled_mosd");
    REQUIRE_DATA(folder);
    compareWithPcl(folder, {0.02F, 0.04F});
  }
  void agreesWithPclOnLidarStreets() {
    const QString folder = sharedData("lidar_seq_street_udacity");
    REQUIRE_DATA(folder);
    compareWithPcl(folder, {0.04F, 0.5F, 2.0F});
  }
  void agreesWithPclOnDebiansOwnClouds() {
    const QString folder = QStringLiteral("/usr/share/doc/python3-pcl");
    if (cloudsBelow(folder).isEmpty()) QSKIP("absent: the clouds of python3-pcl");
    compareWithPcl(folder, {0.02F, 0.04F});
  }
};

BOOMWATCH_TEST(TestClusters)
#include "test_clusters.moc"
