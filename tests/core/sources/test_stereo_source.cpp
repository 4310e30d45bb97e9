#include <QTemporaryDir>
#include <QtTest>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "frame/stereo_rig.h"
#include "sources/stereo_source.h"
#include "support/compare_near.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"

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
    return errorOf([&] { openStereoSource(path, "stereo:" + path, options); });
  }

 private slots:
  void init() {
    m_temporary = std::make_unique<QTemporaryDir>();
    m_folder = m_temporary->path().toStdString();
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
    BW_COMPARE_NEAR(named->next(0ms).frame->stamp, 1403715273.262142976, 1e-6);
    BW_COMPARE_NEAR(named->info().nominalRate, 20, 0.01);
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
};

BOOMWATCH_TEST(TestStereoSource)
#include "test_stereo_source.moc"
