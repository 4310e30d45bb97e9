#include <QtTest>
#include <vector>

#include "lab/evaluation/absences.h"
#include "lab/evaluation/track_score.h"
#include "lab/evaluation/tracking_sequence.h"
#include "support/real_data.h"
#include "support/test_registry.h"
#include "tracking/tld_tracker.h"
#include "tracking/tool_model_file.h"

using namespace boomwatch;

/// TLD on stretches of sequences with ground truth (data/tracking). Bars are its own figures less a
/// margin; OpenCV's TLD reaches 0.42 on jumping and 0.48 on pedestrian3.
class TestTldSequences : public QObject {
  Q_OBJECT
 private slots:
  void followsAndFindsAgain_data();
  void followsAndFindsAgain();
  void findsAgainByTheLastLook();
  void aModelFileCarriesWhatWasLearnt();
};

namespace {

struct Stretch {
  std::vector<cv::Mat> images;
  GroundTruth truth;
};

Stretch stretchOf(TrackingSequence sequence, std::size_t first, std::size_t count) {
  Stretch stretch;
  for (std::size_t i = 0; i < first + count && i < sequence.truth.size(); ++i) {
    const cv::Mat image = sequence.images->read(i).image;
    if (i < first) continue;
    stretch.images.push_back(image.clone());
    stretch.truth.push_back(sequence.truth[i]);
  }
  return stretch;
}

Stretch stretchOf(const QString& folder, std::size_t first, std::size_t count) {
  return stretchOf(openTrackingSequence(folder.toStdString()), first, count);
}

/// What `tracker` says of the stretch from image `first` on.
TrackScore scoreOn(const Stretch& stretch, std::size_t first, Tracker& tracker) {
  std::vector<TrackedFrame> frames;
  for (std::size_t i = first; i < stretch.images.size(); ++i) {
    frames.push_back({tracker.track(stretch.images[i]), 0.0});
  }
  return scoreOf(frames, std::span(stretch.truth).subspan(first));
}

}  // namespace

void TestTldSequences::followsAndFindsAgain_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<int>("count");
  QTest::addColumn<double>("least");
  QTest::addColumn<int>("maxFalse");
  QTest::newRow("blur and jumps") << "tld_jumping" << 100 << 0.5 << 0;
  QTest::newRow("leaves and comes back") << "tld_pedestrian3" << 184 << 0.7 << 5;
  QTest::newRow("out of the dark") << "tld_david" << 150 << 0.6 << 0;
}

void TestTldSequences::followsAndFindsAgain() {
  QFETCH(QString, name);
  QFETCH(int, count);
  QFETCH(double, least);
  QFETCH(int, maxFalse);
  const QString folder = sharedData("tracking/" + name);
  REQUIRE_DATA(folder);
  const Stretch stretch = stretchOf(folder, 0, static_cast<std::size_t>(count));
  TldTracker tracker;
  tracker.start(stretch.images.front(), stretch.truth.front().value());
  const TrackScore score = scoreOn(stretch, 1, tracker);
  QVERIFY2(score.successArea > least, qPrintable(QString::number(*score.successArea)));
  QVERIFY2(score.falseBoxes <= static_cast<std::size_t>(maxFalse),
           qPrintable(QString::number(score.falseBoxes)));
  QCOMPARE(score.refound, score.returns);
  QVERIFY(tracker.model()->positives.size() <= ToolModel::maxPositives);
  QVERIFY(tracker.model()->negatives.size() <= ToolModel::maxNegatives);
}

/// A face in other light than at the beginning: the learnt patches alone do not find it.
void TestTldSequences::findsAgainByTheLastLook() {
  const QString folder = sharedData("tracking/tld_david");
  REQUIRE_DATA(folder);
  TrackingSequence sequence = openTrackingSequence(folder.toStdString());
  addAbsences(sequence, 4);
  const Stretch stretch = stretchOf(std::move(sequence), 0, 210);
  TldTracker tracker;
  tracker.start(stretch.images.front(), stretch.truth.front().value());
  const TrackScore score = scoreOn(stretch, 1, tracker);
  QCOMPARE(score.returns, std::size_t{1});
  QCOMPARE(score.refound, std::size_t{1});
}

void TestTldSequences::aModelFileCarriesWhatWasLearnt() {
  const QString folder = sharedData("tracking/tld_david");
  REQUIRE_DATA(folder);
  QTemporaryDir temporary;
  const std::string file = temporary.filePath("david.model").toStdString();
  const Stretch early = stretchOf(folder, 0, 250);
  const Stretch late = stretchOf(folder, 260, 60);

  TldTracker teacher;
  teacher.start(early.images.front(), early.truth.front().value());
  const ToolModel untrained = *teacher.model();
  scoreOn(early, 1, teacher);
  saveToolModel(*teacher.model(), file);

  const auto areaFrom = [&](const ToolModel& model) {
    TldTracker tracker;
    tracker.setLearning(false);
    tracker.start(model);
    const double area = *scoreOn(late, 0, tracker).successArea;
    return *tracker.model() == model ? area : -1.0;
  };
  const double trained = areaFrom(loadToolModel(file));
  const double fromOneBox = areaFrom(untrained);
  const QString figures = QString("%1 against %2").arg(trained).arg(fromOneBox);
  QVERIFY2(fromOneBox >= 0.0, "learning is off, and the model changed");
  QVERIFY2(trained > 0.4, qPrintable(figures));
  QVERIFY2(trained > fromOneBox + 0.1, qPrintable(figures));
}

BOOMWATCH_TEST(TestTldSequences)
#include "test_tld_sequences.moc"
