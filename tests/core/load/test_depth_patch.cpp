#include <QtTest>

#include "load/depth_patch.h"
#include "support/ray_cast.h"
#include "support/test_registry.h"

using namespace boomwatch;
using Eigen::Vector3f;

namespace {

const Vector3f tool(0.0F, 0.0F, 4.0F);

Cloud wall() {
  return ray_cast::seen([](double, double) { return 4.0; });
}

DepthPatch patchOf(const Cloud& cloud, double samplesPerCell = 8.0) {
  return patchAround(cloud, tool, 1.2, 0.002, samplesPerCell);
}

}  // namespace

class TestDepthPatch : public QObject {
  Q_OBJECT
 private slots:
  void aCellHoldsTheInverseDepthAndPlaceOfWhatIsSeenThere() {
    const DepthPatch patch = patchOf(wall());
    QCOMPARE(patch.side, 151);
    QCOMPARE(patch.cell, 1.2 / 4.0 / 75.0);
    const int middle = patch.indexOf(0.0, 0.0);
    QCOMPARE(middle, 151 * 75 + 75);
    QCOMPARE(patch.q[static_cast<std::size_t>(middle)], 0.25F);
    const Eigen::Vector3d corner = patch.point(patch.indexOf(0.2, -0.1));
    QVERIFY(std::abs(corner.x() - 0.8) <= 2.0 * patch.cell);
    QVERIFY(std::abs(corner.y() + 0.4) <= 2.0 * patch.cell);
    QCOMPARE(corner.z(), 4.0);
    QCOMPARE(patch.indexOf(0.31, 0.0), -1);
    QCOMPARE(patch.indexOf(std::nan(""), 0.0), -1);
  }

  void thePitchIsThatOfThePixels() {
    const DepthPatch patch = patchOf(wall());
    QVERIFY2(std::abs(patch.pitch * 600.0 - 1.0) < 0.05, qPrintable(QString::number(patch.pitch)));
    QVERIFY(std::abs(patch.uMax - 320.0 / 600.0) < 0.05 &&
            std::abs(patch.uMin + patch.uMax) < 0.05);
  }

  void manyPointsOfACellAreSurerThanOne() {
    const DepthPatch patch = patchOf(wall());
    const auto middle = static_cast<std::size_t>(patch.indexOf(0.0, 0.0));
    const auto count = static_cast<double>(patch.begin[middle + 1] - patch.begin[middle]);
    QVERIFY(count > 2.0);
    QVERIFY(std::abs(patch.sigma[middle] - 0.002 * 1.25 / std::sqrt(count)) < 1e-6);
  }

  void ofADenseCloudPointsAreLeftOutEvenly() {
    const DepthPatch all = patchOf(wall());
    const DepthPatch thin = patchOf(wall(), 1.0);  // 5.76 points a cell: a quarter of them
    const double share = static_cast<double>(thin.samples.size()) / double(all.samples.size());
    QVERIFY2(std::abs(share - 0.25) < 0.01, qPrintable(QString::number(share)));
  }

  void ofASparseCloudCellsAreCoarser() {
    Cloud sparse = wall();
    for (std::size_t k = 0; k < sparse.size(); ++k) {
      if (k % 641 % 5 != 0 || k / 641 % 5 != 0) sparse.points[k] = unmeasuredPoint();
    }
    const DepthPatch patch = patchOf(sparse);
    QVERIFY(!patch.empty());
    QVERIFY2(patch.side < 100, qPrintable(QString::number(patch.side)));
    QCOMPARE(patch.q[static_cast<std::size_t>(patch.indexOf(0.0, 0.0))], 0.25F);
  }

  void nothingIsThereAroundAToolThatCannotBeSeen() {
    const Cloud cloud = wall();
    for (const Vector3f& place :
         {Vector3f(0, 0, -4), Vector3f(0, 0, 0), unmeasuredPoint(), Vector3f(40, 0, 4)}) {
      QVERIFY(patchAround(cloud, place, 1.2, 0.002, 8.0).empty());
    }
    QVERIFY(patchAround(Cloud(), tool, 1.2, 0.002, 8.0).empty());
  }
};

BOOMWATCH_TEST(TestDepthPatch)
#include "test_depth_patch.moc"
