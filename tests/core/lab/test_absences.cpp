#include <QtTest>
#include <opencv2/imgproc.hpp>

#include "lab/evaluation/absences.h"
#include "lab/evaluation/contestant.h"
#include "lab/evaluation/track_score.h"
#include "lab/evaluation/tracker_run.h"
#include "support/test_registry.h"
#include "support/tracked_target.h"

using namespace boomwatch;
using namespace boomwatch::test;

namespace {

constexpr std::size_t length = 200;

/// The target goes to and fro.
cv::Point2d centreAt(std::size_t frame) {
  const auto step = static_cast<double>(frame % 100 < 50 ? frame % 50 : 50 - frame % 50);
  return {100.0 + 2.0 * step, 100.0 + step};
}

class Pictures : public ImageStream {
 public:
  std::size_t count() const override { return length; }
  std::optional<double> rate() const override { return std::nullopt; }
  std::optional<cv::Size> size() const override { return m_scene.wall().size(); }
  StreamImage read(std::size_t index) override { return {m_scene.image(centreAt(index)), {}, {}}; }

 private:
  TargetScene m_scene;
};

TrackingSequence sequence() {
  TrackingSequence made{"to and fro", std::make_unique<Pictures>(), {}};
  for (std::size_t k = 0; k < length; ++k) made.truth.emplace_back(TargetScene::box(centreAt(k)));
  return made;
}

bool isHidden(const std::optional<cv::Rect2d>& box) { return !box; }

std::size_t hiddenIn(const TrackingSequence& sequence) {
  return static_cast<std::size_t>(std::ranges::count_if(sequence.truth, isHidden));
}

}  // namespace

/// A target that is taken out of a recording, so that it can be seen who finds it again.
class TestAbsences : public QObject {
  Q_OBJECT
 private slots:
  void theTargetIsGoneFromPictureAndTruth();
  void whereTheRecordingHidesItselfNothingIsAdded();
  void noAbsenceWithoutRoomForTheReturn();
  void moreThanThereIsRoomForAreAsManyAsThereIs();
  void aTargetThatFillsThePictureGoesToo();
  void whoFindsItAgainIsCounted();
};

void TestAbsences::theTargetIsGoneFromPictureAndTruth() {
  const TrackingSequence before = sequence();
  TrackingSequence after = sequence();
  addAbsences(after, 2);
  QCOMPARE(hiddenIn(after), 2 * absenceLength);
  QCOMPARE(after.name, std::string("to and fro+absences"));
  const TargetScene scene;
  for (std::size_t k = 0; k < length; ++k) {
    const cv::Mat had = before.images->read(k).image, has = after.images->read(k).image;
    const cv::Rect box = cv::Rect(*before.truth[k]);
    if (after.truth[k]) {
      QCOMPARE(cv::norm(had, has, cv::NORM_INF), 0.0);
      continue;
    }
    cv::Mat likeness;
    cv::matchTemplate(has(box), had(box), likeness, cv::TM_CCOEFF_NORMED);
    QVERIFY2(likeness.at<float>(0) < 0.4F, qPrintable(QString::number(likeness.at<float>(0))));
  }
}

void TestAbsences::whereTheRecordingHidesItselfNothingIsAdded() {
  TrackingSequence hidden = sequence();
  hidden.truth[100 + absenceLength + 3].reset();  // in one absence's return
  addAbsences(hidden, 1);
  QCOMPARE(hiddenIn(hidden), std::size_t{1});
}

void TestAbsences::noAbsenceWithoutRoomForTheReturn() {
  TrackingSequence whole = sequence();
  addAbsences(whole, 1, 2 * (absenceLength + refoundWithin));
  QCOMPARE(hiddenIn(whole), absenceLength);
  TrackingSequence tooShort = sequence();
  addAbsences(tooShort, 1, 2 * (absenceLength + refoundWithin) - 2);
  QCOMPARE(hiddenIn(tooShort), std::size_t{0});
  TrackingSequence never = sequence();
  never.truth.assign(length, std::nullopt);
  addAbsences(never, std::numeric_limits<std::size_t>::max());
  QCOMPARE(
      cv::norm(never.images->read(length / 2).image, sequence().images->read(length / 2).image),
      0.0);
}

void TestAbsences::moreThanThereIsRoomForAreAsManyAsThereIs() {
  const TrackingSequence before = sequence();
  TrackingSequence after = sequence();
  addAbsences(after, std::numeric_limits<std::size_t>::max());
  QCOMPARE(hiddenIn(after) % absenceLength, std::size_t{0});
  QVERIFY(hiddenIn(after) > 0);
  for (std::size_t k = 0; k < length; ++k) {
    const double change = cv::norm(before.images->read(k).image, after.images->read(k).image);
    QCOMPARE(change > 0.0, !after.truth[k]);
  }
}

void TestAbsences::aTargetThatFillsThePictureGoesToo() {
  TrackingSequence filled = sequence();
  const auto size = *filled.images->size();
  for (auto& box : filled.truth) box = cv::Rect2d({}, cv::Size2d(size));
  addAbsences(filled, 1);
  const auto gone = std::ranges::find_if(filled.truth, isHidden) - filled.truth.begin();
  cv::Mat grey;
  cv::cvtColor(filled.images->read(static_cast<std::size_t>(gone)).image, grey, cv::COLOR_BGR2GRAY);
  double least = 0, most = 0;
  cv::minMaxLoc(grey, &least, &most);
  QCOMPARE(least, most);
}

void TestAbsences::whoFindsItAgainIsCounted() {
  TrackingSequence away = sequence();
  addAbsences(away, 2);
  const auto trackers = contestantsNamed(std::vector<std::string>{"tld", "klt"});
  const auto runs =
      evaluateSequence(away, trackers, std::nullopt, [](std::size_t, std::size_t) { return true; });
  for (const TrackerRun& run : runs) QCOMPARE(run.score.returns, std::size_t{2});
  QCOMPARE(runs[0].score.refound, std::size_t{2});
  QCOMPARE(runs[0].score.falseBoxes, std::size_t{0});
  QCOMPARE(runs[1].score.refound, std::size_t{0});
}

BOOMWATCH_TEST(TestAbsences)
#include "test_absences.moc"
