#include <QtTest>
#include <opencv2/imgproc.hpp>

#include "sources/stereo_source.h"
#include "stereo/stereo_stage.h"
#include "support/compare_near.h"
#include "support/real_data.h"
#include "support/test_registry.h"

using namespace boomwatch;
using namespace std::chrono_literals;
using Status = ReadResult::Status;

namespace {

double medianDepth(const Cloud& cloud) {
  std::vector<float> depths;
  for (const auto& p : cloud.points) {
    if (isMeasured(p)) depths.push_back(p.z());
  }
  if (depths.empty()) return 0;
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  return *middle;
}

}  // namespace

class TestStereoRecordings : public QObject {
  Q_OBJECT

 private slots:
  void opensEveryRecording_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("calibration");
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("width");
    const QString kitti = "stereo_seq_kitti_odometry/KITTI_sequence_1";
    QTest::newRow("overhead") << "stereo_static_topdown_oakd"
                              << "" << 400 << 1280;
    QTest::newRow("conveyor") << "stereo_static_conveyor_dtu"
                              << "" << 285 << 1280;
    QTest::newRow("raw") << "stereo_static_conveyor_dtu/raw_png"
                         << "" << 4 << 1280;
    QTest::newRow("boards") << "stereo_static_conveyor_dtu/calibration"
                            << "" << 20 << 1280;
    QTest::newRow("euroc") << "stereo_seq_euroc"
                           << "" << 20 << 752;
    QTest::newRow("kitti") << kitti << "" << 51 << 1226;
    QTest::newRow("eth3d") << "stereo_gt_eth3d_outdoor/playground"
                           << "" << 1 << 941;
    QTest::newRow("kitti2012") << "stereo_gt_kitti2012" << kitti + "/calib.txt" << 8 << 1226;
    QTest::newRow("teddy") << "stereo_gt_middlebury/opencv_extra_datasets/teddy"
                           << kitti + "/calib.txt" << 1 << 450;
    QTest::newRow("aloe") << "stereo_gt_middlebury/aloe" << kitti + "/calib.txt" << 1 << 1282;
    QTest::newRow("motorcycle") << "stereo_gt_middlebury/motorcycle" << kitti + "/calib.txt" << 1
                                << 741;
    QTest::newRow("mrpt") << "stereo_calib_chessboards/mrpt_stereo_calib" << kitti + "/calib.txt"
                          << 4 << 1024;
    QTest::newRow("opencv") << "stereo_calib_chessboards/opencv_left_right" << kitti + "/calib.txt"
                            << 13 << 640;
  }
  void opensEveryRecording() {
    QFETCH(QString, path);
    QFETCH(QString, calibration);
    QFETCH(int, count);
    QFETCH(int, width);
    const QString folder = sharedData(path);
    REQUIRE_DATA(folder);
    SourceOptions options;
    if (!calibration.isEmpty()) options.calibration = sharedData(calibration).toStdString();
    const auto source = openStereoSource(folder.toStdString(), "", options);
    QCOMPARE(*source->info().frameCount, static_cast<std::size_t>(count));
    const auto first = source->next(0ms);
    QCOMPARE(first.status, Status::Ok);
    QCOMPARE(first.frame->left.cols, width);
    QVERIFY(source->seek(static_cast<std::size_t>(count - 1)));
    const auto last = source->next(0ms);
    QCOMPARE(last.status, Status::Ok);
    QCOMPARE(last.frame->sequence, static_cast<std::uint64_t>(count - 1));
    QVERIFY(count == 1 || last.frame->stamp > first.frame->stamp);
    QCOMPARE(source->next(0ms).status, Status::End);
    QVERIFY(source->seek(0));
    QCOMPARE(cv::norm(source->next(0ms).frame->left, first.frame->left, cv::NORM_INF), 0.0);
  }

  void seeksInTheOverheadVideosToWhatDecodingGives() {
    const QString folder = sharedData("stereo_static_topdown_oakd");
    REQUIRE_DATA(folder);
    const auto source = openStereoSource(folder.toStdString(), "", {});
    std::vector<std::pair<cv::Mat, cv::Mat>> small(400);
    auto thumbnail = [](const cv::Mat& image) {
      cv::Mat result;
      cv::resize(image, result, {80, 50}, 0, 0, cv::INTER_AREA);
      return result;
    };
    for (auto& [left, right] : small) {
      const auto read = source->next(0ms);
      left = thumbnail(read.frame->left);
      right = thumbnail(read.frame->right);
    }
    for (std::size_t k = 0; k < 12; ++k) {
      const std::size_t index = (k * 149 + 7) % 400;
      QVERIFY(source->seek(index));
      const auto read = source->next(0ms);
      QCOMPARE(cv::norm(thumbnail(read.frame->left), small[index].first, cv::NORM_INF), 0.0);
      QCOMPARE(cv::norm(thumbnail(read.frame->right), small[index].second, cv::NORM_INF), 0.0);
    }
  }

  void findsTheFloorOfTheOverheadRecordingWhereItIs() {
    const QString folder = sharedData("stereo_static_topdown_oakd");
    REQUIRE_DATA(folder);
    const auto source = openStereoSource(folder.toStdString(), "", {});
    QVERIFY(source->seek(90));
    const auto frame = source->next(0ms).frame;
    StereoStage stage;
    const auto result = stage.process(frame->left, frame->right, *frame->rig, {});
    const double depth = medianDepth(*result.cloud);
    BW_COMPARE_NEAR(depth, 2.75, 0.05);
  }

  void measuresTheDisparityOfRealPairs_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<double>("near");
    QTest::addColumn<double>("far");
    QTest::newRow("conveyor") << "stereo_static_conveyor_dtu/raw_png" << 0.7 << 4.0;
    QTest::newRow("euroc") << "stereo_seq_euroc" << 1.0 << 8.0;
    QTest::newRow("kitti") << "stereo_seq_kitti_odometry/KITTI_sequence_1" << 6.0 << 40.0;
    QTest::newRow("eth3d") << "stereo_gt_eth3d_outdoor/playground" << 1.0 << 20.0;
  }
  void measuresTheDisparityOfRealPairs() {
    QFETCH(QString, path);
    QFETCH(double, near);
    QFETCH(double, far);
    const QString folder = sharedData(path);
    REQUIRE_DATA(folder);
    const auto frame = openStereoSource(folder.toStdString(), "", {})->next(0ms).frame;
    StereoStage stage;
    const auto result = stage.process(frame->left, frame->right, *frame->rig, {});
    const cv::Mat measured = result.disparity == result.disparity;
    const double fill = cv::countNonZero(measured) / static_cast<double>(measured.total());
    const double depth = medianDepth(*result.cloud);
    const QString found = QString("fill %1, median depth %2").arg(fill).arg(depth);
    QVERIFY2(fill > 0.3, qPrintable(found));
    QVERIFY2(depth > near && depth < far, qPrintable(found));
  }
};

BOOMWATCH_TEST(TestStereoRecordings)
#include "test_stereo_recordings.moc"
