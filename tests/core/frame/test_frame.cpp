#include <Eigen/Geometry>
#include <QtTest>
#include <numbers>
#include <random>
#include <set>

#include "frame/bounds.h"
#include "frame/clearance.h"
#include "frame/cloud.h"
#include "frame/oriented_box.h"
#include "frame/viewed_box.h"
#include "pipeline/warning_level.h"
#include "support/enumerators.h"
#include "support/test_registry.h"

using namespace boomwatch;
using Eigen::Vector3d;

namespace {

constexpr double quarter = std::numbers::pi / 2;

OrientedBox randomBox(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0), size(0.1, 2.0);
  return {{unit(random), unit(random), unit(random)},
          {size(random), size(random), size(random)},
          rotationFromYawPitchRoll(3 * unit(random), 3 * unit(random), 3 * unit(random))};
}

Vector3d randomPoint(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-2.0, 2.0);
  return {unit(random), unit(random), unit(random)};
}

Clearance measured(double distance) {
  Clearance clearance;
  clearance.state = ClearanceState::Measured;
  clearance.reason = Reason::None;
  clearance.nearest = Nearest{distance, Vector3d::Zero(), Vector3d::Zero(), LoadPart::Face, 0.0};
  return clearance;
}

}  // namespace

class TestFrame : public QObject {
  Q_OBJECT
 private slots:
  void turnsAreYawThenPitchThenRollAboutTheBoxsOwnAxes() {
    // y points down, so a positive yaw turns what looks forward (z) to the right (x).
    QVERIFY(
        (rotationFromYawPitchRoll(quarter, 0, 0) * Vector3d::UnitZ()).isApprox(Vector3d::UnitX()));
    // A positive pitch turns what looks forward upwards (-y).
    QVERIFY(
        (rotationFromYawPitchRoll(0, quarter, 0) * Vector3d::UnitZ()).isApprox(-Vector3d::UnitY()));
    // A positive roll turns the right side down.
    QVERIFY(
        (rotationFromYawPitchRoll(0, 0, quarter) * Vector3d::UnitX()).isApprox(Vector3d::UnitY()));
    // Each turn is about the axes that the one before left behind.
    using Eigen::AngleAxisd;
    Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
    frame = AngleAxisd(0.3, Vector3d(frame.col(1))) * frame;
    frame = AngleAxisd(-0.7, Vector3d(frame.col(0))) * frame;
    frame = AngleAxisd(1.1, Vector3d(frame.col(2))) * frame;
    QVERIFY(rotationFromYawPitchRoll(0.3, -0.7, 1.1).isApprox(frame));
  }

  void cornersAreNumberedByTheirSigns() {
    const OrientedBox box{{1, 2, 3}, {2, 4, 6}, rotationFromYawPitchRoll(0, 0, quarter)};
    const auto corners = box.corners();
    QVERIFY(corners[0].isApprox(Vector3d(1 + 2, 2 - 1, 3 - 3)));
    QVERIFY(corners[1].isApprox(Vector3d(1 + 2, 2 + 1, 3 - 3)));  // x of the box is y
    QVERIFY(corners[2].isApprox(Vector3d(1 - 2, 2 - 1, 3 - 3)));  // y of the box is -x
    QVERIFY(corners[4].isApprox(Vector3d(1 + 2, 2 - 1, 3 + 3)));
  }

  void aBoxContainsWhatLiesBetweenItsFaces() {
    std::mt19937 random(1);
    int inside = 0;
    for (int k = 0; k < 2000; ++k) {
      const OrientedBox box = randomBox(random);
      const Vector3d p = randomPoint(random);
      bool wanted = true;
      for (int axis = 0; axis < 3; ++axis) {
        const double along = box.rotation.col(axis).dot(p - box.centre);
        wanted = wanted && std::abs(along) <= box.size[axis] / 2;
      }
      QCOMPARE(box.contains(p), wanted);
      inside += wanted;
    }
    QVERIFY(inside > 20 && inside < 1000);
  }

  void theNearestPointBeatsEveryOtherPointOfTheBox() {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> share(-0.5, 0.5);
    for (int k = 0; k < 200; ++k) {
      const OrientedBox box = randomBox(random);
      const Vector3d p = randomPoint(random);
      const Vector3d nearest = box.nearestTo(p);
      const Vector3d local = box.rotation.transpose() * (nearest - box.centre);
      QVERIFY(((local.cwiseAbs() - box.size / 2).array() <= 1e-12).all());
      if (box.contains(p)) QCOMPARE(nearest, p);
      for (int j = 0; j < 100; ++j) {
        const Vector3d other = box.centre + box.rotation * Vector3d(share(random) * box.size.x(),
                                                                    share(random) * box.size.y(),
                                                                    share(random) * box.size.z());
        QVERIFY((p - nearest).norm() <= (p - other).norm() + 1e-12);
      }
    }
  }

  void boundsHoldTheirLowerLimitsAndNothingUnmeasured() {
    const Bounds bounds{-1, 1, -2, 2, 0, 5};
    QVERIFY(bounds.contains({-1, -2, 0}));
    QVERIFY(!bounds.contains({1, 0, 1}));
    QVERIFY(!bounds.contains({0, 2, 1}));
    QVERIFY(bounds.contains({0, 0, 5}));
    QVERIFY(!bounds.contains({0, 0, 5.001F}));
    QVERIFY(!bounds.contains(unmeasuredPoint()));
  }

  void anAxisAlignedBoxContainsItsLimits() {
    const AxisAlignedBox box{{0, 0, 0}, {1, 2, 3}};
    QVERIFY(box.contains({0, 0, 0}) && box.contains({1, 2, 3}));
    QVERIFY(!box.contains({1.001, 1, 1}) && !box.contains({0.5, 1, -0.001}));
  }

  void aCloudsPointsLieRowByRow() {
    Cloud cloud{3, 2, Points(6, unmeasuredPoint()), {}, {}};
    cloud.points[4] = {1, 2, 3};
    QVERIFY(cloud.organised());
    QCOMPARE(cloud.at(1, 1), Eigen::Vector3f(1, 2, 3));
    QVERIFY(isMeasured(cloud.at(1, 1)) && !isMeasured(cloud.at(2, 1)));
    QVERIFY(!isMeasured({1, 2, std::numeric_limits<float>::infinity()}));
    QVERIFY(!(Cloud{6, 1, {}, {}, {}}.organised()));
  }

  void namesAreDistinctAndOnlyNoReasonIsNameless() {
    std::set<std::string_view> names;
    const int last = int(Reason::NothingObserved);
    for (int k = 0; k <= last; ++k) {
      const auto name = toString(Reason(k));
      QCOMPARE(name.empty(), Reason(k) == Reason::None);
      names.insert(name);
    }
    QCOMPARE(names.size(), std::size_t(last + 1));
    QVERIFY(toString(Reason::FewDepthPixels) == "few_depth_pixels");
    QVERIFY(toString(ClearanceState::NothingInRange) == "nothing_in_range");
    QVERIFY(toString(LoadPart::Corner) == "corner");
    QVERIFY(toString(WarningLevel::NoDistance) == "no_distance");
  }

  void anUnknownClearanceHasAReasonAndNoNumber() {
    const Clearance clearance = Clearance::unknown(Reason::NoModel);
    QVERIFY(clearance.state == ClearanceState::Unknown);
    QVERIFY(clearance.reason == Reason::NoModel);
    QVERIFY(!clearance.nearest && !clearance.observedShare);
    QVERIFY(Clearance{}.state == ClearanceState::Unknown);
  }

  void levelsBeginAtTheirDistances() {
    const WarningParameters parameters{2.0, 1.0};
    const auto level = [&](double distance) {
      return warningLevel(measured(distance), parameters);
    };
    QVERIFY(level(0.0) == WarningLevel::Collision);
    QVERIFY(level(1e-9) == WarningLevel::Warning);
    QVERIFY(level(1.0) == WarningLevel::Warning);
    QVERIFY(level(1.0001) == WarningLevel::Caution);
    QVERIFY(level(2.0) == WarningLevel::Caution);
    QVERIFY(level(2.0001) == WarningLevel::Clear);
  }

  /// Against its definition: some point of the box lies on the line of sight, within the error.
  void aViewedBoxHasWhatMayBeMeasuredOfIt() {
    std::mt19937 random(5);
    int within = 0;
    for (int k = 0; k < 2000; ++k) {
      OrientedBox box = randomBox(random);
      box.centre.z() += 5.0;
      const ViewedBox viewed(box, 0.02, 0.05);
      const Vector3d p = randomPoint(random) + Vector3d(0, 0, 5);
      bool found = false;
      for (double inverse = -0.02; inverse <= 0.05; inverse += 1e-4) {
        found = found || box.contains(p / (1.0 + p.z() * inverse));
      }
      // Between two samples it may be cut at a corner.
      const bool surely = found || !ViewedBox(box, 0.0201, 0.0501).contains(p);
      if (surely) QCOMPARE(viewed.contains(p), found);
      QCOMPARE(ViewedBox(box).contains(p), box.contains(p));
      within += found;
    }
    QVERIFY(within > 100 && within < 1900);
  }
  void aViewedBoxReachesNoFartherThanTheError() {
    const ViewedBox box({{0, 0, 5}, {1, 1, 1}, Eigen::Matrix3d::Identity()}, 0.01, 0.02);
    const auto at = [](double inverse) { return Vector3d(0, 0, 1.0 / inverse); };
    QVERIFY(box.contains(at(1 / 5.5 - 0.0199)) && !box.contains(at(1 / 5.5 - 0.0201)));
    QVERIFY(box.contains(at(1 / 4.5 + 0.0099)) && !box.contains(at(1 / 4.5 + 0.0101)));
    // Beside it, along the same line of sight: not even close behind it.
    QVERIFY(!box.contains({0.6, 0, 5.6}) && box.contains({0.55, 0, 5.6}));
  }

  void whatIsUnknownIsNeverClear() {
    const WarningParameters parameters;
    for (const Reason reason : every<Reason>()) {
      QVERIFY(warningLevel(Clearance::unknown(reason), parameters) == WarningLevel::NoDistance);
    }
    Clearance far;
    far.state = ClearanceState::NothingInRange;
    QVERIFY(warningLevel(far, parameters) == WarningLevel::Clear);
  }

  void theLatchKeepsTheWorstUntilItIsTaken() {
    using enum WarningLevel;
    const WarningLevel byUrgency[] = {Clear, NoDistance, Caution, Warning, Collision};
    for (int worst = 0; worst < 5; ++worst) {
      for (int other = 0; other <= worst; ++other) {
        WarningLatch latch;
        latch.note(byUrgency[other]);
        latch.note(byUrgency[worst]);
        latch.note(byUrgency[other]);
        QVERIFY(latch.take() == byUrgency[worst]);
        QVERIFY(latch.take() == Clear);
      }
    }
  }
};

BOOMWATCH_TEST(TestFrame)
#include "test_frame.moc"
