#include <QtTest>

#include "lab/evaluation/contestant.h"
#include "lab/evaluation/tracker_run.h"
#include "lab/evaluation/tracking_sequence.h"
#include "support/real_data.h"
#include "support/test_registry.h"

using namespace boomwatch;

/// The published sequences are read as they are, and short stretches of them followed.
class TestTrackingSequences : public QObject {
  Q_OBJECT
 private slots:
  void allAreRead_data();
  void allAreRead();
  void follows_data();
  void follows();
};

void TestTrackingSequences::allAreRead_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<int>("frames");
  QTest::addColumn<int>("hidden");
  const auto row = [](const char* name, int frames, int hidden) {
    QTest::newRow(name) << QString::fromLatin1(name) << frames << hidden;
  };
  // As SOURCE.txt beside them says.
  row("otb_lemming", 668, 0);
  row("otb_motorrolling", 164, 0);
  row("opencv_faceocc2", 812, 0);
  row("tld_david", 761, 0);
  row("tld_jumping", 313, 0);
  row("tld_panda", 3000, 270);
  row("tld_pedestrian3", 184, 28);
}

void TestTrackingSequences::allAreRead() {
  QFETCH(QString, name);
  QFETCH(int, frames);
  QFETCH(int, hidden);
  const QString folder = sharedData("tracking/" + name);
  REQUIRE_DATA(folder);
  const TrackingSequence sequence = openTrackingSequence(folder.toStdString());
  QCOMPARE(sequence.truth.size(), static_cast<std::size_t>(frames));
  const auto absent = std::count(sequence.truth.begin(), sequence.truth.end(), std::nullopt);
  QCOMPARE(absent, hidden);
  const cv::Rect2d picture({}, cv::Size2d(*sequence.images->size()));
  for (const auto& box : sequence.truth) QVERIFY(!box || !(*box & picture).empty());
}

void TestTrackingSequences::follows_data() {
  QTest::addColumn<QString>("tracker");
  QTest::addColumn<QString>("name");
  QTest::addColumn<int>("first");
  QTest::addColumn<int>("frames");
  const auto row = [](const char* tracker, const char* name, int first, int frames) {
    QTest::addRow("%s, %s from %d", tracker, name, first)
        << QString::fromLatin1(tracker) << QString::fromLatin1(name) << first << frames;
  };
  // A head that tilts in the picture's plane; the load-like one, which hangs from a string.
  row("cmt", "opencv_faceocc2", 330, 80);
  row("cmt", "otb_lemming", 0, 60);
  row("klt", "opencv_faceocc2", 330, 80);
  row("klt", "otb_lemming", 0, 60);
  row("csrt", "otb_lemming", 0, 40);
}

void TestTrackingSequences::follows() {
  QFETCH(QString, tracker);
  QFETCH(QString, name);
  QFETCH(int, first);
  QFETCH(int, frames);
  const QString folder = sharedData("tracking/" + name);
  REQUIRE_DATA(folder);
  TrackingSequence sequence = openTrackingSequence(folder.toStdString());
  // It begins where the target is seen first.
  std::fill_n(sequence.truth.begin(), first, std::nullopt);
  const auto chosen = contestantsNamed(std::vector<std::string>{tracker.toStdString()});
  const auto runs = evaluateSequence(sequence, chosen, static_cast<std::size_t>(frames),
                                     [](std::size_t, std::size_t) { return true; });
  QVERIFY(runs[0].state == RunState::Complete);
  const TrackScore& score = runs[0].score;
  qInfo("AUC %.3f, precision %.3f, lost %zu of %zu, %.0f fps", *score.successArea, *score.precision,
        score.lost, score.frames, *score.fps);
  QVERIFY(*score.successArea > 0.6);
  QVERIFY(*score.accuracy > 0.95);
}

BOOMWATCH_TEST(TestTrackingSequences)
#include "test_tracking_sequences.moc"
