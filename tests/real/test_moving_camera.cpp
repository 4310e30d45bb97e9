#include <QtTest>

#include "support/real_data.h"
#include "support/sequence.h"
#include "support/test_registry.h"

using namespace boomwatch;
using namespace boomwatch::test;

/// A drive through a street: the model's camera stands still, this one does not.
class TestMovingCamera : public QObject {
  Q_OBJECT
 private slots:
  void saysThatTheSceneMovesRatherThanTrustTheModel();
};

void TestMovingCamera::saysThatTheSceneMovesRatherThanTrustTheModel() {
  const QString recording = sharedData("stereo_seq_kitti_odometry/KITTI_sequence_1");
  REQUIRE_DATA(recording);
  Parameters parameters;
  parameters.bounds = {-8.0, 8.0, -2.0, 2.0, 2.0, 30.0};
  parameters.model.resolution = 0.12;
  parameters.stereo.disparities = 128;
  parameters.load.source = LoadSource::Manual;
  parameters.load.z = 6.0;
  std::size_t moving = 0, measured = 0, clear = 0;
  const std::size_t frames =
      runSequence("stereo:" + recording, parameters, [&](const Result& result, const Pipeline&) {
        moving += result.clearance.reason == Reason::SceneMoves;
        measured += result.clearance.nearest.has_value();
        clear += result.level != WarningLevel::NoDistance;
      });
  qInfo("%zu frames: %zu say that the scene moves, %zu give a distance", frames, moving, measured);
  QCOMPARE(frames, std::size_t{51});
  // The first frame has no other to compare it with.
  QVERIFY2(moving + 3 >= frames, qPrintable(QString::number(moving)));
  QCOMPARE(measured, std::size_t{0});
  QCOMPARE(clear, std::size_t{0});
}

BOOMWATCH_TEST(TestMovingCamera)
#include "test_moving_camera.moc"
