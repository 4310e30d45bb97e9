#include <QDir>
#include <QtTest>
#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "support/real_data.h"
#include "support/sequence.h"
#include "support/test_registry.h"

using namespace boomwatch;
using namespace boomwatch::test;

namespace {

// The set's own intrinsics.
constexpr double focalLength = 525.0, centreX = 320.0, centreY = 240.0;
// The person stands at 1 m, the wall at 2.7 m.
constexpr double nearestWall = 2.2;
// By this frame the wall has entered the model; what it is then is what must stay.
constexpr std::size_t settled = 5;

/// The set's masks, one a frame; grown, because a Kinect casts a shadow beside what it sees.
std::vector<cv::Mat> readMasks(const QString& folder) {
  std::vector<cv::Mat> masks;
  const cv::Mat around = cv::Mat::ones(31, 41, CV_8UC1);
  for (const QString& name : QDir(folder).entryList({"*_mask.jpg"}, QDir::Files, QDir::Name)) {
    const QString file = folder + QLatin1Char('/') + name;
    cv::Mat mask = cv::imread(file.toStdString(), cv::IMREAD_GRAYSCALE) > 127;
    cv::dilate(mask, mask, around);
    masks.push_back(mask);
  }
  return masks;
}

/// How much of the wall of frame `settled` is still in the model, frame by frame, outside the mask.
class WallWatch {
 public:
  explicit WallWatch(std::vector<cv::Mat> masks) : m_masks(std::move(masks)) {}

  void look(const EnvironmentModel& model) {
    if (m_frame == settled) m_wall.assign(model.levels().begin(), model.levels().end());
    if (m_frame >= settled) m_kept.push_back(keptShare(model));
    ++m_frame;
  }
  /// One a frame, the worst first.
  std::vector<double> kept() const {
    std::vector<double> shares = m_kept;
    std::sort(shares.begin(), shares.end());
    return shares;
  }

 private:
  double keptShare(const EnvironmentModel& model) const {
    const GridGeometry& grid = model.geometry();
    const auto isWall = [&](std::uint8_t level) {
      return level > 0 && grid.zOf(level) > nearestWall;
    };
    std::size_t cells = 0, kept = 0;
    for (int row = 0; row < grid.rows(); ++row) {
      for (int column = 0; column < grid.columns(); ++column) {
        const std::size_t k = grid.index(column, row);
        if (!isWall(m_wall[k]) || hidden(grid.surfacePoint(column, row, m_wall[k]))) continue;
        ++cells;
        kept += isWall(model.levels()[k]);
      }
    }
    return cells == 0 ? 0.0 : static_cast<double>(kept) / static_cast<double>(cells);
  }

  /// Whether the person was in the line of sight lately: what comes back takes its frames to enter.
  bool hidden(const Eigen::Vector3d& p) const {
    const cv::Point pixel(cvRound(focalLength * p.x() / p.z() + centreX),
                          cvRound(focalLength * p.y() / p.z() + centreY));
    for (std::size_t frame = m_frame - settled; frame <= m_frame; ++frame) {
      const cv::Mat& mask = m_masks[frame];
      if (!cv::Rect({}, mask.size()).contains(pixel) || mask.at<std::uint8_t>(pixel)) return true;
    }
    return false;
  }

  std::vector<cv::Mat> m_masks;
  std::size_t m_frame = 0;
  std::vector<std::uint8_t> m_wall;
  std::vector<double> m_kept;
};

}  // namespace

/// A person turns before a wall; the Kinect stands still.
class TestKinect : public QObject {
  Q_OBJECT
 private slots:
  void wallStaysInTheModelOutsideThePersonMask_data();
  void wallStaysInTheModelOutsideThePersonMask();
};

void TestKinect::wallStaysInTheModelOutsideThePersonMask_data() {
  QTest::addColumn<ModelUpdate>("update");
  QTest::addColumn<bool>("everyFrame");
  // Some frames of this recording lack up to a fifth of their depth. By Eq. 8-9 one miss removes a
  // cell (section 6, known weakness).
  QTest::newRow("thesis") << ModelUpdate::Thesis << false;
  QTest::newRow("hysteresis") << ModelUpdate::Hysteresis << true;
  QTest::newRow("log-odds") << ModelUpdate::LogOdds << true;
}

void TestKinect::wallStaysInTheModelOutsideThePersonMask() {
  QFETCH(ModelUpdate, update);
  QFETCH(bool, everyFrame);
  const QString recording = sharedData("rgbd_static_person_uva");
  REQUIRE_DATA(recording);
  const std::vector<cv::Mat> masks = readMasks(recording);
  Parameters parameters;
  parameters.bounds = {-1.5, 1.5, -1.2, 1.2, 0.5, 3.0};
  parameters.model.update = update;
  WallWatch watch(masks);
  const std::size_t frames =
      runSequence("depth:" + recording, parameters,
                  [&](const Result&, const Pipeline& pipeline) { watch.look(pipeline.model()); });
  QCOMPARE(frames, masks.size());
  const std::vector<double> kept = watch.kept();
  const auto bad = std::count_if(kept.begin(), kept.end(), [](double k) { return k < 0.99; });
  qInfo("%zu frames: worst keeps %.2f %%, median %.2f %%; %td below 99 %%", kept.size(),
        100 * kept.front(), 100 * kept[kept.size() / 2], bad);
  QVERIFY(kept[kept.size() / 2] >= 0.99);
  QVERIFY(!everyFrame || bad == 0);
}

BOOMWATCH_TEST(TestKinect)
#include "test_kinect.moc"
