#include <QtTest>

#include "lab/evaluation/contestant.h"
#include "lab/evaluation/tracker_run.h"
#include "lab/evaluation/tracking_sequence.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"
#include "support/tracking_folder.h"

using namespace boomwatch;
using namespace boomwatch::test;

Q_DECLARE_METATYPE(cv::Rect2d)

/// Sequences as the data sets lay them out, and as they are when they are broken.
class TestTrackingSequence : public QObject {
  Q_OBJECT
 private slots:
  void readsTheLayouts_data();
  void readsTheLayouts();
  void readsVideos();
  void hiddenTargets();
  void faultsAreNamed_data();
  void faultsAreNamed();
  void countsMustAgree();
  void findsSequencesInAFolder();
  void evaluatesFromTheFirstSightOn();
  void aStoppedRunHasNoScore();
  void anUnreadablePictureIsNamed();
  void namesChooseContestants();
};

void TestTrackingSequence::readsTheLayouts_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<bool>("init");
  QTest::addColumn<QByteArray>("lines");
  QTest::addColumn<cv::Rect2d>("first");
  const auto row = [](const char* name, const char* file, bool init, const char* lines,
                      const cv::Rect2d& first) {
    QTest::newRow(name) << QString::fromLatin1(file) << init << QByteArray(lines) << first;
  };
  // Pixel 1 of the file is pixel 0 of ours; the last column of corners belongs to the box.
  row("OTB, commas", "groundtruth_rect.txt", false, "1,2,30,40\n5,6,30,40\n", {0, 1, 30, 40});
  row("OTB, tabs", "groundtruth_rect.txt", false, "1\t2\t30\t40\r\n5\t6\t30\t40\r\n\r\n",
      {0, 1, 30, 40});
  row("OTB, blanks", "groundtruth_rect.txt", false, " 1 2  30 40\n5 6 30 40", {0, 1, 30, 40});
  row("TLD", "gt.txt", true, "1,2,30.5,41\n2,3,31,42\n", {0, 1, 30.5, 40});
  row("gt.txt, can only be corners", "gt.txt", false, "200,100,250,180\n201,101,251,181\n",
      {199, 99, 51, 81});
  row("gt.txt, can only be sizes", "gt.txt", false, "118,57,82,98\n118,57,82,98\n",
      {117, 56, 82, 98});
}

void TestTrackingSequence::readsTheLayouts() {
  QFETCH(QString, file);
  QFETCH(bool, init);
  QFETCH(QByteArray, lines);
  QFETCH(cv::Rect2d, first);
  const TemporaryFolder folder;
  writePictures(QString::fromStdString(folder.path().string()), 2);
  folder.write(file, lines);
  if (init) folder.write("init.txt", "1,2,30,41");
  const TrackingSequence sequence = openTrackingSequence(folder.path());
  QCOMPARE(sequence.truth.size(), std::size_t{2});
  QCOMPARE(sequence.truth[0]->x, first.x);
  QCOMPARE(sequence.truth[0]->y, first.y);
  QCOMPARE(sequence.truth[0]->width, first.width);
  QCOMPARE(sequence.truth[0]->height, first.height);
  QCOMPARE(sequence.name, folder.path().filename().string());
}

void TestTrackingSequence::readsVideos() {
  const TemporaryFolder folder;
  writeVideo(QString::fromStdString(folder.path("video.avi").string()), 6);
  folder.write("groundtruth_rect.txt", sizeLines(6));
  const TrackingSequence sequence = openTrackingSequence(folder.path());
  QCOMPARE(sequence.truth.size(), std::size_t{6});
  QVERIFY(!sequence.images->read(0).image.empty());
  QVERIFY(!sequence.images->read(5).image.empty());
  for (const auto& [lines, count] : {std::pair(5, "more"), std::pair(7, "fewer")}) {
    folder.write("groundtruth_rect.txt", sizeLines(lines));
    QVERIFY(errorOf([&] { openTrackingSequence(folder.path()); }).contains(count));
  }
}

void TestTrackingSequence::hiddenTargets() {
  const TemporaryFolder folder;
  writePictures(QString::fromStdString(folder.path().string()), 3);
  folder.write("gt.txt", "NaN,NaN,NaN,NaN\n10,20,50,80\nnan nan nan nan\n");
  folder.write("init.txt", "10,20,50,80");
  const TrackingSequence sequence = openTrackingSequence(folder.path());
  QVERIFY(!sequence.truth[0] && sequence.truth[1] && !sequence.truth[2]);
  folder.write("groundtruth_rect.txt", "10,20,30,40\n0,0,0,0\n10,20,30,40\n");
  QVERIFY(!openTrackingSequence(folder.path()).truth[1]);
}

void TestTrackingSequence::faultsAreNamed_data() {
  QTest::addColumn<QByteArray>("lines");
  QTest::addColumn<QString>("named");
  const auto row = [](const char* name, const char* lines, const char* named) {
    QTest::newRow(name) << QByteArray(lines) << QString::fromLatin1(named);
  };
  row("a word", "10,20,30,40\n10,20,big,40\n", "line 2");
  row("three numbers", "10,20,30\n10,20,30,40\n", "line 1");
  row("five numbers", "10,20,30,40\n10,20,30,40,50\n", "line 2");
  row("half hidden", "10,20,30,40\nNaN,20,30,40\n", "line 2");
  row("without end", "10,20,30,40\n10,20,inf,40\n", "line 2");
  row("huge", "10,20,30,40\n10,20,1e300,40\n", "line 2");
  row("negative size", "10,20,30,40\n10,20,-30,40\n", "line 2");
  row("a gap", "10,20,30,40\n\n", "2 pictures and 1 lines");
  row("empty", "", "empty");
  row("binary", "\x01\x02\xff\xfe\n", "line 1");
  row("never seen", "NaN,NaN,NaN,NaN\nNaN,NaN,NaN,NaN\n", "no picture");
}

void TestTrackingSequence::faultsAreNamed() {
  QFETCH(QByteArray, lines);
  QFETCH(QString, named);
  const TemporaryFolder folder;
  writePictures(QString::fromStdString(folder.path().string()), 2);
  folder.write("groundtruth_rect.txt", lines);
  const QString error = errorOf([&] { openTrackingSequence(folder.path()); });
  QVERIFY2(error.contains(named), qPrintable(error));
  QVERIFY2(error.contains(QString::fromStdString(folder.path().string())), qPrintable(error));
}

void TestTrackingSequence::countsMustAgree() {
  const TemporaryFolder folder;
  const QString path = QString::fromStdString(folder.path().string());
  const auto error = [&] { return errorOf([&] { openTrackingSequence(folder.path()); }); };
  QVERIFY2(error().contains("neither pictures in img/ nor a video"), qPrintable(error()));
  writePictures(path, 2);
  QVERIFY2(error().contains("no ground truth"), qPrintable(error()));
  folder.write("groundtruth_rect.txt", "10,20,30,40\n");
  QVERIFY2(error().contains("2 pictures and 1 lines"), qPrintable(error()));
  // Both readings fit, and nothing else tells.
  QFile::remove(path + "/groundtruth_rect.txt");
  folder.write("gt.txt", "10,20,30,40\n10,20,30,40\n");
  QVERIFY2(error().contains("cannot be told"), qPrintable(error()));
}

void TestTrackingSequence::findsSequencesInAFolder() {
  const TemporaryFolder folder;
  folder.write("s10/gt.txt", "");
  folder.write("s9/groundtruth_rect.txt", "");
  folder.write("s1/img/0001.png", "");
  folder.write("notes/readme.txt", "");
  folder.write("LICENCE", "");
  const auto found = trackingSequencesIn(folder.path());
  QCOMPARE(found.size(), std::size_t{3});
  QCOMPARE(found[0].filename().string(), std::string("s1"));
  QCOMPARE(found[1].filename().string(), std::string("s9"));
  QCOMPARE(found[2].filename().string(), std::string("s10"));
  QCOMPARE(trackingSequencesIn(folder.path("s9/")).front(), found[1]);
  QVERIFY(errorOf([&] { trackingSequencesIn(folder.path("notes")); }).contains("notes"));
  QVERIFY(errorOf([&] { trackingSequencesIn(folder.path("absent")); }).contains("absent"));
}

void TestTrackingSequence::evaluatesFromTheFirstSightOn() {
  const TemporaryFolder folder;
  writePictures(QString::fromStdString(folder.path().string()), 8);
  folder.write("groundtruth_rect.txt", "0,0,0,0\n" + sizeLines(8).mid(sizeLines(1).size()));
  TrackingSequence sequence = openTrackingSequence(folder.path());
  const auto trackers = contestantsNamed(std::vector<std::string>{"klt", "opencv_medianflow"});
  const auto go = [](std::size_t, std::size_t) { return true; };
  const auto runs = evaluateSequence(sequence, trackers, std::nullopt, go);
  QCOMPARE(runs.size(), std::size_t{2});
  for (const TrackerRun& run : runs) {
    QVERIFY(run.state == RunState::Complete);
    QCOMPARE(run.score.frames, std::size_t{6});
    QVERIFY(*run.score.successArea > 0.8);
    QCOMPARE(*run.score.precision, 1.0);
  }
  QVERIFY(runs[0].score.confidenceMean && !runs[1].score.confidenceMean);
  QCOMPARE(evaluateSequence(sequence, trackers, 3, go)[0].score.frames, std::size_t{2});
}

void TestTrackingSequence::aStoppedRunHasNoScore() {
  const TemporaryFolder folder;
  writePictures(QString::fromStdString(folder.path().string()), 8);
  folder.write("groundtruth_rect.txt", sizeLines(8));
  TrackingSequence sequence = openTrackingSequence(folder.path());
  const auto trackers = contestantsNamed(std::vector<std::string>{"klt"});
  const auto runs = evaluateSequence(sequence, trackers, std::nullopt,
                                     [](std::size_t frame, std::size_t) { return frame < 5; });
  QVERIFY(runs[0].state == RunState::Interrupted);
  QCOMPARE(runs[0].score.frames, std::size_t{0});
}

void TestTrackingSequence::anUnreadablePictureIsNamed() {
  const TemporaryFolder folder;
  writePictures(QString::fromStdString(folder.path().string()), 4);
  folder.write("groundtruth_rect.txt", sizeLines(4));
  folder.write("img/0003.png", "no picture");
  TrackingSequence sequence = openTrackingSequence(folder.path());
  const auto trackers = contestantsNamed(std::vector<std::string>{"klt"});
  try {
    evaluateSequence(sequence, trackers, std::nullopt,
                     [](std::size_t, std::size_t) { return true; });
    QFAIL("it passed over the picture");
  } catch (const std::exception& fault) {
    QVERIFY2(QByteArray(fault.what()).contains("0003.png"), fault.what());
  }
}

void TestTrackingSequence::namesChooseContestants() {
  QCOMPARE(contestantsNamed({}).size(), contestants().size());
  QVERIFY(errorOf([] {
            contestantsNamed(std::vector<std::string>{"goturn"});
          }).contains("opencv_medianflow"));
}

BOOMWATCH_TEST(TestTrackingSequence)
#include "test_tracking_sequence.moc"
