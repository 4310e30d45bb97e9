#include <QtTest>

#include "environment/cell_update.h"
#include "pipeline/model_gate.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

/// One frame, as the earlier stages hand it to the gate: valid, without tool and load.
struct Moment {
  FrameChecks::Verdict verdict;
  ToolTrack tool;
  CarriedLoad load;
  StaticScene scene;
};

/// A tracked tool that was found, and a detected load.
Moment withTool() {
  Moment moment;
  moment.tool.state = TrackState::Tracked;
  moment.tool.point = Eigen::Vector3f(0, 0, 5);
  moment.tool.age = 0.0;
  moment.load.source = LoadSource::Detected;
  moment.load.box = OrientedBox{};
  moment.scene.toolMask = ToolMask::Taken;
  return moment;
}

class Gate {
 public:
  ModelGate::Decision decide(double stamp, const Moment& m) {
    return m_gate.decide(stamp, m.verdict, m.tool, m.load, m.scene, parameters);
  }
  Parameters parameters;

 private:
  ModelGate m_gate;
};

}  // namespace

class TestModelGate : public QObject {
  Q_OBJECT
 private slots:
  void aValidFrameUpdatesTheModel();
  void anInvalidFrameDoesNot();
  void aFrameWithoutTheTrackedToolDoesNot();
  void anUnmaskedCraneHoldsTheModelForAsLongAsAToolMayBeAway();
  void withoutALoadAnUnmaskedCraneHoldsTheModelForGood();
  void theFirstToolPointForgetsTheModelThatHoldsTheCrane();
  void anUntrustedHistoryForgetsTheModel();
  void whatWasWithheldGetsItsTimeToEnter();
};

void TestModelGate::aValidFrameUpdatesTheModel() {
  for (const Moment& moment : {Moment{}, withTool()}) {
    const ModelGate::Decision decision = Gate{}.decide(0.0, moment);
    QVERIFY(decision.update && !decision.forget);
    QVERIFY(decision.modelFault == Reason::None);
  }
}

void TestModelGate::anInvalidFrameDoesNot() {
  Moment moment = withTool();
  moment.verdict.reason = Reason::FewDepthPixels;
  QVERIFY(!Gate{}.decide(0.0, moment).update);
}

void TestModelGate::aFrameWithoutTheTrackedToolDoesNot() {
  Moment moment = withTool();
  moment.tool.point.reset();
  QVERIFY(!Gate{}.decide(0.0, moment).update);
}

void TestModelGate::anUnmaskedCraneHoldsTheModelForAsLongAsAToolMayBeAway() {
  Gate gate;
  const double maxAge = gate.parameters.tracking.maxToolAge;
  Moment unmasked = withTool();
  unmasked.scene.toolMask = ToolMask::TooLarge;
  QVERIFY(!gate.decide(10.0, unmasked).update);
  QVERIFY(!gate.decide(10.0 + maxAge, unmasked).update);
  QVERIFY(gate.decide(10.1 + maxAge, unmasked).update);
  // A masked frame in between starts the time anew, and so does a clock that was set back.
  QVERIFY(gate.decide(10.2 + maxAge, withTool()).update);
  QVERIFY(!gate.decide(10.3 + maxAge, unmasked).update);
  QVERIFY(!gate.decide(5.0, unmasked).update);
}

void TestModelGate::withoutALoadAnUnmaskedCraneHoldsTheModelForGood() {
  Gate gate;
  Moment unmasked = withTool();
  unmasked.scene.toolMask = ToolMask::NothingThere;
  unmasked.load.box.reset();
  for (int k = 0; k < 50; ++k) QVERIFY(!gate.decide(k, unmasked).update);
}

void TestModelGate::theFirstToolPointForgetsTheModelThatHoldsTheCrane() {
  Gate gate;
  QVERIFY(gate.decide(0.0, Moment{}).update);
  QVERIFY(gate.decide(0.1, withTool()).forget);
  QVERIFY(!gate.decide(0.2, withTool()).forget);
  QVERIFY(!Gate{}.decide(0.0, withTool()).forget);
}

void TestModelGate::anUntrustedHistoryForgetsTheModel() {
  Moment moment = withTool();
  moment.verdict.modelIsStale = true;
  const ModelGate::Decision decision = Gate{}.decide(0.0, moment);
  QVERIFY(decision.forget && decision.update);
}

void TestModelGate::whatWasWithheldGetsItsTimeToEnter() {
  Gate gate;
  Moment withheld = withTool();
  withheld.scene.maybeLoad = 5;
  QVERIFY(gate.decide(0.0, withheld).modelFault == Reason::NoModel);
  const int frames = framesToEnter(gate.parameters.model).value();
  QVERIFY(frames > 1);
  Moment invalid = withTool();
  invalid.verdict.reason = Reason::SceneMoves;  // no update, and so no step towards the model
  QVERIFY(gate.decide(0.1, invalid).modelFault == Reason::NoModel);
  for (int k = 1; k < frames; ++k) {
    QVERIFY(gate.decide(0.1 + 0.1 * k, withTool()).modelFault == Reason::NoModel);
  }
  QVERIFY(gate.decide(9.0, withTool()).modelFault == Reason::None);
}

BOOMWATCH_TEST(TestModelGate)
#include "test_model_gate.moc"
