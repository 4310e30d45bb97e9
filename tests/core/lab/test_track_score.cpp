#include <QtTest>
#include <vector>

#include "lab/evaluation/evaluation_table.h"
#include "lab/evaluation/track_score.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

using Truth = std::vector<std::optional<cv::Rect2d>>;

const cv::Rect2d here(10, 10, 20, 20);

TrackedFrame seen(const cv::Rect2d& box, double confidence = 1.0, double seconds = 0.1) {
  return {{TrackState::Tracked, box, confidence, LearningState::None}, seconds};
}
TrackedFrame lost() { return {Track::lost(), 0.1}; }

}  // namespace

/// Against values worked out by hand.
class TestTrackScore : public QObject {
  Q_OBJECT
 private slots:
  void overlap_data();
  void overlap();
  void successAreaOfKnownOverlaps();
  void table5();
  void precisionEndsAtTwentyPixels();
  void hiddenFramesCountForNothingButFalseBoxes();
  void foundAgainWithinFifteenFrames_data();
  void foundAgainWithinFifteenFrames();
  void whatWasLostBeforeIsNotFoundAgain_data();
  void whatWasLostBeforeIsNotFoundAgain();
  void aTargetThatGoesAtOnceWasFollowed();
  void whatNoFrameToldIsAbsent();
  void meansCountEverySequenceTheSame();
  void csvHasOneFieldAColumn();
};

void TestTrackScore::overlap_data() {
  QTest::addColumn<QRectF>("box");
  QTest::addColumn<double>("expected");
  QTest::newRow("the same") << QRectF(10, 10, 20, 20) << 1.0;
  QTest::newRow("half beside") << QRectF(20, 10, 20, 20) << 200.0 / 600.0;
  QTest::newRow("a quarter of it") << QRectF(10, 10, 10, 10) << 0.25;
  QTest::newRow("touching") << QRectF(30, 10, 20, 20) << 0.0;
  QTest::newRow("apart") << QRectF(100, 100, 20, 20) << 0.0;
  QTest::newRow("empty") << QRectF(15, 15, 0, 0) << 0.0;
}

void TestTrackScore::overlap() {
  QFETCH(QRectF, box);
  QFETCH(double, expected);
  const cv::Rect2d other(box.x(), box.y(), box.width(), box.height());
  QCOMPARE(overlapOf(here, other), expected);
  QCOMPARE(overlapOf(other, here), expected);
}

/// An overlap o is above 21 thresholds 0, 0.05, ... 1 as often as there are below it.
void TestTrackScore::successAreaOfKnownOverlaps() {
  const Truth truth(3, here);
  // Overlaps 1 (above 20 of 21), 1/3 (above 0 ... 0.3: 7) and none (0).
  const std::vector<TrackedFrame> frames{seen(here), seen({20, 10, 20, 20}), lost()};
  QCOMPARE(*scoreOf(frames, truth).successArea, (20.0 + 7.0 + 0.0) / 21.0 / 3.0);
}

/// 10 frames, 2 of them hidden; lost in both of these and in one more.
void TestTrackScore::table5() {
  Truth truth(10, here);
  truth[4] = truth[5] = std::nullopt;
  std::vector<TrackedFrame> frames(10, seen(here, 0.5, 0.1));
  frames[0] = seen(here, 0.9, 0.05);
  frames[4] = frames[5] = frames[6] = lost();
  const TrackScore score = scoreOf(frames, truth);
  QCOMPARE(score.frames, std::size_t{10});
  QCOMPARE(score.lost, std::size_t{3});
  QCOMPARE(*score.lostShare, 0.3);
  QCOMPARE(score.occluded, std::size_t{2});
  QCOMPARE(*score.accuracy, 7.0 / 8.0);
  // Seven boxes: 0.9 and six times 0.5.
  const double mean = 3.9 / 7.0;
  QCOMPARE(*score.confidenceMean, mean);
  const double variance = ((0.9 - mean) * (0.9 - mean) + 6 * (0.5 - mean) * (0.5 - mean)) / 7.0;
  QCOMPARE(*score.confidenceSpread, std::sqrt(variance));
  // The mean of 1/t, not one by the mean of t.
  QCOMPARE(*score.fps, (20.0 + 6 * 10.0) / 7.0);
  QVERIFY(!scoreOf(frames, truth, false).confidenceMean);
}

void TestTrackScore::precisionEndsAtTwentyPixels() {
  const Truth truth(4, here);
  const std::vector<TrackedFrame> frames{seen({30, 10, 20, 20}), seen({22, 26, 20, 20}),
                                         seen({31, 10, 20, 20}), lost()};
  // Off by 20, by 12 and 16 (which is 20), by 21, and nothing.
  QCOMPARE(*scoreOf(frames, truth).precision, 0.5);
}

void TestTrackScore::hiddenFramesCountForNothingButFalseBoxes() {
  const Truth truth{here, std::nullopt, std::nullopt, here};
  const std::vector<TrackedFrame> frames{seen(here), seen(here), lost(), seen(here)};
  const TrackScore score = scoreOf(frames, truth);
  QCOMPARE(score.falseBoxes, std::size_t{1});
  QCOMPARE(*score.accuracy, 1.0);
  QCOMPARE(*score.precision, 1.0);
  QCOMPARE(*score.successArea, 20.0 / 21.0);
}

void TestTrackScore::foundAgainWithinFifteenFrames_data() {
  QTest::addColumn<int>("foundAfter");  // frames, from 0: the one in which it is back
  QTest::addColumn<QRectF>("box");
  QTest::addColumn<int>("found");
  const QRectF right(10, 10, 20, 20), wrong(25, 25, 20, 20);
  QTest::newRow("at once") << 0 << right << 1;
  QTest::newRow("in the fifteenth") << 14 << right << 1;
  QTest::newRow("in the sixteenth") << 15 << right << 0;
  QTest::newRow("never") << 1000 << right << 0;
  QTest::newRow("something else") << 0 << wrong << 0;
}

void TestTrackScore::foundAgainWithinFifteenFrames() {
  QFETCH(int, foundAfter);
  QFETCH(QRectF, box);
  QFETCH(int, found);
  Truth truth(50, here);
  for (int i = 10; i < 20; ++i) truth[std::size_t(i)] = std::nullopt;
  std::vector<TrackedFrame> frames(50, lost());
  for (int i = 20 + foundAfter; i < 50; ++i) {
    frames[std::size_t(i)] = seen({box.x(), box.y(), box.width(), box.height()});
  }
  const TrackScore score = scoreOf(frames, truth);
  QCOMPARE(score.returns, std::size_t{1});
  QCOMPARE(score.refound, std::size_t(found));
  // It was lost all the time before.
  QCOMPARE(score.followed, std::size_t{0});
  QCOMPARE(score.followedRefound, std::size_t{0});
}

void TestTrackScore::whatWasLostBeforeIsNotFoundAgain_data() {
  QTest::addColumn<bool>("on");  // the target, in the last frame before it goes
  QTest::addColumn<bool>("found");
  QTest::newRow("followed and found") << true << true;
  QTest::newRow("followed and not found") << true << false;
  QTest::newRow("lost and found") << false << true;
  QTest::newRow("lost for good") << false << false;
}

void TestTrackScore::whatWasLostBeforeIsNotFoundAgain() {
  QFETCH(bool, on);
  QFETCH(bool, found);
  const cv::Rect2d beside(here.x + here.width, here.y, here.width, here.height);
  const Truth truth{here, here, std::nullopt, std::nullopt, here};
  const std::vector<TrackedFrame> frames{seen(on ? beside : here), seen(on ? here : beside), lost(),
                                         lost(), seen(found ? here : beside)};
  const TrackScore score = scoreOf(frames, truth);
  QCOMPARE(score.returns, std::size_t{1});
  QCOMPARE(score.refound, std::size_t(found));
  QCOMPARE(score.followed, std::size_t(on));
  QCOMPARE(score.followedRefound, std::size_t(on && found));
  const TrackScore both = meanOf(std::vector<TrackScore>{score, score});
  QCOMPARE(both.followed, 2 * score.followed);
  QCOMPARE(both.followedRefound, 2 * score.followedRefound);
}

void TestTrackScore::aTargetThatGoesAtOnceWasFollowed() {
  const Truth truth{std::nullopt, here};
  const TrackScore score = scoreOf(std::vector<TrackedFrame>{lost(), seen(here)}, truth);
  QCOMPARE(score.followed, std::size_t{1});
  QCOMPARE(score.followedRefound, std::size_t{1});
}

void TestTrackScore::whatNoFrameToldIsAbsent() {
  const TrackScore nothing = scoreOf({}, {});
  QVERIFY(!nothing.lostShare && !nothing.accuracy && !nothing.successArea && !nothing.fps);
  const std::vector<TrackedFrame> frames{lost()};
  const TrackScore hidden = scoreOf(frames, Truth{std::nullopt});
  QCOMPARE(*hidden.lostShare, 1.0);
  QVERIFY(!hidden.accuracy && !hidden.precision && !hidden.confidenceMean);
}

void TestTrackScore::meansCountEverySequenceTheSame() {
  const std::vector<TrackedFrame> good(2, seen(here)), bad(8, lost());
  const std::vector<TrackScore> scores{scoreOf(good, Truth(2, here)), scoreOf(bad, Truth(8, here)),
                                       TrackScore()};
  const TrackScore mean = meanOf(scores);
  QCOMPARE(mean.frames, std::size_t{10});
  QCOMPARE(mean.lost, std::size_t{8});
  QCOMPARE(*mean.lostShare, 0.5);
  QCOMPARE(*mean.confidenceMean, 1.0);
}

void TestTrackScore::csvHasOneFieldAColumn() {
  TrackerRun complete{"a, \"b\"", "klt", RunState::Complete, "", {}};
  complete.score = scoreOf(std::vector<TrackedFrame>(2, seen(here)), Truth(2, here));
  const TrackerRun failed{"c", "klt", RunState::Failed, "broken", {}};
  const std::vector<TrackerRun> runs{complete, failed};
  const QStringList lines =
      QString::fromStdString(csvTable(runs)).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  QCOMPARE(lines.size(), 4);
  QVERIFY2(lines[1].startsWith("\"a, \"\"b\"\"\",klt,complete,2,0,0.0,0,100.0,1.000,0.000,10.0,"),
           qPrintable(lines[1]));
  QCOMPARE(lines[2].count(QLatin1Char(',')), lines[0].count(QLatin1Char(',')));
  QVERIFY(lines[2].startsWith("c,klt,failed,,"));
  // A mean over less than was asked for does not pass for one over all.
  QVERIFY2(lines[3].startsWith("mean,klt,1 of 2,2,"), qPrintable(lines[3]));
  QVERIFY(markdownTable(runs).find("c, klt: broken") != std::string::npos);
}

BOOMWATCH_TEST(TestTrackScore)
#include "test_track_score.moc"
