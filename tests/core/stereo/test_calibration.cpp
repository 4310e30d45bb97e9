#include <QTemporaryDir>
#include <fstream>
#include <opencv2/calib3d.hpp>
#include <random>

#include "base/error.h"
#include "stereo/calibration.h"
#include "support/compare_near.h"
#include "support/real_data.h"
#include "support/test_registry.h"

using namespace boomwatch;
namespace fs = std::filesystem;

namespace {

const std::string m1 = "[ 500., 0., 320., 0., 501., 240., 0., 0., 1. ]";
const std::string m2 = "[ 502., 0., 322., 0., 503., 242., 0., 0., 1. ]";
const std::string identity = "[ 1., 0., 0., 0., 1., 0., 0., 0., 1. ]";
const std::string d5 = "[ -0.3, 0.1, 0.001, 0.002, 0.05 ]";

std::string matrix(const std::string& key, int rows, int columns, const std::string& data) {
  return key + ": !!opencv-matrix\n   rows: " + std::to_string(rows) +
         "\n   cols: " + std::to_string(columns) + "\n   dt: d\n   data: " + data + "\n";
}

std::string intrinsics() {
  return matrix("M1", 3, 3, m1) + matrix("D1", 1, 5, d5) + matrix("M2", 3, 3, m2) +
         matrix("D2", 1, 5, d5);
}

std::string extrinsics(const std::string& t = "[ -0.12, 0.001, 0.002 ]") {
  return matrix("R", 3, 3, identity) + matrix("T", 3, 1, t);
}

const std::string head = "%YAML:1.0\n---\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

// A rectified KITTI file, f 700, B 0.5 m.
const std::string kitti =
    "P0: 700 0 600 0 0 700 180 0 0 0 1 0\n"
    "P1: 700 0 600 -350 0 700 180 0 0 0 1 0\n"
    "P2: 710 0 610 71 0 710 181 0.2 0 0 1 0.003\n"
    "P3: 710 0 610 -284 0 710 181 2 0 0 1 0.003\n"
    "Tr: 1 0 0 0 0 1 0 0 0 0 1 0\n";

const std::string middlebury =
    "cam0=[994.978 0 311.193; 0 994.978 254.877; 0 0 1]\n"
    "cam1=[994.978 0 342.279; 0 994.978 254.877; 0 0 1]\n"
    "doffs=31.086\nbaseline=193.001\nwidth=741\nheight=500\nndisp=70\n";

}  // namespace

class TestCalibration : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  fs::path write(const std::string& name, const std::string& text) {
    const fs::path file = fs::path(m_folder.path().toStdString()) / name;
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

  // The fault that reading `text` gives; "" if none.
  std::string faultOf(const std::string& name, const std::string& text) {
    try {
      readCalibration(write(name, text));
    } catch (const Error& fault) {
      return fault.what();
    }
    return "";
  }

 private slots:
  void readsOpenCvYamlWithEverythingInOneFile() {
    const auto rig = readCalibration(write(
        "one.yaml", head + intrinsics() + extrinsics() + "image_width: 640\nimage_height: 480\n"));
    QCOMPARE(rig.leftMatrix(0, 0), 500.0);
    QCOMPARE(rig.rightMatrix(1, 2), 242.0);
    QCOMPARE(rig.leftDistortion.total(), std::size_t{5});
    QCOMPARE(rig.leftDistortion.at<double>(4), 0.05);
    QCOMPARE(rig.translation[0], -0.12);
    QCOMPARE(rig.imageSize.width, 640);
    QVERIFY(!rig.rectified);
  }

  void readsWhatOpenCvItselfWritesAsYamlAndXml_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("yaml") << "written.yml";
    QTest::newRow("xml") << "written.xml";
  }
  void readsWhatOpenCvItselfWritesAsYamlAndXml() {
    QFETCH(QString, name);
    const auto file = fs::path(m_folder.path().toStdString()) / name.toStdString();
    cv::Matx33d rotation;
    cv::Rodrigues(cv::Vec3d(0.01, -0.02, 0.03), rotation);
    const cv::Mat d = (cv::Mat_<float>(8, 1) << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8);
    {
      cv::FileStorage storage(file.string(), cv::FileStorage::WRITE);
      storage << "M1" << cv::Mat(cv::Matx33d(500, 0, 320, 0, 500, 240, 0, 0, 1)) << "D1" << d
              << "M2" << cv::Mat(cv::Matx33d(510, 0, 321, 0, 510, 241, 0, 0, 1)) << "D2" << d << "R"
              << cv::Mat(rotation) << "T" << cv::Mat(cv::Vec3d(-0.2, 0.01, 0)) << "image_size"
              << cv::Size(640, 480);
    }
    const auto rig = readCalibration(file);
    QVERIFY(cv::norm(rig.rotation - rotation, cv::NORM_INF) < 1e-12);
    QCOMPARE(rig.rightDistortion.cols, 8);
    QCOMPARE(static_cast<float>(rig.rightDistortion.at<double>(7)), 0.8f);
    QCOMPARE(rig.imageSize.height, 480);
  }

  void readsIntrinsicsWithExtrinsicsBesideThem() {
    write("pair/intrinsics.yml", head + intrinsics());
    const auto other = write("pair/extrinsics.yml", head + extrinsics());
    QCOMPARE(readCalibration(other).leftMatrix(0, 0), 500.0);
    QCOMPARE(readCalibration(other.parent_path() / "intrinsics.yml").translation[0], -0.12);
    QCOMPARE(findCalibration(other.parent_path())->filename().string(),
             std::string("intrinsics.yml"));
    QVERIFY(!findCalibration(other.parent_path() / "nowhere"));
  }

  void seesThatAnOpenCvPairIsAlreadyRectified() {
    const auto none = matrix("D1", 1, 5, "[ 0., 0., 0., 0., 0. ]");
    const auto text = head + matrix("M1", 3, 3, m1) + none +
                      matrix("M2", 3, 3, replaced(m1, "320.", "330.")) +
                      replaced(none, "D1", "D2") + extrinsics("[ -0.12, 0., 0. ]");
    const auto rig = readCalibration(write("flat.yml", text));
    QVERIFY(rig.rectified);
    QVERIFY(rig.leftDistortion.empty());
  }

  void readsKittiWithNamesAndWithout() {
    const auto rig = readCalibration(write("calib.txt", kitti));
    QVERIFY(rig.rectified);
    QCOMPARE(rig.baseline(), 0.5);
    QCOMPARE(rig.leftMatrix(0, 2), 600.0);
    QVERIFY(rig.imageSize.empty());
    const auto colour = readCalibration(write("calib.txt", kitti), CameraPair::Second);
    QCOMPARE(colour.baseline(), 0.5);
    QCOMPARE(colour.leftMatrix(0, 0), 710.0);
    const auto bare = readCalibration(write("bare.txt",
                                            "700 0 600 0 0 700 180 0 0 0 1 0\n"
                                            "7e2 0 6e2 -3.5e2 0 7e2 1.8e2 0 0 0 1 0\r\n"));
    QCOMPARE(bare.baseline(), 0.5);
  }

  void readsMiddleburyInMillimetresWithItsOffset() {
    const auto rig = readCalibration(write("middlebury.txt", middlebury));
    QVERIFY(rig.rectified);
    QCOMPARE(rig.baseline(), 0.193001);
    QCOMPARE(rig.rightMatrix(0, 2) - rig.leftMatrix(0, 2), 342.279 - 311.193);
    QCOMPARE(rig.imageSize.width, 741);
  }

  void saysWhatIsWrongAndWhere_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("says");
    const std::string whole = head + intrinsics() + extrinsics();
    auto row = [](const char* what, const std::string& text, const char* says,
                  const char* name = "bad.yml") {
      QTest::newRow(what) << QString(name) << QString::fromStdString(text) << QString(says);
    };
    for (const char* key : {"M1", "D1", "M2", "D2", "R", "T"}) {
      const std::string says = std::string("the key ") + key + " is missing";
      QTest::newRow(("missing " + std::string(key)).c_str())
          << "bad.yml" << QString::fromStdString(replaced(whole, std::string(key) + ":", "Z:"))
          << QString::fromStdString(says);
    }
    row("wrong shape", replaced(whole, "rows: 3\n   cols: 3", "rows: 9\n   cols: 1"), "M1");
    row("rows and data differ", replaced(whole, "rows: 3", "rows: 4"), "M1");
    row("claims billions", replaced(whole, "rows: 3", "rows: 2000000000"), "M1");
    row("words for numbers", replaced(whole, "500.", "many"), "M1");
    row("zero focal length", replaced(whole, "500.", "0."), "M1");
    row("negative focal length", replaced(whole, "503.", "-503."), "M2");
    row("NaN focal length", replaced(whole, "500.", ".Nan"), "M1");
    row("infinite centre", replaced(whole, "320.", ".Inf"), "M1");
    row("skew", replaced(whole, "500., 0.", "500., 3."), "M1");
    row("distortion count", replaced(replaced(whole, "cols: 5", "cols: 3"), d5, "[ 1., 2., 3. ]"),
        "D1 has 3 coefficients");
    row("NaN distortion", replaced(whole, "-0.3", ".Nan"), "D1");
    row("no rotation", replaced(whole, identity, "[ 1., 0., 0., 0., 2., 0., 0., 0., 1. ]"), "R");
    row("mirror", replaced(whole, identity, "[ 1., 0., 0., 0., 1., 0., 0., 0., -1. ]"), "R");
    row("swapped", head + intrinsics() + extrinsics("[ 0.12, 0., 0. ]"), "swapped");
    row("zero baseline", head + intrinsics() + extrinsics("[ 0., 0., 0. ]"), "T");
    row("NaN baseline", head + intrinsics() + extrinsics("[ .Nan, 0., 0. ]"), "T");
    row("vertical", head + intrinsics() + extrinsics("[ -0.01, -0.12, 0. ]"), "side by side");
    row("millimetres", head + intrinsics() + extrinsics("[ -120., 0., 0. ]"), "metres");
    row("image size", whole + "image_width: 0\nimage_height: 480\n", "image_width");
    row("a list of images", head + "images:\n  - left01.jpg\n", "M1 is missing");
    row("truncated", whole.substr(0, 250), "bad.yml");
    row("not YAML", "%YAML:1.0\n{{{]]]:::\n", "bad.yml");
    row("brackets", "%YAML:1.0\n" + std::string(100000, '['), "bad.yml");
    row(
        "dashes",
        "%YAML:1.0\na:\n " + replaced(std::string(300, '-'), "", "") +
            [] {
              std::string s;
              for (int i = 0; i < 20000; ++i) s += "- ";
              return s;
            }(),
        "bad.yml");
    row(
        "tags",
        "<?xml version=\"1.0\"?>\n<opencv_storage>" +
            [] {
              std::string s;
              for (int i = 0; i < 20000; ++i) s += "<a>";
              return s;
            }(),
        "bad.xml", "bad.xml");
    row("empty", "", "empty");
    row("blank", " \n\n", "empty");
    row("prose", "this is no calibration at all\n", "line 1", "calib.txt");
    row("kitti without P1", replaced(kitti, "P1:", "Q1:"), "P1 is missing", "calib.txt");
    row("kitti short", replaced(kitti, "700 0 600 0 ", "700 0 600 "), "P0", "calib.txt");
    row("kitti zero focal", "P0: 0 0 6 0 0 0 1 0 0 0 1 0\nP1: 0 0 6 -3 0 0 1 0 0 0 1 0\n", "P0",
        "calib.txt");
    row("kitti swapped", replaced(kitti, "-350", "350"), "swapped", "calib.txt");
    row("kitti zero baseline", replaced(kitti, "-350", "0"), "baseline", "calib.txt");
    row("kitti nan", replaced(kitti, "-350", "nan"), "baseline", "calib.txt");
    row("middlebury without baseline", replaced(middlebury, "baseline", "line"), "baseline",
        "calib.txt");
    row("middlebury swapped", replaced(middlebury, "=193", "=-193"), "swapped", "calib.txt");
    row("middlebury offset", replaced(middlebury, "doffs=31", "doffs=3"), "doffs", "calib.txt");
    row("middlebury size", replaced(middlebury, "width=741", "width=-1"), "width", "calib.txt");
    row("middlebury word", replaced(middlebury, "994.978", "f"), "cam0", "calib.txt");
  }
  void saysWhatIsWrongAndWhere() {
    QFETCH(QString, name);
    QFETCH(QString, text);
    QFETCH(QString, says);
    const auto fault = QString::fromStdString(faultOf(name.toStdString(), text.toStdString()));
    QVERIFY2(fault.contains(name), qPrintable(fault));
    QVERIFY2(fault.contains(says), qPrintable(fault));
  }

  void refusesWhatIsNoTextFile() {
    QVERIFY(faultOf("binary.yml", std::string("%YAML\0\x01\x02", 8)).find("not a text") !=
            std::string::npos);
    QVERIFY_EXCEPTION_THROWN(readCalibration(write("big.yml", std::string(1 << 20, ' '))), Error);
    QVERIFY_EXCEPTION_THROWN(readCalibration(m_folder.path().toStdString()), Error);
    QVERIFY_EXCEPTION_THROWN(readCalibration(m_folder.filePath("absent.yml").toStdString()), Error);
    QVERIFY_EXCEPTION_THROWN(readCalibration("/dev/zero"), Error);
  }

  void survivesDamageAnywhere_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("text");
    const auto text = QString::fromStdString(head + intrinsics() + extrinsics());
    const auto file = (fs::path(m_folder.path().toStdString()) / "whole.xml").string();
    {
      cv::FileStorage storage(file, cv::FileStorage::WRITE);
      for (const char* key : {"M1", "M2", "R"}) storage << key << cv::Mat::eye(3, 3, CV_64F);
      for (const char* key : {"D1", "D2"}) storage << key << cv::Mat::ones(1, 5, CV_64F);
      storage << "T" << cv::Mat(cv::Vec3d(-0.1, 0, 0)) << "image_size" << cv::Size(640, 480);
    }
    readCalibration(file);
    std::ifstream stream(file);
    const std::string xml(std::istreambuf_iterator<char>(stream), {});
    QTest::newRow("yaml") << "f.yml" << text;
    QTest::newRow("xml") << "f.xml" << QString::fromStdString(xml);
    QTest::newRow("kitti") << "k.txt" << QString::fromStdString(kitti);
    QTest::newRow("middlebury") << "m.txt" << QString::fromStdString(middlebury);
  }
  void survivesDamageAnywhere() {
    QFETCH(QString, name);
    QFETCH(QString, text);
    std::mt19937 random(1);
    int refused = 0;
    for (int i = 0; i < 600; ++i) {
      std::string damaged = text.toStdString();
      for (int k = 0; k < 3; ++k) {
        damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
      }
      if (i % 4 == 0) damaged.resize(random() % damaged.size());
      refused += !faultOf(name.toStdString(), damaged).empty();
    }
    QVERIFY(refused > 100);
  }

  void readsTheRecordingsCalibrations_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<double>("baseline");
    QTest::addColumn<bool>("rectified");
    QTest::newRow("overhead") << "stereo_static_topdown_oakd/calibration.yaml" << 0.0738 << false;
    QTest::newRow("conveyor") << "stereo_static_conveyor_dtu/calibration.yaml" << 0.1204 << false;
    QTest::newRow("euroc") << "stereo_seq_euroc/calibration.yaml" << 0.11008 << false;
    QTest::newRow("kitti") << "stereo_seq_kitti_odometry/KITTI_sequence_1/calib.txt" << 0.53715
                           << true;
    QTest::newRow("eth3d") << "stereo_gt_eth3d_outdoor/playground/calib.txt" << 0.05955 << true;
  }
  void readsTheRecordingsCalibrations() {
    QFETCH(QString, file);
    QFETCH(double, baseline);
    QFETCH(bool, rectified);
    const QString path = sharedData(file);
    REQUIRE_DATA(path);
    const auto rig = readCalibration(path.toStdString());
    BW_COMPARE_NEAR(rig.baseline(), baseline, 1e-4);
    QCOMPARE(rig.rectified, rectified);
  }

  void namesTheMissingExtrinsicsOfOpenCvsOwnExample() {
    const QString path = "/usr/share/doc/opencv-doc/examples/data/intrinsics.yml";
    REQUIRE_DATA(path);
    try {
      readCalibration(path.toStdString());
      QFAIL("there are no extrinsics");
    } catch (const Error& fault) {
      QVERIFY(QString(fault.what()).contains("extrinsics.yml"));
    }
  }
};

BOOMWATCH_TEST(TestCalibration)
#include "test_calibration.moc"
