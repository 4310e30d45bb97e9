#include <Eigen/Dense>
#include <QtTest>
#include <algorithm>
#include <map>
#include <opencv2/imgproc.hpp>

#include "support/compare_near.h"
#include "support/floor_plane.h"
#include "support/real_data.h"
#include "support/sequence.h"
#include "support/test_registry.h"

using namespace boomwatch;
using namespace boomwatch::test;

namespace {

// The recording: the exposure settles until frame 50 or so; somebody is in view until 110 and again
// from 200 to 290; nobody is near in between and after.
const std::vector<Stretch> used{{48, 206}, {215, 315}};
constexpr Stretch nobodyNear{130, 200}, somebodyNear{230, 260}, nobodyAgain{295, 315};
constexpr std::size_t settled = 60;
// The rectified camera, to 0.1 px (stereoRectify of the set's calibration).
constexpr double focalLength = 928.6, centreX = 651.2, centreY = 411.2;
/// The floor, z = 0.02 x - 0.21 y + 2.76. Its tilt is what the joints of its square tiles say in
/// the left picture alone, no disparity: the homography of 20 joints of the rectified picture, by
/// which the tiles' sides agree to 1 % and their angle to 0.5 degrees. The tilt is good to 0.02.
const Floor tiles{{0.02, -0.21, 2.76}};

bool within(const Stretch& stretch, std::size_t frame) {
  return frame >= stretch.first && frame < stretch.last;
}

/// What an engineer would set for this camera: blocks as large as sgbm takes and smoothing against
/// sunlit tiles with soft shadows, which carry little structure; the bounds hold the free floor,
/// between the table and the step, for both are nearer to the load than the floor is.
Parameters overheadParameters() {
  Parameters parameters;
  parameters.bounds = {-1.2, 1.2, -0.35, 0.5, 0.9, 3.6};
  parameters.stereo.disparities = 96;
  parameters.stereo.blockSize = 15;
  parameters.stereo.uniqueness = 20;
  parameters.stereo.speckleWindow = 400;
  parameters.stereo.texture = 0.4;
  parameters.stereo.average = 20;
  parameters.stereo.smooth = 31;
  parameters.filter.clusterMinimum = 100;
  parameters.load.source = LoadSource::Manual;
  parameters.load.x = parameters.load.y = 0.0;
  parameters.load.z = 1.5;
  parameters.load.sizeX = parameters.load.sizeY = parameters.load.sizeZ = 0.4;
  return parameters;
}

/// A model of the floor alone, over the whole of the sunlit stripe.
Parameters floorParameters() {
  Parameters parameters = overheadParameters();
  parameters.bounds = {-1.2, 1.2, -0.35, 0.85, 2.2, 3.4};
  parameters.load.source = LoadSource::Scene;
  return parameters;
}

/// What the test keeps of a frame.
struct Look {
  bool measured = false;
  double distance = 0.0;    ///< as the chain reports it
  double toPlane = 0.0;     ///< load to the plane fitted to this frame's cloud
  Floor plane;              ///< fitted to this frame's cloud
  std::size_t floor = 0;    ///< cells at 2.6 to 2.9 m
  std::size_t nearer = 0;   ///< cells nearer than any floor
  std::size_t farther = 0;  ///< occupied cells that are neither
  std::size_t onTiles = 0;  ///< cells within 10 cm of the floor that its tiles say
};

Look lookAt(const Result& result, const EnvironmentModel& model) {
  Look look;
  const GridGeometry& grid = model.geometry();
  for (std::size_t k = 0; k < model.levels().size(); ++k) {
    if (model.levels()[k] == 0) continue;
    const int column = static_cast<int>(k) % grid.columns();
    const int row = static_cast<int>(k) / grid.columns();
    const double z = grid.zOf(model.levels()[k]);
    look.floor += z >= 2.6 && z <= 2.9;
    look.nearer += z < 2.3;
    look.farther += (z >= 2.3 && z < 2.6) || z > 2.9;
    look.onTiles += std::abs(z - tiles.depthAt(grid.xOf(column), grid.yOf(row))) <= 0.1;
  }
  look.plane = fitFloor(*result.cloud, {-0.8, 0.8, -0.35, 0.5});
  look.measured = result.clearance.nearest.has_value();
  if (!look.measured) return look;
  look.distance = result.clearance.nearest->distance;
  look.toPlane = distanceToPlane(*result.load, look.plane);
  return look;
}

/// Pixels that are over-exposed with all that a match of them looks at: the neighbourhood in which
/// the matcher asks for texture, and one pixel more, which its gradients reach.
cv::Mat overexposed(const Result& result) {
  cv::Mat saturated = result.image >= 250;
  if (saturated.channels() == 3) cv::extractChannel(saturated, saturated, 0);
  const int side = 2 * result.parameters.stereo.blockSize + 3;
  cv::erode(saturated, saturated, cv::Mat::ones(side, side, CV_8UC1));
  return saturated;
}

std::size_t countWithDepth(const cv::Mat& pixels, const Cloud& cloud) {
  std::size_t count = 0;
  for (int row = 0; row < pixels.rows; ++row) {
    for (int column = 0; column < pixels.cols; ++column) {
      const auto k = static_cast<std::size_t>(row * pixels.cols + column);
      count += pixels.at<std::uint8_t>(row, column) != 0 && std::isfinite(cloud.points[k].z());
    }
  }
  return count;
}

/// A model of the floor and, beside it, the pixels that are over-exposed in every frame it saw.
class StripeWatch {
 public:
  void look(const Result& result) {
    auto sensed = std::make_shared<Frame>();
    sensed->sequence = result.frame->sequence;
    sensed->left = result.image;
    sensed->cloud = result.cloud;
    m_pipeline.process(sensed, floorParameters());
    const cv::Mat now = overexposed(result);
    if (m_always.empty()) m_always = now.clone();
    m_always &= now;
  }
  /// Cells of the floor that nothing but such pixels look at: how many there are in each state.
  std::map<CellState, std::size_t> cells() const {
    const EnvironmentModel& model = m_pipeline.model();
    const GridGeometry& grid = model.geometry();
    std::map<CellState, std::size_t> count;
    for (int row = 0; row < grid.rows(); ++row) {
      for (int column = 0; column < grid.columns(); ++column) {
        if (isUnseen(grid, column, row)) ++count[model.state(column, row)];
      }
    }
    return count;
  }

 private:
  /// Whether only such pixels look into the cell, from the nearest it reaches to below the floor:
  /// the step and the ledge at the stripe's border are nearer than the floor, and pixels that see
  /// those see cells that would be the stripe's if they were as far away as it is.
  bool isUnseen(const GridGeometry& grid, int column, int row) const {
    const double x = grid.xOf(column), y = grid.yOf(row), half = grid.resolution() / 2;
    const double farthest = tiles.depthAt(x, y) + 0.1;
    for (double z = floorParameters().bounds.zMin; z <= farthest; z += 0.02) {
      const double scale = focalLength / z;
      const cv::Point from(cvFloor((x - half) * scale + centreX),
                           cvFloor((y - half) * scale + centreY));
      const cv::Point to(cvCeil((x + half) * scale + centreX) + 1,
                         cvCeil((y + half) * scale + centreY) + 1);
      const cv::Rect seen(from, to);
      if ((seen & cv::Rect({}, m_always.size())) != seen) return false;
      if (cv::countNonZero(m_always(seen)) != seen.area()) return false;
    }
    return true;
  }

  Pipeline m_pipeline;
  cv::Mat m_always;
};

}  // namespace

/// The nearest thing to the real job: a still stereo camera that looks down, outdoors.
class TestOverheadSlow : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void floorIsInTheModel();
  void floorTiltsAsItsTilesSay();
  void whoWalksThroughIsNotInTheModelAfterwards();
  void boxReportsThePlaneBelowItWhileNobodyIsNear();
  void distanceIsShorterWhileSomebodyIsNear();
  void overexposedStripeIsNeverObserved();

 private:
  std::vector<double> over(const Stretch& stretch, double (*value)(const Look&)) const;

  std::map<std::size_t, Look> m_looks;
  std::map<CellState, std::size_t> m_stripe;  ///< cells by state, while nobody is near
  std::size_t m_overexposed = 0;              ///< pixels, of all frames
  std::size_t m_overexposedWithDepth = 0;
};

void TestOverheadSlow::initTestCase() {
  const QString recording = sharedData("stereo_static_topdown_oakd");
  REQUIRE_DATA(recording);
  StripeWatch quiet;
  runSequence(
      "stereo:" + recording, overheadParameters(),
      [&](const Result& result, const Pipeline& pipeline) {
        const std::size_t frame = result.frame->sequence;
        m_looks[frame] = lookAt(result, pipeline.model());
        if (frame < settled) return;
        const cv::Mat stripe = overexposed(result);
        m_overexposed += static_cast<std::size_t>(cv::countNonZero(stripe));
        m_overexposedWithDepth += countWithDepth(stripe, *result.cloud);
        if (within(nobodyNear, frame)) quiet.look(result);
      },
      used);
  QCOMPARE(m_looks.size(), std::size_t{258});
  m_stripe = quiet.cells();
}

/// One value of each measured frame of a stretch, in ascending order.
std::vector<double> TestOverheadSlow::over(const Stretch& stretch,
                                           double (*value)(const Look&)) const {
  std::vector<double> values;
  for (const auto& [frame, look] : m_looks) {
    if (within(stretch, frame) && look.measured) values.push_back(value(look));
  }
  std::sort(values.begin(), values.end());
  return values;
}

void TestOverheadSlow::floorIsInTheModel() {
  double least = 1.0, minQuiet = 1.0, minOnTiles = 1.0;
  std::size_t fewest = 100000;
  for (const auto& [frame, look] : m_looks) {
    if (frame < settled) continue;
    fewest = std::min(fewest, look.floor);
    const double all = static_cast<double>(look.floor + look.farther);
    const double share = static_cast<double>(look.floor) / all;
    least = std::min(least, share);
    if (within(nobodyNear, frame) || within(nobodyAgain, frame)) {
      minQuiet = std::min(minQuiet, share);
    }
    minOnTiles = std::min(minOnTiles, static_cast<double>(look.onTiles) / all);
  }
  qInfo(
      "from frame %zu on, at least %zu cells at 2.6 to 2.9 m, %.1f %% of all below 2.3 m (%.1f %% "
      "while nobody is near); %.1f %% within 10 cm of the floor that its tiles say",
      settled, fewest, 100 * least, 100 * minQuiet, 100 * minOnTiles);
  QVERIFY(fewest >= 500);
  QVERIFY(least >= 0.95);
  QVERIFY(minOnTiles >= 0.95);
}

void TestOverheadSlow::floorTiltsAsItsTilesSay() {
  const auto slopeX = [](const Look& look) { return look.plane.abc.x(); };
  const auto slopeY = [](const Look& look) { return look.plane.abc.y(); };
  const std::vector<double> a = over(nobodyNear, slopeX), b = over(nobodyNear, slopeY);
  qInfo("the floor falls by %.3f m a metre along x, %.3f along y; its tiles say %.3f and %.3f",
        a[a.size() / 2], b[b.size() / 2], tiles.abc.x(), tiles.abc.y());
  // Along x it is the focal lengths that decide, and the rows say less of those.
  BW_COMPARE_NEAR(a[a.size() / 2], tiles.abc.x(), 0.04);
  BW_COMPARE_NEAR(b[b.size() / 2], tiles.abc.y(), 0.04);
}

void TestOverheadSlow::whoWalksThroughIsNotInTheModelAfterwards() {
  const auto nearer = [](const Look& look) { return static_cast<double>(look.nearer); };
  const std::vector<double> during = over(somebodyNear, nearer);
  qInfo("cells nearer than the floor: up to %.0f while somebody is near, %.0f and %.0f afterwards",
        during.back(), over(nobodyNear, nearer).back(), over(nobodyAgain, nearer).back());
  QVERIFY(during.back() >= 20);
  QCOMPARE(over(nobodyNear, nearer).back(), 0.0);
  QCOMPARE(over(nobodyAgain, nearer).back(), 0.0);
}

void TestOverheadSlow::boxReportsThePlaneBelowItWhileNobodyIsNear() {
  const auto error = [](const Look& look) { return look.distance - look.toPlane; };
  for (const Stretch& quiet : {nobodyNear, nobodyAgain}) {
    const std::vector<double> errors = over(quiet, error);
    QCOMPARE(errors.size(), quiet.last - quiet.first);
    const auto good =
        std::count_if(errors.begin(), errors.end(), [](double e) { return std::abs(e) <= 0.05; });
    const double share = static_cast<double>(good) / static_cast<double>(errors.size());
    qInfo(
        "frames %zu to %zu: reported less plane: median %.3f m, from %.3f to %.3f; %.0f %% within "
        "5 cm",
        quiet.first, quiet.last - 1, errors[errors.size() / 2], errors.front(), errors.back(),
        100 * share);
    BW_COMPARE_NEAR(errors[errors.size() / 2], 0.0, 0.05);
    QCOMPARE(share, 1.0);
  }
}

void TestOverheadSlow::distanceIsShorterWhileSomebodyIsNear() {
  const auto distance = [](const Look& look) { return look.distance; };
  const std::vector<double> quiet = over(nobodyNear, distance), busy = over(somebodyNear, distance);
  qInfo("median distance %.2f m while somebody is near, %.2f m while nobody is",
        busy[busy.size() / 2], quiet[quiet.size() / 2]);
  QVERIFY(busy[busy.size() / 2] < 0.5 * quiet[quiet.size() / 2]);
}

void TestOverheadSlow::overexposedStripeIsNeverObserved() {
  qInfo("of %zu over-exposed pixels, %zu have a depth", m_overexposed, m_overexposedWithDepth);
  QVERIFY(m_overexposed > 1000000);
  QCOMPARE(m_overexposedWithDepth, std::size_t{0});
  // Whoever walks through shades the stripe, and what is shaded is seen: cells are looked at while
  // nobody is near.
  const std::size_t never = m_stripe[CellState::NeverObserved];
  const std::size_t seen = m_stripe[CellState::ObservedFree] + m_stripe[CellState::Occupied];
  qInfo("of %zu cells that only over-exposed pixels look at, %zu were never observed", never + seen,
        never);
  QVERIFY(never >= 50);
  QCOMPARE(seen, std::size_t{0});
}

BOOMWATCH_TEST(TestOverheadSlow)
#include "test_overhead_slow.moc"
