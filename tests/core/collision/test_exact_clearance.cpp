#include <QtTest>
#include <future>
#include <limits>

#include "collision/exact_clearance.h"
#include "support/collision_scenes.h"
#include "support/compare_near.h"
#include "support/test_registry.h"

using namespace boomwatch;
using Eigen::Vector3d;

namespace {

constexpr double far = std::numeric_limits<double>::infinity();

// Every cell, one after the other: the truth that the search has to equal.
std::optional<double> everyCell(const EnvironmentModel& model, const OrientedBox& box) {
  const GridGeometry& g = model.geometry();
  std::optional<double> best;
  for (int j = 0; j < g.rows(); ++j) {
    for (int i = 0; i < g.columns(); ++i) {
      const int level = model.levels()[g.index(i, j)];
      if (level == 0) continue;
      const Vector3d p = g.surfacePoint(i, j, level);
      const double distance = (p - box.nearestTo(p)).norm();
      if (!best || distance < *best) best = distance;
    }
  }
  return best;
}

Clearance clearanceOf(const EnvironmentModel& model, const OrientedBox& box, double range = far) {
  ExactClearance exact;
  exact.rebuild(model);
  return exact.query(box, range);
}

bool onSurface(const EnvironmentModel& model, const Vector3d& p) {
  const GridGeometry& g = model.geometry();
  const int i = g.columnOf(p.x()), j = g.rowOf(p.y());
  if (!g.contains(i, j)) return false;
  const int level = model.levels()[g.index(i, j)];
  return level > 0 && (g.surfacePoint(i, j, level) - p).norm() < 1e-9;
}

// Poses of every kind: loads, specks, giants, flat and thin boxes, inside and outside the bounds.
OrientedBox anyBox(const Bounds& b, scenes::Random& random) {
  OrientedBox box = scenes::anyLoad(b, random);
  const int kind = static_cast<int>(scenes::uniform(random, 0, 6));
  if (kind == 0) box.size *= 1e-3;
  if (kind == 1) box.size *= 20;
  if (kind == 2) box.size[static_cast<int>(scenes::uniform(random, 0, 3))] = 0;
  if (kind == 3) box.centre *= 3;
  if (kind == 4) box.rotation.setIdentity();
  return box;
}

void compare(const EnvironmentModel& model, int poses, scenes::Random& random) {
  ExactClearance exact;
  exact.rebuild(model);
  for (int n = 0; n < poses; ++n) {
    const OrientedBox box = anyBox(model.geometry().bounds(), random);
    const Clearance found = exact.query(box, far);
    const auto truth = everyCell(model, box);
    QCOMPARE(found.nearest.has_value(), truth.has_value());
    if (!truth) continue;
    QVERIFY2(std::abs(found.nearest->distance - *truth) <= 1e-12,
             qPrintable(QString("pose %1: %2 instead of %3")
                            .arg(n)
                            .arg(found.nearest->distance, 0, 'g', 17)
                            .arg(*truth, 0, 'g', 17)));
    QVERIFY(onSurface(model, found.nearest->onEnvironment));
    const double apart = (found.nearest->onLoad - found.nearest->onEnvironment).norm();
    BW_COMPARE_NEAR(apart, found.nearest->distance, 1e-12);
  }
}

}  // namespace

class TestExactClearance : public QObject {
  Q_OBJECT

  const GridGeometry m_small{{-2, 2, -1.5, 1.5, 0, 5}, 0.05};

 private slots:
  void equalsEveryCellInTenThousandPoses() {
    scenes::Random random(1);
    // Sizes that are and are not multiples of the pyramid's fan, one of them a single line.
    const GridGeometry geometries[] = {
        {{-2, 2, -1.5, 1.5, 0, 10}, 0.05}, {{-3.2, 3.2, -3.2, 1.6, -0.4, 8}, 0.13},
        {{0, 1.03, -8, 8, 0, 10}, 0.1},    {{-5, 5, 0, 0.1, 1, 9}, 0.1},
        {{-2, 2, -2, 2, 0, 10}, 0.125},
    };
    for (const GridGeometry& geometry : geometries) {
      compare(scenes::forest(geometry, random, 6), 500, random);
      compare(scenes::forest(geometry, random, 6, 0.5), 500, random);
      compare(scenes::forest(geometry, random, 2, 0.999), 500, random);
      compare(scenes::flatFloor(geometry, 4.0), 500, random);
    }
  }

  void measuresALevelBoxAboveAFloorInClosedForm() {
    const EnvironmentModel model = scenes::flatFloor(m_small, 4.0);
    const double floor = m_small.zOf(m_small.levelOf(4.0));
    const Clearance found = clearanceOf(model, {{0, 0, 2}, {1, 0.4, 0.6}});
    QVERIFY(found.state == ClearanceState::Measured);
    QCOMPARE(found.nearest->distance, floor - 2.3);
    QVERIFY(found.nearest->part == LoadPart::Face);
    QCOMPARE(found.nearest->quantisation, m_small.levelStep() / 2);
    QCOMPARE(found.nearest->onLoad.z(), 2.3);
    QVERIFY(!found.observedShare);
    QVERIFY(found.rays.empty());
  }

  void measuresATiltedBoxInClosedForm() {
    // Turned by 45 degrees about y, an edge points at the floor, half a diagonal below the centre.
    const EnvironmentModel model = scenes::flatFloor(m_small, 4.0);
    const double floor = m_small.zOf(m_small.levelOf(4.0));
    const double x = m_small.xOf(40);  // the edge lies above a column of cell centres
    const OrientedBox box{{x, 0, 2}, {1, 0.4, 1}, rotationFromYawPitchRoll(M_PI / 4, 0, 0)};
    const Clearance found = clearanceOf(model, box);
    BW_COMPARE_NEAR(found.nearest->distance, floor - 2 - std::sqrt(0.5), 1e-12);
    QVERIFY(found.nearest->part == LoadPart::Edge);
  }

  void namesTheCornerThatIsNearest() {
    EnvironmentModel model(m_small);
    model.set(70, 50, 0.6F, 200);
    const Vector3d p = m_small.surfacePoint(70, 50, 200);
    const OrientedBox box{p - Vector3d(0.5, 0.5, 0.5) - Vector3d(0.1, 0.2, 0.2), {1, 1, 1}};
    const Clearance found = clearanceOf(model, box);
    BW_COMPARE_NEAR(found.nearest->distance, 0.3, 1e-12);
    QVERIFY(found.nearest->part == LoadPart::Corner);
    QVERIFY((found.nearest->onEnvironment - p).norm() < 1e-12);
    QVERIFY((found.nearest->onLoad - (p - Vector3d(0.1, 0.2, 0.2))).norm() < 1e-12);
    // Half of a cell along n = (1, 2, 2) / 3.
    const double half = (0.05 + 2 * 0.05 + 2 * m_small.levelStep()) / 3 / 2;
    BW_COMPARE_NEAR(found.nearest->quantisation, half, 1e-12);
  }

  void reportsZeroWhenTheEnvironmentIsInsideTheLoad() {
    EnvironmentModel model(m_small);
    model.set(40, 30, 0.6F, 100);
    const Vector3d p = m_small.surfacePoint(40, 30, 100);
    const OrientedBox box{
        p + Vector3d(0.1, -0.05, 0.02), {0.4, 0.4, 0.4}, rotationFromYawPitchRoll(0.3, 0.2, 0.1)};
    const Clearance found = clearanceOf(model, box);
    QCOMPARE(found.nearest->distance, 0.0);
    QVERIFY(found.nearest->part == LoadPart::Inside);
    QCOMPARE(found.nearest->onLoad, found.nearest->onEnvironment);
    QVERIFY((found.nearest->onEnvironment - p).norm() < 1e-12);
    const double diagonal = Vector3d(0.05, 0.05, m_small.levelStep()).norm();
    QCOMPARE(found.nearest->quantisation, diagonal / 2);
  }

  void findsNothingInAnEmptyModel() {
    const Clearance found = clearanceOf(EnvironmentModel(m_small), {{0, 0, 2}, {1, 1, 1}});
    QVERIFY(found.state == ClearanceState::NothingInRange);
    QVERIFY(found.reason == Reason::None);
    QVERIFY(!found.nearest);
  }

  void findsTheOnlyCellOfTheSmallestModel() {
    EnvironmentModel model(GridGeometry({0, 0.05, 0, 0.05, 0, 5}, 0.05));
    const OrientedBox box{{0.025, 0.025, 1}, {1, 1, 1}};
    QVERIFY(clearanceOf(model, box).state == ClearanceState::NothingInRange);
    model.set(0, 0, 0.6F, 255);
    BW_COMPARE_NEAR(clearanceOf(model, box).nearest->distance, 3.5, 1e-12);
  }

  void holdsTheRange() {
    const EnvironmentModel model = scenes::flatFloor(m_small, 4.0);
    const OrientedBox box{{0, 0, 2}, {1, 0.4, 0.6}};
    const double distance = clearanceOf(model, box).nearest->distance;
    QVERIFY(clearanceOf(model, box, distance).state == ClearanceState::Measured);
    QVERIFY(clearanceOf(model, box, distance + 1e-6).state == ClearanceState::Measured);
    QVERIFY(clearanceOf(model, box, distance - 1e-6).state == ClearanceState::NothingInRange);
    QVERIFY(clearanceOf(model, box, 0).state == ClearanceState::NothingInRange);
    QVERIFY(clearanceOf(model, box, -1).state == ClearanceState::NothingInRange);
    QVERIFY(clearanceOf(model, box, std::nan("")).state == ClearanceState::Measured);
  }

  void forgetsTheOldModelWhenRebuilt() {
    ExactClearance exact;
    exact.rebuild(scenes::flatFloor(m_small, 3.0));
    exact.rebuild(scenes::flatFloor(GridGeometry({-2, 2, -1.5, 1.5, 0, 5}, 0.11), 4.0));
    const OrientedBox box{{0, 0, 2}, {1, 0.4, 0.6}};
    QVERIFY(exact.query(box, far).nearest->distance > 1.6);
    exact.rebuild(EnvironmentModel(m_small));
    QVERIFY(exact.query(box, far).state == ClearanceState::NothingInRange);
  }

  void movingAwayFromTheFloorNeverShortens() {
    scenes::Random random(3);
    ExactClearance exact;
    exact.rebuild(scenes::flatFloor(m_small, 4.5));
    OrientedBox box{{0.1, 0.2, 4}, {1, 0.3, 0.3}, scenes::anyTurn(random)};
    double last = 0;
    for (; box.centre.z() > 0; box.centre.z() -= 0.05) {
      const double distance = exact.query(box, far).nearest->distance;
      QVERIFY(distance >= last);
      last = distance;
    }
  }

  void saysWhyItCannotSearch() {
    const OrientedBox good{{0, 0, 2}, {1, 1, 1}};
    QVERIFY(ExactClearance().query(good, far).reason == Reason::NoModel);
    const EnvironmentModel model = scenes::flatFloor(m_small, 4.0);
    for (const double bad : {std::nan(""), far, -far}) {
      OrientedBox centre = good, size = good, turn = good;
      centre.centre.y() = bad;
      size.size.z() = bad;
      turn.rotation(1, 2) = bad;
      for (const OrientedBox& box : {centre, size, turn}) {
        const Clearance found = clearanceOf(model, box);
        QVERIFY(found.state == ClearanceState::Unknown);
        QVERIFY(found.reason == Reason::NoLoad);
        QVERIFY(!found.nearest);
      }
    }
    QVERIFY(clearanceOf(model, {{0, 0, 2}, {1, -1, 1}}).reason == Reason::NoLoad);
  }

  void survivesBoxesBeyondAnyReason() {
    const EnvironmentModel model = scenes::flatFloor(m_small, 4.0);
    QCOMPARE(clearanceOf(model, {{0, 0, 0}, {1e8, 1e8, 1e8}}).nearest->distance, 0.0);
    BW_COMPARE_NEAR(clearanceOf(model, {{1e6, 0, 2}, {1, 1, 1}}).nearest->distance, 1e6, 5);
    QVERIFY(clearanceOf(model, {{0, 0, 2}, {0, 0, 0}}).state == ClearanceState::Measured);
    for (const double huge : {1e10, 1e200, 1e308}) {
      QVERIFY(clearanceOf(model, {{huge, 0, 0}, {1, 1, 1}}).reason == Reason::NoLoad);
      QVERIFY(clearanceOf(model, {{0, 0, 0}, {1, huge, 1}}).reason == Reason::NoLoad);
    }
    OrientedBox skewed{{0, 0, 2}, {1, 1, 1}};
    skewed.rotation(0, 1) = 0.1;
    QVERIFY(clearanceOf(model, skewed).reason == Reason::NoLoad);
  }

  void answersSeveralThreadsAtOnce() {
    scenes::Random random(4);
    ExactClearance exact;
    exact.rebuild(scenes::forest(m_small, random, 4));
    std::vector<OrientedBox> boxes;
    for (int n = 0; n < 200; ++n) boxes.push_back(anyBox(m_small.bounds(), random));
    const auto distances = [&] {
      std::vector<double> result;
      for (const auto& box : boxes) result.push_back(exact.query(box, far).nearest->distance);
      return result;
    };
    const auto alone = distances();
    auto first = std::async(std::launch::async, distances);
    auto second = std::async(std::launch::async, distances);
    QCOMPARE(first.get(), alone);
    QCOMPARE(second.get(), alone);
  }
};

BOOMWATCH_TEST(TestExactClearance)
#include "test_exact_clearance.moc"
