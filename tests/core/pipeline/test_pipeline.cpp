#include <QtTest>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "pipeline/pipeline.h"
#include "support/compare_near.h"
#include "support/flat_scene.h"
#include "support/test_registry.h"

using namespace boomwatch;
using namespace boomwatch::test;

namespace {

/// Names, so that a failed comparison says which.
template <class Enum>
QByteArray text(Enum value) {
  return QByteArray(toString(value).data());
}

Result runWall(Pipeline& pipeline, const Parameters& parameters, int frames, float z,
               std::uint64_t first = 0) {
  Result result;
  for (int i = 0; i < frames; ++i) {
    result = pipeline.process(wallFrame(first + static_cast<std::uint64_t>(i), z), parameters);
  }
  return result;
}

}  // namespace

class TestPipeline : public QObject {
  Q_OBJECT
 private slots:
  void saysWhyWhileTheModelIsNew();
  void measuresTheWallFromTheFourthFrameOn();
  void movingAwayNeverShortens();
  void noLoadIsNoDistance();
  void aLoadOutsideTheBoundsIsNoDistance();
  void aLoadThatIsNotANumberIsNoLoad();
  void repeatedFramesAreNoDistance();
  void tooFewDepthPixelsAreNoDistanceAndTeachNothing();
  void aMovingPictureIsNoDistance();
  void probtreshTooHighNeverMeasures();
  void aNewResolutionTakesEffectAtTheNextFrame();
  void contradictingParametersThrow();
  void nothingObservedAroundTheLoadIsUnknown();
  void pointsInsideTheLoadAreRemovedAndShown();
  void anObstacleThatTheLoadEntersIsACollision();
  void aFrameFromAnotherTimeIsNotMeasuredAgainstTheOldModel_data();
  void aFrameFromAnotherTimeIsNotMeasuredAgainstTheOldModel();
  void aFewLostFramesCostNothing();
  void nothingAroundTheLoadIsUnknownEvenWhereNoShareIsAskedFor();
  void aSearchThatEndsBeforeCautionBeginsIsNeverClear_data();
  void aSearchThatEndsBeforeCautionBeginsIsNeverClear();
  void aFrameWithoutAnythingIsUnreadable();
  void rays_data();
  void rays();
};

void TestPipeline::saysWhyWhileTheModelIsNew() {
  Parameters parameters = smallParameters();
  hangLoad(parameters, 1.5);
  Pipeline pipeline;
  const Result result = runWall(pipeline, parameters, 3, 3.0F);
  QCOMPARE(text(result.clearance.reason), text(Reason::NoModel));
  QVERIFY(!result.clearance.nearest);
  QCOMPARE(text(result.level), text(WarningLevel::NoDistance));
}

void TestPipeline::measuresTheWallFromTheFourthFrameOn() {
  Parameters parameters = smallParameters();
  hangLoad(parameters, 1.5);
  Pipeline pipeline;
  const Result result = runWall(pipeline, parameters, 4, 3.0F);
  QCOMPARE(text(result.clearance.state), text(ClearanceState::Measured));
  QCOMPARE(text(result.clearance.reason), text(Reason::None));
  const Nearest& nearest = *result.clearance.nearest;
  // The load's far face is at 1.7 m.
  BW_COMPARE_NEAR(nearest.distance, 1.3, nearest.quantisation);
  QCOMPARE(text(result.level), text(WarningLevel::Caution));
  QVERIFY(*result.clearance.observedShare > 0.95);
  QVERIFY(!result.depthUncertainty);
  QVERIFY(!result.timings.empty());
}

void TestPipeline::movingAwayNeverShortens() {
  Parameters parameters = smallParameters();
  Pipeline pipeline;
  hangLoad(parameters, 2.5);
  double last = runWall(pipeline, parameters, 4, 3.0F).clearance.nearest->distance;
  std::uint64_t sequence = 4;
  for (double z = 2.4; z > 0.5; z -= 0.1) {
    hangLoad(parameters, z);
    const Result result = pipeline.process(wallFrame(sequence++, 3.0F), parameters);
    QVERIFY(result.clearance.nearest->distance >= last);
    last = result.clearance.nearest->distance;
  }
}

void TestPipeline::noLoadIsNoDistance() {
  Pipeline pipeline;
  const Result result = runWall(pipeline, smallParameters(), 5, 3.0F);
  QCOMPARE(text(result.clearance.reason), text(Reason::NoLoad));
  QCOMPARE(text(result.level), text(WarningLevel::NoDistance));
}

void TestPipeline::aLoadOutsideTheBoundsIsNoDistance() {
  Parameters parameters = smallParameters();
  hangLoad(parameters, 1.5);
  parameters.load.x = 7.0;
  Pipeline pipeline;
  QCOMPARE(text(runWall(pipeline, parameters, 5, 3.0F).clearance.reason),
           text(Reason::LoadOutside));
}

void TestPipeline::aLoadThatIsNotANumberIsNoLoad() {
  Pipeline pipeline;
  auto frame = std::make_shared<Frame>(*wallFrame(0, 3.0F));
  frame->load = OrientedBox{};
  frame->load->centre.x() = std::numeric_limits<double>::quiet_NaN();
  QCOMPARE(text(pipeline.process(frame, smallParameters()).clearance.reason), text(Reason::NoLoad));
}

void TestPipeline::repeatedFramesAreNoDistance() {
  Parameters parameters = smallParameters();
  hangLoad(parameters, 1.5);
  Pipeline pipeline;
  QVERIFY(runWall(pipeline, parameters, 5, 3.0F).clearance.nearest);
  const FramePtr frozen = wallFrame(5, 3.0F);
  QVERIFY(pipeline.process(frozen, parameters).clearance.nearest);
  QVERIFY(pipeline.process(frozen, parameters).clearance.nearest);
  const Result third = pipeline.process(frozen, parameters);
  QCOMPARE(text(third.clearance.reason), text(Reason::IdenticalFrames));
  QVERIFY(!third.clearance.nearest);
  QVERIFY(pipeline.process(wallFrame(8, 3.0F), parameters).clearance.nearest);
}

void TestPipeline::tooFewDepthPixelsAreNoDistanceAndTeachNothing() {
  Parameters parameters = smallParameters();
  hangLoad(parameters, 1.5);
  Pipeline pipeline;
  runWall(pipeline, parameters, 5, 3.0F);
  auto blind = std::make_shared<Frame>(*wallFrame(5, 3.0F));
  auto cloud = std::make_shared<Cloud>(*blind->cloud);
  std::fill(cloud->points.begin(), cloud->points.end(), unmeasuredPoint());
  blind->cloud = cloud;
  const Result result = pipeline.process(blind, parameters);
  QCOMPARE(text(result.clearance.reason), text(Reason::FewDepthPixels));
  QCOMPARE(result.fill, 0.0);
  // What was learnt before stands: the next good frame measures at once.
  QVERIFY(pipeline.process(wallFrame(6, 3.0F), parameters).clearance.nearest);
}

void TestPipeline::aMovingPictureIsNoDistance() {
  Parameters parameters = smallParameters();
  hangLoad(parameters, 1.5);
  Pipeline pipeline;
  runWall(pipeline, parameters, 5, 3.0F);
  Result result;
  for (int i = 0; i < 4; ++i) {
    result = pipeline.process(wallFrame(static_cast<std::uint64_t>(5 + i), 3.0F, 3 * (i + 1)),
                              parameters);
    QCOMPARE(text(result.clearance.reason), text(Reason::SceneMoves));
  }
  // It moved for so long that the model is begun anew when the camera rests.
  result = pipeline.process(wallFrame(9, 3.0F, 12), parameters);
  QCOMPARE(text(result.clearance.reason), text(Reason::NoModel));
  QVERIFY(result.modelRebuilt);
}

void TestPipeline::probtreshTooHighNeverMeasures() {
  Parameters parameters = smallParameters();
  hangLoad(parameters, 1.5);
  parameters.model.probtresh = 0.67;
  Pipeline pipeline;
  QCOMPARE(text(runWall(pipeline, parameters, 30, 3.0F).clearance.reason), text(Reason::NoModel));
}

void TestPipeline::aNewResolutionTakesEffectAtTheNextFrame() {
  Parameters parameters = smallParameters();
  hangLoad(parameters, 1.5);
  Pipeline pipeline;
  QVERIFY(!runWall(pipeline, parameters, 5, 3.0F).modelRebuilt);
  parameters.model.resolution = 0.1;
  const Result result = pipeline.process(wallFrame(5, 3.0F), parameters);
  QVERIFY(result.modelRebuilt);
  QCOMPARE(pipeline.model().geometry().columns(), 40);
  QCOMPARE(text(result.clearance.reason), text(Reason::NoModel));
}

void TestPipeline::contradictingParametersThrow() {
  Parameters parameters = smallParameters();
  parameters.bounds.xMin = 3.0;
  Pipeline pipeline;
  QVERIFY_EXCEPTION_THROWN(pipeline.process(wallFrame(0, 3.0F), parameters), Error);
}

void TestPipeline::nothingObservedAroundTheLoadIsUnknown() {
  Parameters parameters = smallParameters();
  hangLoad(parameters, 1.5, 0.2);
  parameters.load.x = 1.5;
  parameters.warning = {0.5, 0.25};
  parameters.clearance.range = 0.5;
  Pipeline pipeline;
  Result result;
  for (std::uint64_t i = 0; i < 6; ++i) {
    auto frame = std::make_shared<Frame>(*wallFrame(i, 4.0F));
    auto cloud = std::make_shared<Cloud>(*frame->cloud);
    for (auto& point : cloud->points) {
      if (point.x() > -1.5F) point = unmeasuredPoint();
    }
    frame->cloud = cloud;
    result = pipeline.process(frame, parameters);
  }
  QCOMPARE(text(result.clearance.reason), text(Reason::NothingObserved));
  QVERIFY(*result.clearance.observedShare < 0.1);
  QCOMPARE(text(result.level), text(WarningLevel::NoDistance));
}

void TestPipeline::pointsInsideTheLoadAreRemovedAndShown() {
  Parameters parameters = smallParameters();
  hangLoad(parameters, 3.0, 0.5);
  Pipeline pipeline;
  const Result result = runWall(pipeline, parameters, 5, 3.0F);
  QVERIFY(!result.scene.removed.empty());
  // With a cell more, and three standard deviations of the depth at 3 m.
  OrientedBox volume = *result.load;
  volume.size.array() += 2.0 * (parameters.model.resolution + 0.04);
  int besideLoad = 0;
  for (const auto& point : result.scene.removed) {
    QVERIFY(volume.contains(point.cast<double>()));
    besideLoad += !result.load->contains(point.cast<double>());
  }
  QVERIFY(besideLoad > 0);
}

void TestPipeline::anObstacleThatTheLoadEntersIsACollision() {
  Parameters parameters = smallParameters();
  hangLoad(parameters, 1.5, 0.5);
  Pipeline pipeline;
  runWall(pipeline, parameters, 5, 3.0F);
  hangLoad(parameters, 2.9, 0.5);
  for (std::uint64_t i = 5; i < 10; ++i) {
    const Result result = pipeline.process(wallFrame(i, 3.0F), parameters);
    QCOMPARE(result.clearance.nearest->distance, 0.0);
    QCOMPARE(text(result.level), text(WarningLevel::Collision));
  }
}

void TestPipeline::aFrameFromAnotherTimeIsNotMeasuredAgainstTheOldModel_data() {
  QTest::addColumn<int>("first");
  QTest::newRow("wound back") << 2;
  QTest::newRow("begun anew") << 0;
  QTest::newRow("wound on") << 300;
}

void TestPipeline::aFrameFromAnotherTimeIsNotMeasuredAgainstTheOldModel() {
  QFETCH(int, first);
  Parameters parameters = smallParameters();
  hangLoad(parameters, 1.5);
  Pipeline pipeline;
  runWall(pipeline, parameters, 8, 3.5F);
  const auto begin = static_cast<std::uint64_t>(first);
  const Result there = runWall(pipeline, parameters, 1, 3.0F, begin);
  QCOMPARE(text(there.clearance.reason), text(Reason::NoModel));
  const Result later = runWall(pipeline, parameters, 3, 3.0F, begin + 1);
  BW_COMPARE_NEAR(later.clearance.nearest->distance, 1.3, later.clearance.nearest->quantisation);
}

void TestPipeline::aFewLostFramesCostNothing() {
  Parameters parameters = smallParameters();
  hangLoad(parameters, 1.5);
  Pipeline pipeline;
  runWall(pipeline, parameters, 5, 3.0F);
  QVERIFY(runWall(pipeline, parameters, 1, 3.0F, 15).clearance.nearest);
}

void TestPipeline::nothingAroundTheLoadIsUnknownEvenWhereNoShareIsAskedFor() {
  Parameters parameters = smallParameters();
  hangLoad(parameters, 1.5, 0.2);
  parameters.validity.minObserved = 0.0;
  parameters.validity.minFill = 0.0;
  Pipeline pipeline;
  Result result;
  for (std::uint64_t i = 0; i < 6; ++i) {
    auto frame = std::make_shared<Frame>(*wallFrame(i, 3.0F));
    auto cloud = std::make_shared<Cloud>(*frame->cloud);
    for (auto& point : cloud->points) point = unmeasuredPoint();
    frame->cloud = cloud;
    result = pipeline.process(frame, parameters);
  }
  QCOMPARE(text(result.clearance.reason), text(Reason::NothingObserved));
  QCOMPARE(text(result.level), text(WarningLevel::NoDistance));
}

void TestPipeline::aSearchThatEndsBeforeCautionBeginsIsNeverClear_data() {
  QTest::addColumn<ClearanceMethod>("method");
  QTest::addColumn<double>("range");
  QTest::addColumn<int>("radius");
  QTest::addColumn<bool>("measured");
  // The wall is 1.3 m behind the load; caution begins at 2 m.
  QTest::newRow("exact, too short") << ClearanceMethod::Exact << 1.2 << 70 << false;
  QTest::newRow("exact, long enough") << ClearanceMethod::Exact << 1.4 << 70 << true;
  // Rays see what is behind the load at any distance, but nothing beside it beyond their length.
  QTest::newRow("rays, too short") << ClearanceMethod::Rays << 10.0 << 24 << false;
  QTest::newRow("rays, long enough") << ClearanceMethod::Rays << 10.0 << 28 << true;
}

void TestPipeline::aSearchThatEndsBeforeCautionBeginsIsNeverClear() {
  QFETCH(ClearanceMethod, method);
  QFETCH(double, range);
  QFETCH(int, radius);
  QFETCH(bool, measured);
  Parameters parameters = smallParameters();
  hangLoad(parameters, 1.5);
  parameters.clearance = {method, 8, radius, range};
  Pipeline pipeline;
  const Result result = runWall(pipeline, parameters, 5, 3.0F);
  QCOMPARE(result.clearance.nearest.has_value(), measured);
  QCOMPARE(result.clearance.rays.empty(), method == ClearanceMethod::Exact);
  QCOMPARE(text(result.level), text(measured ? WarningLevel::Caution : WarningLevel::NoDistance));
  QCOMPARE(text(result.clearance.reason), text(measured ? Reason::None : Reason::SearchTooShort));
  if (!measured) return;
  BW_COMPARE_NEAR(result.clearance.nearest->distance, 1.3,
                  result.clearance.nearest->quantisation + 1e-9);
}

void TestPipeline::aFrameWithoutAnythingIsUnreadable() {
  Pipeline pipeline;
  const Result result = pipeline.process(std::make_shared<Frame>(), smallParameters());
  QCOMPARE(text(result.clearance.reason), text(Reason::UnreadableFrame));
  QVERIFY(!result.message.empty());
}

void TestPipeline::rays_data() {
  QTest::addColumn<double>("x");
  QTest::newRow("inside the grid") << 0.0;
  QTest::newRow("at its edge") << 1.9;
}

void TestPipeline::rays() {
  QFETCH(double, x);
  Parameters parameters = smallParameters();
  hangLoad(parameters, 1.5);
  parameters.load.x = x;
  parameters.clearance.method = ClearanceMethod::Rays;
  parameters.clearance.radius =
      static_cast<int>(std::ceil(parameters.warning.cautionDistance / parameters.model.resolution));
  Pipeline pipeline;
  const Result result = runWall(pipeline, parameters, 5, 3.0F);
  QVERIFY(!result.clearance.rays.empty());
  BW_COMPARE_NEAR(result.clearance.nearest->distance, 1.3,
                  result.clearance.nearest->quantisation + 1e-9);
}

BOOMWATCH_TEST(TestPipeline)
#include "test_pipeline.moc"
