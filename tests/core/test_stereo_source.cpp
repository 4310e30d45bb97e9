#include <QTemporaryDir>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "frame/error.h"
#include "real_data.h"
#include "sources/bounded_image.h"
#include "sources/image_sequence.h"
#include "sources/stereo_source.h"
#include "stereo/stereo_matcher.h"

using namespace boomwatch;
using namespace std::chrono_literals;
namespace fs = std::filesystem;
using Status = ReadResult::Status;

namespace {

// A picture that tells its index and side by its grey value.
cv::Mat picture(int index, bool right = false, cv::Size size = {64, 48}) {
  return {size, CV_8UC1, cv::Scalar(10 * index + (right ? 5 : 0))};
}

int valueOf(const cv::Mat& image) { return cvRound(cv::mean(image)[0]); }

std::string numbered(const std::string& before, int index, const std::string& after) {
  return before + std::to_string(index) + after;
}

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

// The index in the brightness of each frame, at even intervals.
void writeVideo(const fs::path& file, int frames, bool right) {
  cv::VideoWriter writer(file.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'),
                         20, {64, 48});
  for (int i = 0; i < frames; ++i) {
    cv::Mat colour;
    cv::cvtColor(picture(i % 20, right), colour, cv::COLOR_GRAY2BGR);
    writer << colour;
  }
}

}  // namespace

class TestStereoSource : public QObject {
  Q_OBJECT

  std::unique_ptr<QTemporaryDir> m_temporary;
  fs::path m_folder;

  fs::path write(const std::string& name, const cv::Mat& image) {
    const fs::path file = m_folder / name;
    fs::create_directories(file.parent_path());
    cv::imwrite(file.string(), image);
    return file;
  }
  void writeText(const std::string& name, const std::string& text) {
    std::ofstream(m_folder / name, std::ios::binary) << text;
  }
  void writeCalibration(const std::string& name = "calib.txt") {
    writeText(name, "P0: 50 0 32 0 0 50 24 0 0 0 1 0\nP1: 50 0 32 -5 0 50 24 0 0 0 1 0\n");
  }
  void writePairs(int count) {
    for (int i = 0; i < count; ++i) {
      write(numbered("left/", i, ".png"), picture(i));
      write(numbered("right/", i, ".png"), picture(i, true));
    }
    writeCalibration();
  }
  std::unique_ptr<FrameSource> open(const std::string& below = "") {
    const std::string path = (m_folder / below).string();
    return openStereoSource(path, "stereo:" + path, {});
  }
  QString faultOf(const std::string& path, const SourceOptions& options = {}) {
    try {
      openStereoSource(path, "stereo:" + path, options);
    } catch (const Error& fault) {
      return fault.what();
    }
    return "";
  }

 private slots:
  void init() {
    m_temporary = std::make_unique<QTemporaryDir>();
    m_folder = m_temporary->path().toStdString();
  }

  void ordersNamesAsPeopleNumberThem() {
    QVERIFY(naturallyLess("a2", "a10"));
    QVERIFY(!naturallyLess("a10", "a2"));
    QVERIFY(naturallyLess("a09b1", "a9b2"));
    QVERIFY(naturallyLess("a", "a1"));
    QVERIFY(naturallyLess("99999999999999999999998", "99999999999999999999999"));
    QVERIFY(naturallyLess("01", "1") != naturallyLess("1", "01"));
    QVERIFY(!naturallyLess("x1", "x1"));
  }

  void readsStepsAndSeeks() {
    writePairs(12);
    const auto source = open();
    QCOMPARE(*source->info().frameCount, std::size_t{12});
    QCOMPARE(source->info().nominalRate, 10.0);
    QVERIFY(!source->info().live);
    for (int i = 0; i < 12; ++i) {
      const auto read = source->next(0ms);
      QCOMPARE(read.status, Status::Ok);
      QCOMPARE(read.frame->sequence, static_cast<std::uint64_t>(i));
      QCOMPARE(read.frame->stamp, i / 10.0);
      QCOMPARE(valueOf(read.frame->left), 10 * i);
      QCOMPARE(valueOf(read.frame->right), 10 * i + 5);
      QVERIFY(read.frame->rig);
    }
    QCOMPARE(source->next(0ms).status, Status::End);
    QVERIFY(source->seek(3));
    QVERIFY(!source->seek(12));
    QCOMPARE(source->next(0ms).frame->sequence, std::uint64_t{3});
  }

  void findsPairsByTheirNames_data() {
    QTest::addColumn<QString>("left");
    QTest::addColumn<QString>("right");
    for (const auto& [left, right] : std::vector<std::pair<const char*, const char*>>{
             {"left/%1.png", "right/%1.png"},
             {"image_l/%1.png", "image_r/%1.png"},
             {"image_0/%1.png", "image_1/%1.png"},
             {"image_00/data/%1.png", "image_01/data/%1.png"},
             {"cam0/%1.png", "cam1/%1.png"},
             {"cam0/data/%1.png", "cam1/data/%1.png"},
             {"left%1.jpg", "right%1.jpg"},
             {"left-000%1.png", "right-000%1.png"},
             {"%1_left.pgm", "%1_right.pgm"},
             {"%1_L.bmp", "%1_R.bmp"},
             {"scene%1L.png", "scene%1R.png"}}) {
      QTest::newRow(left) << left << right;
    }
  }
  void findsPairsByTheirNames() {
    QFETCH(QString, left);
    QFETCH(QString, right);
    for (int i = 1; i < 4; ++i) {
      write(left.arg(i).toStdString(), picture(i));
      write(right.arg(i).toStdString(), picture(i, true));
    }
    writeCalibration();
    const auto source = open();
    QCOMPARE(*source->info().frameCount, std::size_t{3});
    const auto read = source->next(0ms);
    QCOMPARE(valueOf(read.frame->left), 10);
    QCOMPARE(valueOf(read.frame->right), 15);
  }

  void findsMiddleburysPairs_data() {
    QTest::addColumn<QString>("left");
    QTest::addColumn<QString>("right");
    QTest::newRow("2014") << "im0.png"
                          << "im1.png";
    QTest::newRow("2003") << "im2.pgm"
                          << "im6.pgm";
    QTest::newRow("2006") << "view1.png"
                          << "view5.png";
  }
  void findsMiddleburysPairs() {
    QFETCH(QString, left);
    QFETCH(QString, right);
    write(left.toStdString(), picture(1));
    write(right.toStdString(), picture(1, true));
    writeCalibration();
    QCOMPARE(*open()->info().frameCount, std::size_t{1});
  }

  void takesTwoFoldersOrTwoFilesByName() {
    writePairs(2);
    write("one, two.png", picture(3));
    const std::string base = m_folder.string() + "/";
    const auto folders = openStereoSource(base + "right," + base + "left/", "x", {});
    QCOMPARE(valueOf(folders->next(0ms).frame->left), 5);
    const auto files = openStereoSource(base + "one, two.png," + base + "right/0.png", "x", {});
    QCOMPARE(valueOf(files->next(0ms).frame->left), 30);
    QCOMPARE(files->info().address, std::string("x"));
  }

  void readsKittisColourPairWithItsOwnCalibration() {
    write("image_2/0.png", picture(1));
    write("image_3/0.png", picture(1, true));
    writeText("calib.txt",
              "P0: 50 0 32 0 0 50 24 0 0 0 1 0\nP1: 50 0 32 -5 0 50 24 0 0 0 1 0\n"
              "P2: 50 0 32 3 0 50 24 0 0 0 1 0\nP3: 50 0 32 -7 0 50 24 0 0 0 1 0\n");
    QCOMPARE(open()->next(0ms).frame->rig->baseline(), 0.2);
  }

  void findsTheCalibrationInTheFolderAboveItOrWhereTold() {
    for (const char* name : {"a/left/0.png", "a/right/0.png"}) write(name, picture(1));
    QVERIFY(faultOf((m_folder / "a").string()).contains("--calibration"));
    writeCalibration("elsewhere.txt");
    const std::string told = (m_folder / "elsewhere.txt").string();
    QVERIFY(openStereoSource((m_folder / "a").string(), "", {told}));
    writeCalibration();
    QVERIFY(open("a"));
    QVERIFY(open("a/"));
    QVERIFY(faultOf((m_folder / "a").string(), {"no such.yml"}).contains("no such.yml"));
  }

  void takesStampsFromNamesAndFromAFile() {
    for (const char* name : {"1403715273262142976.png", "1403715273312143104.png"}) {
      write(std::string("cam0/") + name, picture(1));
      write(std::string("cam1/") + name, picture(1, true));
    }
    writeCalibration();
    const auto named = open();
    QVERIFY(std::abs(named->next(0ms).frame->stamp - 1403715273.262142976) < 1e-6);
    QVERIFY(std::abs(named->info().nominalRate - 20) < 0.01);
    writeText("timestamps.txt", "# seconds\n1.5\n 2.25 left right\n");
    const auto listed = open();
    QCOMPARE(listed->next(0ms).frame->stamp, 1.5);
    QCOMPARE(listed->next(0ms).frame->stamp, 2.25);
    writeText("timestamps.txt", "1.5\n");
    QVERIFY(faultOf(m_folder.string()).contains("1 times for 2 pairs"));
    writeText("timestamps.txt", "1.5\n1.25\n");
    QVERIFY(faultOf(m_folder.string()).contains("line 2"));
    writeText("timestamps.txt", "soon\n");
    QVERIFY(faultOf(m_folder.string()).contains("line 1"));
  }

  void saysWhyItCannotOpen() {
    QVERIFY(faultOf((m_folder / "absent").string()).contains("no such folder"));
    QVERIFY(faultOf("").contains("no path"));
    QVERIFY(faultOf(m_folder.string()).contains("no left and right"));
    fs::create_directories(m_folder / "left");
    fs::create_directories(m_folder / "right");
    QVERIFY(faultOf(m_folder.string()).contains("no pictures"));
    writePairs(3);
    fs::remove(m_folder / "right/2.png");
    const QString counts = faultOf(m_folder.string());
    QVERIFY2(counts.contains("3 left") && counts.contains("2 right"), qPrintable(counts));
    fs::remove(m_folder / "left/1.png");
    QVERIFY(faultOf(m_folder.string()).contains("another number"));
    QVERIFY(faultOf((m_folder / "left/0.png").string()).contains("not a folder"));
    QVERIFY(faultOf(m_folder.string() + "," + m_folder.string() + "/left/0.png").contains("two"));
  }

  void refusesPairsTakenAtDifferentTimes() {
    for (const char* name : {"1403715273262142976.png", "1403715273312143104.png"}) {
      write(std::string("cam0/") + name, picture(1));
    }
    for (const char* name : {"1403715273262142976.png", "1403715273362143104.png"}) {
      write(std::string("cam1/") + name, picture(1));
    }
    writeCalibration();
    QVERIFY(faultOf(m_folder.string()).contains("another number"));
  }

  void goesOnAfterFaultsOfSingleFrames() {
    writePairs(6);
    writeText("left/1.png", "no picture");
    write("left/2.png", picture(2, false, {32, 24}));
    write("right/2.png", picture(2, true, {32, 24}));
    write("right/3.png", picture(3, true, {32, 24}));
    writeText("right/4.png", "");
    const auto source = open();
    QCOMPARE(source->next(0ms).status, Status::Ok);
    for (const char* says :
         {"left/1.png", "from 64 x 48 to 32 x 24", "right is 32 x 24", "right/4.png"}) {
      const auto read = source->next(0ms);
      QCOMPARE(read.status, Status::Bad);
      QVERIFY2(QString::fromStdString(read.message).contains(says), read.message.c_str());
      QVERIFY(!read.frame);
    }
    const auto last = source->next(0ms);
    QCOMPARE(last.status, Status::Ok);
    QCOMPARE(last.frame->sequence, std::uint64_t{5});
  }

  void refusesACalibrationForAnotherSize() {
    write("im0.png", picture(1));
    write("im1.png", picture(1, true));
    writeText("calib.txt",
              "cam0=[50 0 32; 0 50 24; 0 0 1]\ncam1=[50 0 32; 0 50 24; 0 0 1]\n"
              "baseline=100\nwidth=640\nheight=480\n");
    const QString fault = faultOf(m_folder.string());
    QVERIFY2(fault.contains("640 x 480") && fault.contains("64 x 48"), qPrintable(fault));
  }

  void refusesPicturesThatClaimABillionPixels() {
    const std::string png("\x89PNG\r\n\x1A\n\0\0\0\rIHDR\0\0\x80\0\0\0\x80\0\x08\0\0\0\0", 29);
    const std::string pgm = "P5\n# large\n40000 40000\n255\n";
    const std::string bmp("BM\0\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\0\0\1\0\0\0\1\0\1\0\x18\0", 30);
    const std::string jpg("\xFF\xD8\xFF\xC0\0\x11\x08\xFF\xFF\xFF\xFF\3\1\x22\0\2\x11\1\3\x11\1",
                          21);
    for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
             {"a.png", png}, {"a.pgm", pgm}, {"a.bmp", bmp}, {"a.jpg", jpg}}) {
      writeText(name, text);
      const auto result = readImage(m_folder / name);
      QVERIFY(result.image.empty());
      QVERIFY2(QString::fromStdString(result.fault).contains("is not read"), result.fault.c_str());
      QVERIFY(!imageSize(m_folder / name));
    }
  }

  void tellsTheSizeOfEveryFormatItReads() {
    for (const std::string name : {"a.png", "a.jpg", "a.bmp", "a.pgm", "a.ppm"}) {
      const int type = name == "a.pgm" ? CV_8UC1 : CV_8UC3;
      const auto file = write(name, cv::Mat(37, 53, type, cv::Scalar(1, 2, 3)));
      QVERIFY2(imageSize(file) == cv::Size(53, 37), name.c_str());
      QVERIFY2(readImage(file).image.size() == cv::Size(53, 37), name.c_str());
    }
  }

  void refusesTruncatedPictures() {
    cv::Mat noise(37, 53, CV_8UC1);
    cv::RNG(1).fill(noise, cv::RNG::UNIFORM, 0, 256);
    for (const char* name : {"a.png", "a.jpg", "a.bmp", "a.pgm"}) {
      const auto file = write(name, noise);
      std::ifstream stream(file, std::ios::binary);
      const std::string whole(std::istreambuf_iterator<char>(stream), {});
      for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 12) {
        writeText(name, whole.substr(0, size));
        const auto result = readImage(file);
        QVERIFY2(result.image.empty() && !result.fault.empty(), name);
      }
    }
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
      QVERIFY(std::abs(values.back() - 10 * (i % 20)) <= 3);
      QVERIFY(std::abs(valueOf(read.frame->right) - 10 * (i % 20) - 5) <= 3);
    }
    QCOMPARE(source->next(0ms).status, Status::End);
    for (const std::size_t index : {0, 119, 1, 60, 59, 61, 100, 5, 118}) {
      QVERIFY(source->seek(index));
      const auto read = source->next(0ms);
      QCOMPARE(read.frame->sequence, index);
      QCOMPARE(valueOf(read.frame->left), values[index]);
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
    for (std::size_t k = 0; k < 25; ++k) {
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
    QVERIFY2(std::abs(depth - 2.75) < 0.05, qPrintable(QString::number(depth)));
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

QTEST_GUILESS_MAIN(TestStereoSource)
#include "test_stereo_source.moc"
