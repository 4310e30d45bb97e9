#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

#include "patch_strip.h"
#include "support/scene_for_tests.h"
#include "support/test_registry.h"
#include "tool_texts.h"
#include "tracking/tool_model.h"
#include "tracking_dock.h"

using namespace boomwatch;

namespace {

DisplayPtr display(const ToolTrack& tool) {
  auto result = std::make_shared<Result>();
  result->tool = tool;
  return makeDisplay(result, {});
}

ToolTrack tracked() {
  ToolTrack tool;
  tool.state = TrackState::Tracked;
  tool.box = cv::Rect2d(10, 10, 40, 40);
  tool.confidence = 0.834;
  tool.learning = LearningState::Suspended;
  tool.point = Eigen::Vector3f(0, 0, 3);
  tool.age = 0.0;
  return tool;
}

std::shared_ptr<const ToolModel> model(std::size_t positives, std::size_t negatives) {
  auto made = std::make_shared<ToolModel>();
  made->size = {40, 20};
  made->positives.assign(positives, cv::Mat(10, 20, CV_8UC1, cv::Scalar(200)));
  made->negatives.assign(negatives, cv::Mat(10, 20, CV_8UC1, cv::Scalar(90)));
  return made;
}

QPushButton* button(const TrackingDock& dock, const QString& text) {
  for (QPushButton* found : dock.findChildren<QPushButton*>()) {
    if (found->text() == text) return found;
  }
  qFatal("no button %s", qPrintable(text));
}

}  // namespace

class TestTrackingDock : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void showsTheParametersAndAsksForOthers();
  void theOtherTrackersAreOneEntryAway();
  void asksForWhatTheButtonsSay();
  void onlyWhatCanBeDoneIsEnabled();
  void saysWhereTheTrackerStands_data();
  void saysWhereTheTrackerStands();
  void saysWhatIsDoubtedOrGivenUp();
  void saysWhatIsLearnt();
  void theStripShowsTheNewestAndIsBounded();
  void oddPatchesAreHarmless();
  void nothingMovesWhenTheWordsChange();
  void theKeyboardReachesEverything();
};

void TestTrackingDock::showsTheParametersAndAsksForOthers() {
  TrackingDock dock;
  QSignalSpy chosen(&dock, &TrackingDock::trackerChosen);
  QSignalSpy learning(&dock, &TrackingDock::learningChosen);
  auto* tracker = dock.findChild<QComboBox*>();
  auto* learn = dock.findChild<QCheckBox*>();
  QVERIFY(tracker->currentText().startsWith("tld"));
  QVERIFY(learn->isChecked());
  Parameters parameters;
  parameters.tracking.tracker = TrackerKind::Klt;
  parameters.tracking.learn = false;
  dock.setParameters(parameters);
  QVERIFY(tracker->currentText().startsWith("klt"));
  QVERIFY(!learn->isChecked() && !learn->isEnabled());
  QCOMPARE(chosen.count() + learning.count(), 0);
  parameters.tracking.tracker = TrackerKind::Tld;
  dock.setParameters(parameters);
  QTest::keyClick(tracker, Qt::Key_Down);
  QCOMPARE(chosen.last().first().value<TrackerKind>(), TrackerKind::Csrt);
  learn->click();
  QCOMPARE(learning.last().first().toBool(), true);
}

void TestTrackingDock::theOtherTrackersAreOneEntryAway() {
  TrackingDock dock;
  QSignalSpy chosen(&dock, &TrackingDock::trackerChosen);
  auto* tracker = dock.findChild<QComboBox*>();
  QCOMPARE(tracker->count(), 4);
  QVERIFY(!tracker->itemText(3).startsWith("cmt") && !tracker->itemText(3).startsWith("klt"));
  QTest::keyClick(tracker, Qt::Key_End);
  QCOMPARE(chosen.count(), 0);
  QVERIFY(tracker->currentText().startsWith("tld"));
  QTest::keyClick(tracker, Qt::Key_End);
  QCOMPARE(chosen.last().first().value<TrackerKind>(), TrackerKind::Klt);
  QTest::keyClick(tracker, Qt::Key_Up);
  QCOMPARE(chosen.last().first().value<TrackerKind>(), TrackerKind::Cmt);
}

void TestTrackingDock::asksForWhatTheButtonsSay() {
  TrackingDock dock;
  dock.setDisplay(display(tracked()));
  QSignalSpy box(&dock, &TrackingDock::boxWanted);
  QSignalSpy again(&dock, &TrackingDock::beginAgainWanted);
  QSignalSpy forget(&dock, &TrackingDock::forgetWanted);
  button(dock, "Draw box")->click();
  button(dock, "Restart")->click();
  button(dock, "Remove")->click();
  QCOMPARE(box.count(), 1);
  QCOMPARE(again.count(), 1);
  QCOMPARE(forget.count(), 1);
}

void TestTrackingDock::onlyWhatCanBeDoneIsEnabled() {
  TrackingDock dock;
  for (const char* text : {"Restart", "Remove", "Merge...", "Save..."}) {
    QVERIFY2(!button(dock, text)->isEnabled(), text);
  }
  QVERIFY(button(dock, "Load...")->isEnabled());
  ToolTrack tool = tracked();
  tool.model = model(3, 4);
  dock.setDisplay(display(tool));
  for (const char* text : {"Restart", "Remove", "Merge...", "Save..."}) {
    QVERIFY2(button(dock, text)->isEnabled(), text);
  }
  ToolTrack click;
  click.pixel = cv::Point(3, 4);
  dock.setDisplay(display(click));
  QVERIFY(button(dock, "Remove")->isEnabled() && !button(dock, "Save...")->isEnabled());
}

void TestTrackingDock::saysWhereTheTrackerStands_data() {
  QTest::addColumn<int>("state");
  QTest::addColumn<bool>("box");
  QTest::addColumn<bool>("point");
  QTest::addColumn<double>("age");
  QTest::addColumn<QString>("words");
  const auto row = [](const char* name, TrackState state, bool box, bool point, double age,
                      const char* words) {
    QTest::newRow(name) << static_cast<int>(state) << box << point << age << QString(words);
  };
  row("idle", TrackState::Idle, false, false, -1, "draw a box");
  row("tracked", TrackState::Tracked, true, true, 0, "tracked, confidence 83 %");
  row("found", TrackState::Refound, true, true, 0, "re-detected, confidence 83 %");
  row("unseen", TrackState::Lost, false, true, 0.3,
      "out of sight for 0.3 s: its position is extrapolated");
  row("without depth", TrackState::Tracked, true, true, 0.3,
      "without depth for 0.3 s: its position is extrapolated");
  row("lost", TrackState::Lost, false, false, 1.2,
      "lost for 1.2 s: boom and load cannot be masked");
  row("never found", TrackState::Lost, false, false, -1, "not found yet");
  row("never measured", TrackState::Tracked, true, false, -1, "without depth: boom");
  row("long without depth", TrackState::Tracked, true, false, 2.0, "without depth for 2.0 s: boom");
}

void TestTrackingDock::saysWhereTheTrackerStands() {
  QFETCH(int, state);
  QFETCH(bool, box);
  QFETCH(bool, point);
  QFETCH(double, age);
  QFETCH(QString, words);
  ToolTrack tool = tracked();
  tool.state = static_cast<TrackState>(state);
  if (!box) tool.box.reset();
  if (!point) tool.point.reset();
  tool.age = age < 0 ? std::nullopt : std::optional(age);
  TrackingDock dock;
  dock.setDisplay(display(tool));
  QVERIFY2(dock.stateText().contains(words), qPrintable(dock.stateText()));
  QCOMPARE(dock.stateText().contains("no distance"), tool.lost());
}

void TestTrackingDock::saysWhatIsDoubtedOrGivenUp() {
  TrackingDock dock;
  ToolTrack tool = tracked();
  tool.age = 0.3;
  QCOMPARE(toolLabel(tool), QString("Tool 83 %, no depth"));
  tool.isDoubted = true;
  QCOMPARE(toolLabel(tool), QString("Tool 83 %, rejected"));
  dock.setDisplay(display(tool));
  QVERIFY2(dock.stateText().contains("rejected for 0.3 s: its position is extrapolated"),
           qPrintable(dock.stateText()));
  tool.isHeld = true;
  dock.setDisplay(display(tool));
  QVERIFY2(dock.stateText().contains(
               "rejected for 0.3 s: its position is derived from the load. After 4.0 s"),
           qPrintable(dock.stateText()));
  tool.isHeld = false;
  tool.point.reset();
  tool.age = 2.0;
  dock.setDisplay(display(tool));
  QVERIFY2(dock.stateText().contains("rejected for 2.0 s: boom and load"),
           qPrintable(dock.stateText()));
  QVERIFY(!dock.stateText().contains("Restart"));
  tool.box.reset();
  tool.isDoubted = false;
  tool.hasGivenUp = true;
  dock.setDisplay(display(tool));
  QVERIFY2(dock.stateText().contains("the tracker has stopped. Restart it or draw a new box."),
           qPrintable(dock.stateText()));
}

void TestTrackingDock::saysWhatIsLearnt() {
  TrackingDock dock;
  ToolTrack tool = tracked();
  tool.model = model(12, 40);
  dock.setDisplay(display(tool));
  QVERIFY(dock.learningText().contains("suspended: the tracker is not sure enough"));
  QVERIFY(dock.modelText().contains("12 views of the tool, 40 of the background"));
  dock.setDisplay(nullptr);
  QVERIFY(dock.learningText().isEmpty() && dock.modelText().isEmpty());
}

void TestTrackingDock::theStripShowsTheNewestAndIsBounded() {
  auto known = std::make_shared<ToolModel>(*model(500, 2));
  known->positives.back() = cv::Mat(10, 20, CV_8UC1, cv::Scalar(255));
  const QImage strip = patchStrip(*known);
  QVERIFY(strip.width() <= patchesInRow * (patchSide + 2));
  QVERIFY(strip.height() <= 2 * (patchSide + 2));
  QCOMPARE(qGray(strip.pixel(5, 5)), 255);
  QCOMPARE(qGray(strip.pixel(patchSide + 7, 5)), 200);
  QCOMPARE(qGray(strip.pixel(5, patchSide + 7)), 90);
  QVERIFY(patchStrip(ToolModel{}).isNull());
}

void TestTrackingDock::oddPatchesAreHarmless() {
  auto odd = std::make_shared<ToolModel>();
  odd->positives = {cv::Mat(), cv::Mat(1, 400, CV_8UC1, cv::Scalar(9)),
                    cv::Mat(3, 3, CV_8UC3, cv::Scalar(9, 9, 9))};
  QVERIFY(!patchStrip(*odd).isNull());
}

void TestTrackingDock::nothingMovesWhenTheWordsChange() {
  TrackingDock dock;
  dock.resize(300, 400);
  dock.show();
  const QSize before = dock.widget()->sizeHint();
  ToolTrack tool = tracked();
  tool.point.reset();
  tool.age = 1.2;
  tool.model = model(100, 100);
  dock.setDisplay(display(tool));
  QCOMPARE(dock.widget()->sizeHint(), before);
  for (const bool hasGivenUp : {false, true}) {
    tool.hasGivenUp = hasGivenUp;
    dock.setDisplay(display(tool));
    for (const QLabel* label : dock.findChildren<QLabel*>()) {
      if (label->text() != dock.stateText()) continue;
      QVERIFY2(label->heightForWidth(label->width()) <= label->height(), qPrintable(label->text()));
    }
  }
}

void TestTrackingDock::theKeyboardReachesEverything() {
  const TrackingDock dock;
  for (QWidget* control : dock.widget()->findChildren<QWidget*>()) {
    if (!qobject_cast<QPushButton*>(control) && !qobject_cast<QComboBox*>(control) &&
        !qobject_cast<QCheckBox*>(control)) {
      continue;
    }
    QVERIFY(control->focusPolicy() & Qt::TabFocus);
    QVERIFY(!control->toolTip().isEmpty());
  }
}

BOOMWATCH_TEST(TestTrackingDock)
#include "test_tracking_dock.moc"
