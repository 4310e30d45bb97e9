#include <QtTest>
#include <algorithm>
#include <map>

#include "cloud/clusters.h"
#include "sources/cloud_file.h"
#include "support/real_data.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

/// Labels are written by hand: 1-9 parts of the table, 20-29 parts of object 1, 30-39 of object 2.
struct LabelledPoints {
  Points points;
  std::vector<int> objects;  ///< one a point: 1 object 1, 2 object 2, ...
};

LabelledPoints objectsOn(const CloudFile& file) {
  LabelledPoints result;
  for (std::size_t k = 0; k < file.labels.size(); ++k) {
    const Eigen::Vector3f& point = file.cloud->points[k];
    if (file.labels[k] < 20 || !isMeasured(point)) continue;
    result.points.push_back(point);
    result.objects.push_back(static_cast<int>(file.labels[k]) / 10 - 1);
  }
  return result;
}

double pairs(double n) { return n * (n - 1.0) / 2.0; }

/// Hubert and Arabie's adjusted Rand index: 1 for the same partition, about 0 for chance.
double adjustedRandIndex(const std::vector<int>& truth, const std::vector<std::int32_t>& found) {
  std::map<std::pair<int, int>, double> both;
  std::map<int, double> rows, columns;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    ++both[{truth[k], found[k]}];
    ++rows[truth[k]];
    ++columns[found[k]];
  }
  double together = 0.0, inTruth = 0.0, inFound = 0.0;
  for (const auto& [key, n] : both) together += pairs(n);
  for (const auto& [key, n] : rows) inTruth += pairs(n);
  for (const auto& [key, n] : columns) inFound += pairs(n);
  const double expected = inTruth * inFound / pairs(static_cast<double>(truth.size()));
  const double most = (inTruth + inFound) / 2.0;
  return most == expected ? 1.0 : (together - expected) / (most - expected);
}

struct Agreement {
  double covered = 0.0;  ///< share of the object's points in the cluster that has most of them
  double pure = 0.0;     ///< share of that cluster's points that are this object's
};

std::map<int, Agreement> agreements(const LabelledPoints& truth, const Clusters& clusters) {
  std::map<int, std::map<std::int32_t, double>> counts;
  std::map<int, double> sizes;
  for (std::size_t k = 0; k < truth.points.size(); ++k) {
    ++counts[truth.objects[k]][clusters.labels[k]];
    ++sizes[truth.objects[k]];
  }
  std::map<int, Agreement> result;
  for (const auto& [object, byCluster] : counts) {
    const auto best =
        std::max_element(byCluster.begin(), byCluster.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    const double size = clusters.sizes[static_cast<std::size_t>(best->first)];
    result[object] = {best->second / sizes[object], best->second / size};
  }
  return result;
}

}  // namespace

class TestLabelledClusters : public QObject {
  Q_OBJECT
 private slots:
  void clustersAreTheLabelledObjects_data();
  void clustersAreTheLabelledObjects();
};

void TestLabelledClusters::clustersAreTheLabelledObjects_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<bool>("touching");
  const auto row = [](const char* name, bool touching) {
    QTest::newRow(name) << sharedData(QStringLiteral("pcd_labelled_mosd/%1.pcd").arg(name))
                        << touching;
  };
  row("learn0", false);
  row("test3", false);
  row("learn20", true);  // one box stands on the other
}

void TestLabelledClusters::clustersAreTheLabelledObjects() {
  QFETCH(QString, file);
  QFETCH(bool, touching);
  REQUIRE_DATA(file);
  const LabelledPoints truth = objectsOn(readCloudFile(file.toStdString()));
  const Clusters clusters = euclideanClusters(truth.points, 0.01F);
  const auto found = agreements(truth, clusters);
  const double index = adjustedRandIndex(truth.objects, clusters.labels);
  qInfo("%zu points of %zu objects, %zu clusters, adjusted Rand index %.3f", truth.points.size(),
        found.size(), clusters.sizes.size(), index);
  QVERIFY(found.size() >= 2);
  for (const auto& [object, agreement] : found) {
    qInfo("object %d: %.1f %% in one cluster, of which %.1f %% are it", object,
          100 * agreement.covered, 100 * agreement.pure);
    QVERIFY(agreement.covered >= 0.99);
    // Distance alone cannot part what touches.
    QVERIFY(touching ? agreement.pure < 0.9 : agreement.pure >= 0.99);
  }
  QVERIFY(touching || index >= 0.99);
}

BOOMWATCH_TEST(TestLabelledClusters)
#include "test_labelled_clusters.moc"
