#include <QtTest>
#include <cmath>
#include <numbers>

#include "lab/evaluation/track_score.h"
#include "support/compare_near.h"
#include "support/test_registry.h"
#include "support/tracked_target.h"
#include "tracking/cmt_tracker.h"
#include "tracking/keypoint_consensus.h"

using namespace boomwatch;
using boomwatch::test::TargetScene;

namespace {

const cv::Point2d beginning(160.0, 120.0);

/// Points that turned about (160, 120), grew, and of which every fifth went astray.
std::vector<KeypointPair> pairs(double rotation, double scale, bool astray) {
  cv::RNG random(7);
  std::vector<KeypointPair> points;
  const KeypointPose pose{beginning, scale, rotation};
  for (int id = 0; id < 60; ++id) {
    const cv::Point2d model(random.uniform(-40.0, 40.0), random.uniform(-40.0, 40.0));
    cv::Point2d position = placeOf(pose, model);
    if (astray && id % 5 == 0) {
      position = {random.uniform(0.0, 320.0), random.uniform(0.0, 240.0)};
    }
    points.push_back({id, model, position});
  }
  return points;
}

}  // namespace

/// The published behaviour: turns and changes of size in the plane, loss and finding again.
class TestCmtTracker : public QObject {
  Q_OBJECT
 private slots:
  void consensusOfKnownMotion_data();
  void consensusOfKnownMotion();
  void consensusNeedsTwoPoints();
  void followsAWholeTurn();
  void followsScale_data();
  void followsScale();
  void aRectangleStandsUprightAfterAQuarterTurn();
  void findsAgainElsewhereAndTurned();
  void isNotFoundWhereItIsNot();
  void isLookedForAgainInAnotherSize();
  void looksOnlyWhereItIsTold();

 private:
  const TargetScene m_scene;
};

void TestCmtTracker::consensusOfKnownMotion_data() {
  QTest::addColumn<double>("degrees");
  QTest::addColumn<double>("scale");
  for (const double degrees : {0.0, 30.0, 90.0, 179.0, 180.0, -120.0}) {
    for (const double scale : {0.5, 1.0, 2.0}) {
      QTest::addRow("%g degrees, %g", degrees, scale) << degrees << scale;
    }
  }
}

void TestCmtTracker::consensusOfKnownMotion() {
  QFETCH(double, degrees);
  QFETCH(double, scale);
  const double rotation = degrees * std::numbers::pi / 180.0;
  for (const bool astray : {false, true}) {
    const auto consensus = consensusOf(pairs(rotation, scale, astray), 10.0);
    QVERIFY(consensus);
    // A fifth of the points are wrong, and so 36 % of the pairs: the medians shift a little.
    const double share = astray ? 0.15 : 1e-9;
    BW_COMPARE_NEAR(consensus->pose.scale / scale, 1.0, share);
    const double off = std::remainder(consensus->pose.rotation - rotation, 2 * std::numbers::pi);
    BW_COMPARE_NEAR(off, 0.0, share);
    QVERIFY(cv::norm(consensus->pose.centre - beginning) <= (astray ? 6.0 : 1e-6));
    const auto strays = std::count_if(consensus->points.begin(), consensus->points.end(),
                                      [](const KeypointPair& point) { return point.id % 5 == 0; });
    QVERIFY(!astray || strays <= 4);
  }
}

void TestCmtTracker::consensusNeedsTwoPoints() {
  QVERIFY(!consensusOf({}, 10.0));
  QVERIFY(!consensusOf({{0, {1, 1}, {50, 50}}}, 10.0));
  // Two that were one and the same point say nothing of scale.
  QVERIFY(!consensusOf({{0, {1, 1}, {50, 50}}, {1, {1, 1}, {60, 50}}}, 10.0));
}

void TestCmtTracker::followsAWholeTurn() {
  CmtTracker tracker;
  tracker.start(m_scene.image(beginning), TargetScene::box(beginning));
  for (int angle = 6; angle <= 360; angle += 6) {
    const Track track = tracker.track(m_scene.image(beginning, angle));
    QVERIFY2(track.box, qPrintable(QStringLiteral("lost at %1 degrees").arg(angle)));
    QCOMPARE(toString(track.state), toString(TrackState::Tracked));
    QVERIFY(overlapOf(*track.box, TargetScene::box(beginning)) > 0.75);
    QVERIFY(track.confidence > 0.05 && track.confidence <= 1.0);
  }
}

void TestCmtTracker::followsScale_data() {
  QTest::addColumn<double>("factor");
  QTest::newRow("to half its size") << 0.97;
  QTest::newRow("to twice its size") << 1.03;
}

void TestCmtTracker::followsScale() {
  QFETCH(double, factor);
  CmtTracker tracker;
  tracker.start(m_scene.image(beginning), TargetScene::box(beginning));
  for (double scale = factor; scale > 0.5 && scale < 2.0; scale *= factor) {
    const Track track = tracker.track(m_scene.image(beginning, 0.0, scale));
    QVERIFY2(track.box, qPrintable(QStringLiteral("lost at %1").arg(scale)));
    const double overlap = overlapOf(*track.box, TargetScene::box(beginning, scale));
    QVERIFY2(overlap > 0.7, qPrintable(QStringLiteral("%1 at %2").arg(overlap).arg(scale)));
  }
}

/// The middle of the target as a flat box: 80 x 40 becomes 40 x 80.
void TestCmtTracker::aRectangleStandsUprightAfterAQuarterTurn() {
  CmtTracker tracker;
  tracker.start(m_scene.image(beginning), {beginning.x - 40, beginning.y - 20, 80, 40});
  Track track;
  for (int angle = 6; angle <= 90; angle += 6)
    track = tracker.track(m_scene.image(beginning, angle));
  QVERIFY(track.box);
  QVERIFY(overlapOf(*track.box, {beginning.x - 20, beginning.y - 40, 40, 80}) > 0.75);
}

void TestCmtTracker::findsAgainElsewhereAndTurned() {
  CmtTracker tracker;
  tracker.start(m_scene.image(beginning), TargetScene::box(beginning));
  for (int frame = 0; frame < 5; ++frame) {
    const Track track = tracker.track(m_scene.wall());
    QCOMPARE(toString(track.state), toString(TrackState::Lost));
    QVERIFY(!track.box);
  }
  const cv::Point2d elsewhere(70.0, 90.0);
  const Track again = tracker.track(m_scene.image(elsewhere, 40.0));
  QCOMPARE(toString(again.state), toString(TrackState::Refound));
  QVERIFY(overlapOf(*again.box, TargetScene::box(elsewhere)) > 0.7);
  QCOMPARE(toString(tracker.track(m_scene.image(elsewhere, 40.0)).state),
           toString(TrackState::Tracked));
}

void TestCmtTracker::isNotFoundWhereItIsNot() {
  CmtTracker tracker;
  tracker.start(m_scene.image(beginning), TargetScene::box(beginning));
  for (unsigned seed = 10; seed < 30; ++seed) {
    const cv::Mat other = boomwatch::test::texture({320, 240}, 2.0, seed);
    QVERIFY2(!tracker.track(other).box, qPrintable(QString::number(seed)));
  }
}

void TestCmtTracker::isLookedForAgainInAnotherSize() {
  CmtTracker tracker;
  tracker.start(m_scene.image(beginning), TargetScene::box(beginning));
  cv::Mat wider;
  cv::copyMakeBorder(m_scene.image(beginning), wider, 0, 100, 50, 0, cv::BORDER_CONSTANT);
  const Track track = tracker.track(wider);
  QVERIFY(track.box);
  QVERIFY(overlapOf(*track.box, TargetScene::box(beginning + cv::Point2d(50.0, 0.0))) > 0.7);
}

void TestCmtTracker::looksOnlyWhereItIsTold() {
  CmtTracker tracker(KeypointReach::DensePart);
  tracker.start(m_scene.image(beginning), TargetScene::box(beginning));
  cv::Point2d place = beginning;
  for (int frame = 1; frame <= 10; ++frame) {
    place += cv::Point2d(4.0, 2.0);
    const Track track = tracker.track(m_scene.image(place));
    QVERIFY(track.box && overlapOf(*track.box, TargetScene::box(place)) > 0.7);
  }
  const cv::Point2d elsewhere(60.0, 70.0);
  QVERIFY(!tracker.track(m_scene.image(elsewhere)).box);
  tracker.lookAt(TargetScene::box(elsewhere + cv::Point2d(8.0, -6.0)));
  const Track track = tracker.track(m_scene.image(elsewhere));
  QVERIFY(track.box && overlapOf(*track.box, TargetScene::box(elsewhere)) > 0.7);
  tracker.lookAt({-500.0, 0.0, 80.0, 80.0});  // nowhere
  QVERIFY(!tracker.track(m_scene.image(elsewhere)).box);
}

BOOMWATCH_TEST(TestCmtTracker)
#include "test_cmt_tracker.moc"
