#include <QDir>
#include <QtTest>
#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <set>
#include <stdexcept>

#include "open_source.h"
#include "support/conveyor.h"
#include "support/real_data.h"
#include "support/sequence.h"
#include "support/test_registry.h"
#include "tracking/detection.h"
#include "tracking/tracker.h"

using namespace boomwatch;
using namespace boomwatch::test;

namespace {

/// What the chain says of the target, frame by frame, beside what is known of it from elsewhere.
class TargetWatch {
 public:
  /// `target`: mask of the result's image.
  void look(const Result& result, const cv::Mat& target) {
    ++m_frames;
    if (!result.tool.box || !result.tool.point) return;
    const cv::Rect2d truth(cv::boundingRect(target));
    m_overlaps.push_back(overlap(*result.tool.box, truth));
    const double error = std::abs(depthIn(*result.cloud, target) - result.tool.point->z());
    if (std::isfinite(error)) m_depthErrors.push_back(error);
  }

  double trackedShare() const {
    return static_cast<double>(m_overlaps.size()) / static_cast<double>(m_frames);
  }
  std::size_t measured() const { return m_depthErrors.size(); }
  /// The value below which `share` of the frames lie.
  double overlapAt(double share) const { return quantile(m_overlaps, share); }
  double depthErrorAt(double share) const { return quantile(m_depthErrors, share); }
  void print() const {
    qInfo("%zu frames, %.0f %% tracked, overlap median %.2f, least %.2f, depth error 95 %% %.3f m",
          m_frames, 100 * trackedShare(), overlapAt(0.5), overlapAt(0.0), depthErrorAt(0.95));
  }

 private:
  static double quantile(const std::vector<double>& values, double share) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::multiset<double> sorted(values.begin(), values.end());
    return *std::next(sorted.begin(),
                      static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1)));
  }

  /// Median of what is measured there.
  static double depthIn(const Cloud& cloud, const cv::Mat& mask) {
    std::vector<double> depths;
    for (int row = 0; row < std::min(mask.rows, cloud.height); ++row) {
      for (int column = 0; column < std::min(mask.cols, cloud.width); ++column) {
        const Eigen::Vector3f& point = cloud.at(column, row);
        if (mask.at<uchar>(row, column) && isMeasured(point)) depths.push_back(point.z());
      }
    }
    return quantile(depths, 0.5);
  }

  std::size_t m_frames = 0;
  std::vector<double> m_overlaps, m_depthErrors;
};

/// What has come into the picture since `before`: the largest piece of it.
cv::Mat arrived(const cv::Mat& image, const cv::Mat& before) {
  cv::Mat difference, changed, labels, statistics, centroids;
  cv::absdiff(image, before, difference);
  cv::medianBlur(difference > 40, changed, 9);
  const int pieces = cv::connectedComponentsWithStats(changed, labels, statistics, centroids);
  if (pieces < 2) return cv::Mat::zeros(image.size(), CV_8UC1);
  double area = 0.0;
  cv::Point largest;
  cv::minMaxLoc(statistics.col(cv::CC_STAT_AREA).rowRange(1, pieces), nullptr, &area, nullptr,
                &largest);
  return labels == largest.y + 1;
}

FramePtr frameOf(FrameSource& source) {
  const ReadResult read = source.next(std::chrono::seconds(1));
  if (read.status != ReadResult::Status::Ok) throw std::runtime_error("the recording is too short");
  return read.frame;
}

void trackers() {
  QTest::addColumn<TrackerKind>("kind");
  QTest::newRow("tld") << TrackerKind::Tld;
  QTest::newRow("cmt") << TrackerKind::Cmt;
}

}  // namespace

/// The chain with a tracker and the load detector at work, over recordings of real cameras.
class TestTrackedRecordings : public QObject {
  Q_OBJECT
 private slots:
  void aBoxOnAConveyorBelt_data() { trackers(); }
  void aBoxOnAConveyorBelt();
  void theHeadOfAPersonWhoTurns_data();
  void theHeadOfAPersonWhoTurns();
};

/// A stereo recording: a box comes towards the camera, from the moment it lies until a hand comes.
void TestTrackedRecordings::aBoxOnAConveyorBelt() {
  QFETCH(TrackerKind, kind);
  const QString recording = sharedData("stereo_static_conveyor_dtu");
  REQUIRE_DATA(recording);
  constexpr std::size_t empty = 70, lies = 129, handReturns = 230;
  Parameters parameters = beltParameters();
  parameters.tracking.tracker = kind;
  cv::Mat emptyBelt;
  TargetWatch watch;
  const auto source = openSource("stereo:" + recording.toStdString());
  Pipeline pipeline;
  const auto next = [&] { return pipeline.process(frameOf(*source), parameters); };
  QVERIFY(source->seek(empty));
  emptyBelt = greyOf(next().image);
  QVERIFY(source->seek(lies));
  const Result first = next();
  pipeline.order(TrackBox{cv::Rect2d(cv::boundingRect(arrived(greyOf(first.image), emptyBelt)))});
  for (std::size_t frame = lies + 1; frame < handReturns; ++frame) {
    const Result result = next();
    watch.look(result, arrived(greyOf(result.image), emptyBelt));
  }
  watch.print();
  QVERIFY(watch.trackedShare() >= 0.95);
  QVERIFY(watch.measured() >= 100);
  // The truth has the box's shadow as well.
  QVERIFY(watch.overlapAt(0.5) >= 0.45);
  QVERIFY(watch.overlapAt(0.05) >= 0.25);
  QVERIFY(watch.depthErrorAt(0.95) <= 0.08);
}

void TestTrackedRecordings::theHeadOfAPersonWhoTurns_data() {
  QTest::addColumn<TrackerKind>("kind");
  QTest::addColumn<double>("share");
  QTest::newRow("tld") << TrackerKind::Tld << 0.9;
  // It knows the first view alone.
  QTest::newRow("cmt") << TrackerKind::Cmt << 0.25;
}

/// A recording of depth: what is followed is a head, at arm's length before a wall.
void TestTrackedRecordings::theHeadOfAPersonWhoTurns() {
  QFETCH(TrackerKind, kind);
  QFETCH(double, share);
  constexpr float wall = 2.2F;  // metres: nothing of it is nearer
  const QString recording = sharedData("rgbd_static_person_uva");
  REQUIRE_DATA(recording);
  Parameters parameters;
  parameters.bounds = {-1.5, 1.5, -1.2, 1.2, 0.5, 3.0};
  parameters.tracking.tracker = kind;
  const QStringList masks = QDir(recording).entryList({"*_mask.jpg"}, QDir::Files, QDir::Name);
  const auto source = openSource("depth:" + recording.toStdString());
  Pipeline pipeline;
  pipeline.order(TrackBox{{270, 70, 112, 145}});
  int onPerson = 0, elsewhere = 0, loads = 0;
  for (const QString& name : masks) {
    const Result result = pipeline.process(source->next(std::chrono::seconds(1)).frame, parameters);
    const std::string file = (recording + QLatin1Char('/') + name).toStdString();
    const cv::Mat person = cv::imread(file, cv::IMREAD_GRAYSCALE) > 127;
    const auto& tool = result.tool;
    const bool inside = tool.pixel && cv::Rect({}, person.size()).contains(*tool.pixel) &&
                        person.at<uchar>(*tool.pixel);
    if (tool.point && tool.point->z() >= wall) ++elsewhere;
    if (tool.point && tool.point->z() < wall && inside) ++onPerson;
    if (result.load) ++loads;
  }
  qInfo("on the person in %d of %lld frames, elsewhere in %d; a load in %d", onPerson, masks.size(),
        elsewhere, loads);
  QCOMPARE(elsewhere, 0);
  QVERIFY(onPerson >= share * static_cast<double>(masks.size()));
  // A body that reaches out of the picture is no load.
  QCOMPARE(loads, 0);
}

BOOMWATCH_TEST(TestTrackedRecordings)
#include "test_tracked_recordings_slow.moc"
