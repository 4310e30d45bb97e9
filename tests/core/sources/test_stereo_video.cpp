#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>
#include <filesystem>
#include <fstream>
#include <opencv2/videoio.hpp>

#include "sources/stereo_source.h"
#include "support/compare_near.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"

using namespace boomwatch;
using namespace std::chrono_literals;
namespace fs = std::filesystem;
using Status = ReadResult::Status;

namespace {

int valueOf(const cv::Mat& image) { return cvRound(cv::mean(image)[0]); }

// The index in the brightness of each frame, at even intervals.
void writeVideo(const fs::path& file, int frames, bool right) {
  cv::VideoWriter writer(file.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'),
                         20, {64, 48});
  for (int i = 0; i < frames; ++i) {
    writer << cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(10 * (i % 20) + (right ? 5 : 0)));
  }
}

}  // namespace

class TestStereoVideo : public QObject {
  Q_OBJECT

  std::unique_ptr<QTemporaryDir> m_temporary;
  fs::path m_folder;

  void writeText(const std::string& name, const std::string& text) {
    std::ofstream(m_folder / name, std::ios::binary) << text;
  }
  void writeCalibration() {
    writeText("calib.txt", "50 0 32 0 0 50 24 0 0 0 1 0\n50 0 32 -5 0 50 24 0 0 0 1 0\n");
  }
  std::unique_ptr<FrameSource> open() {
    return openStereoSource(m_folder.string(), "stereo:" + m_folder.string(), {});
  }
  QString faultOf(const std::string& path) {
    return errorOf([&] { openStereoSource(path, "", {}); });
  }

 private slots:
  void init() {
    m_temporary = std::make_unique<QTemporaryDir>();
    m_folder = m_temporary->path().toStdString();
  }

  void readsAPairOfVideosExactlyInAnyOrder() {
    writeVideo(m_folder / "left.avi", 120, false);
    writeVideo(m_folder / "right.avi", 120, true);
    if (!fs::exists(m_folder / "left.avi")) QSKIP("this OpenCV cannot write a video");
    writeCalibration();
    const auto source = open();
    QCOMPARE(*source->info().frameCount, std::size_t{120});
    QCOMPARE(source->info().nominalRate, 20.0);
    std::vector<int> values;
    for (int i = 0; i < 120; ++i) {
      const auto read = source->next(0ms);
      QCOMPARE(read.status, Status::Ok);
      QCOMPARE(read.frame->stamp, i / 20.0);
      values.push_back(valueOf(read.frame->left));
      BW_COMPARE_NEAR(values.back(), 10 * (i % 20), 3);
      BW_COMPARE_NEAR(valueOf(read.frame->right) - 10 * (i % 20), 5, 3);
    }
    QCOMPARE(source->next(0ms).status, Status::End);
    for (const std::size_t index : {0, 119, 1, 60, 59, 61, 100, 5, 118}) {
      QVERIFY(source->seek(index));
      const auto read = source->next(0ms);
      QCOMPARE(read.frame->sequence, index);
      QCOMPARE(valueOf(read.frame->left), values[index]);
    }
  }

  void countsFramesWhereTheyComeUnevenly_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"%1.mp4", "%1.mkv", "%1.avi"}) QTest::newRow(name) << name;
  }
  void countsFramesWhereTheyComeUnevenly() {
    QFETCH(QString, name);
    if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) QSKIP("absent: ffmpeg");
    for (const QString side : {"left", "right"}) {
      const QString file = QString::fromStdString(m_folder.string()) + "/" + name.arg(side);
      // One second is missing, so that seeking by time is off by 20 frames behind it.
      QProcess::execute("ffmpeg", {"-loglevel", "quiet", "-f", "lavfi", "-i",
                                   "testsrc=size=64x48:rate=20:duration=8", "-vf",
                                   "select=not(between(n\\,40\\,59))", "-vsync", "vfr", "-c:v",
                                   "mpeg4", "-g", "12", "-bf", "2", file});
    }
    writeCalibration();
    const auto source = open();
    std::vector<cv::Mat> decoded;
    ReadResult read;
    while ((read = source->next(0ms)).status == Status::Ok) decoded.push_back(read.frame->left);
    QCOMPARE(read.status, Status::End);
    QVERIFY(decoded.size() >= 140);
    for (const std::size_t index : {130, 45, 10, 139, 0, 100}) {
      QVERIFY(source->seek(index));
      read = source->next(0ms);
      QCOMPARE(read.status, Status::Ok);
      QCOMPARE(cv::norm(read.frame->left, decoded[index], cv::NORM_INF), 0.0);
    }
  }

  void refusesVideosOfDifferentLengthAndFilesThatAreNone() {
    writeVideo(m_folder / "left.avi", 30, false);
    writeVideo(m_folder / "right.avi", 29, true);
    if (!fs::exists(m_folder / "left.avi")) QSKIP("this OpenCV cannot write a video");
    writeCalibration();
    const QString fault = faultOf(m_folder.string());
    QVERIFY2(fault.contains("30") && fault.contains("29"), qPrintable(fault));
    writeText("right.avi", "no video");
    QVERIFY(faultOf(m_folder.string()).contains("right.avi"));
  }

  void endsWhereAVideoEndsEarly() {
    writeVideo(m_folder / "left.avi", 60, false);
    writeVideo(m_folder / "right.avi", 60, true);
    if (!fs::exists(m_folder / "left.avi")) QSKIP("this OpenCV cannot write a video");
    writeCalibration();
    const auto size = fs::file_size(m_folder / "left.avi");
    fs::resize_file(m_folder / "left.avi", size / 2);
    std::unique_ptr<FrameSource> source;
    try {
      source = open();
    } catch (const Error&) {
      return;  // that the cut is seen at once is as good
    }
    ReadResult read;
    int count = 0;
    while ((read = source->next(0ms)).status == Status::Ok) ++count;
    QCOMPARE(read.status, Status::End);
    QVERIFY(count > 10 && count < 60);
    QCOMPARE(source->next(0ms).status, Status::End);
    QVERIFY(source->seek(2));
    QCOMPARE(source->next(0ms).frame->sequence, std::uint64_t{2});
  }
};

BOOMWATCH_TEST(TestStereoVideo)
#include "test_stereo_video.moc"
