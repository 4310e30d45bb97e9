#include <QtTest>
#include <algorithm>

#include "load/box_fit.h"
#include "support/ray_cast.h"
#include "support/test_registry.h"

using namespace boomwatch;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

constexpr double reach = 1.8;

/// Held where the camera sees its middle, before a wall at 8 m.
LoadDetection fitOf(const OrientedBox& box, const LoadParameters& parameters) {
  const Cloud cloud = ray_cast::seen(
      [&](double u, double v) { return std::min(ray_cast::boxDepth(box, u, v), 8.0); });
  const double u = box.centre.x() / box.centre.z(), v = box.centre.y() / box.centre.z();
  const Vector3f tool = (Vector3d(u, v, 1.0) * ray_cast::boxDepth(box, u, v)).cast<float>();
  const DepthPatch patch = patchAround(cloud, tool, reach, ray_cast::noise, 8.0);
  const LoadBody body = growBody(patch, tool, {reach, parameters.toolSize / 2.0, Bounds{}});
  if (body.fault != LoadFault::None) return LoadDetection::refused(body.fault);
  return fitBox(patch, body, reach, parameters);
}

Vector3d sorted(Vector3d size) {
  std::sort(size.begin(), size.end());
  return size;
}

LoadParameters smallTool() {
  LoadParameters parameters;
  parameters.toolSize = 0.3;
  return parameters;
}

/// Shows the camera nothing but its front.
const OrientedBox facing{{0.0, 0.0, 4.0}, {1.0, 0.8, 0.6}, Eigen::Matrix3d::Identity()};

}  // namespace

class TestBoxFit : public QObject {
  Q_OBJECT
 private slots:
  void aBoxThatShowsThreeFacesIsFoundAsItIs() {
    const OrientedBox box{
        {0.1, 0.0, 4.0}, {1.2, 0.8, 0.6}, rotationFromYawPitchRoll(0.6, 0.5, 0.2)};
    const LoadDetection found = fitOf(box, smallTool());
    QVERIFY(found.box && found.isWhole);
    const double wrong = (sorted(found.box->size) - sorted(box.size)).cwiseAbs().maxCoeff();
    QVERIFY2(wrong < 0.05, qPrintable(QString::number(wrong)));
    const double apart = (found.box->centre - box.centre).norm();
    QVERIFY2(apart < 0.05, qPrintable(QString::number(apart)));
    const Eigen::Matrix3d turn = (found.box->rotation.transpose() * box.rotation).cwiseAbs();
    QVERIFY(turn.colwise().maxCoeff().minCoeff() > std::cos(0.05));
    QVERIFY(std::abs(found.box->rotation.determinant() - 1.0) < 1e-9);
  }

  void oneFaceDoesNotSayHowDeepItIs() {
    QVERIFY(fitOf(facing, smallTool()).fault == LoadFault::DepthHidden);
  }

  void lockedSizesLieBehindTheFaceThatIsSeen() {
    LoadParameters parameters = smallTool();
    parameters.dimensions = LoadDimensions::Locked;
    parameters.sizeX = 1.0, parameters.sizeY = 0.8, parameters.sizeZ = 0.6;
    const LoadDetection found = fitOf(facing, parameters);
    QVERIFY(found.box);
    const double apart = (found.box->centre - facing.centre).norm();
    QVERIFY2(apart < 0.05, qPrintable(QString::number(apart)));
    QVERIFY((sorted(found.box->size) - sorted(facing.size)).norm() < 1e-9);
  }

  void whatDoesNotReachOutOfTheToolIsNoBody() {
    LoadParameters parameters;
    parameters.toolSize = 2.0;
    QVERIFY(fitOf(facing, parameters).fault == LoadFault::NoBody);
  }
};

BOOMWATCH_TEST(TestBoxFit)
#include "test_box_fit.moc"
