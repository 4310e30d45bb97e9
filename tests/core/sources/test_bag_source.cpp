#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <random>

#include "files/file_bytes.h"
#include "open_source.h"
#include "sources/bag/bag_choice.h"
#include "sources/bag/bag_source.h"
#include "sources/bag/joined_bag.h"
#include "support/build_paths.h"
#include "support/compare_near.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

constexpr std::chrono::milliseconds patience{0};

struct Read {
  std::vector<FramePtr> frames;
  int bad = 0;
};

Read readAll(FrameSource& source) {
  Read read;
  for (int k = 0; k < 1000; ++k) {
    const ReadResult result = source.next(patience);
    if (result.status == ReadResult::Status::End) break;
    if (result.frame) read.frames.push_back(result.frame);
    read.bad += result.status == ReadResult::Status::Bad;
  }
  return read;
}

}  // namespace

/// Of bags that ROS's own Python packages wrote (support/write_bags.py).
class TestBagSource : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    QProcess writer;
    writer.start(QStringLiteral("/usr/bin/python3"),
                 {sourceFile(QStringLiteral("tests/support/write_bags.py")), m_folder.path()});
    QVERIFY(writer.waitForFinished(60000));
    const QByteArray errors = writer.readAllStandardError();
    if (errors.contains("ModuleNotFoundError")) QSKIP("ROS's Python packages are not installed");
    QVERIFY2(writer.exitCode() == 0, errors.constData());
  }

  void everyFormatGivesTheSamePairs_data() { formats("stereo"); }
  void everyFormatGivesTheSamePairs() {
    QFETCH(QString, file);
    const auto source = open(file);
    // The fourth has no right picture.
    QCOMPARE(source->info().note, std::string("1 pictures have no partner and are left out."));
    const Read read = readAll(*source);
    QCOMPARE(read.frames.size(), 5U);
    QCOMPARE(read.bad, 0);
    const int numbers[] = {0, 1, 2, 4, 5};
    for (std::size_t k = 0; k < read.frames.size(); ++k) {
      const Frame& frame = *read.frames[k];
      BW_COMPARE_NEAR(frame.stamp, 1000.0 + 0.1 * numbers[k], 1e-6);
      QCOMPARE(frame.left.size(), cv::Size(32, 24));
      QCOMPARE(frame.left.type(), CV_8UC1);
      for (const cv::Point p : {cv::Point(0, 0), cv::Point(31, 0), cv::Point(7, 23)}) {
        const int value = p.x + 2 * p.y + 10 * numbers[k];
        QCOMPARE(int(frame.left.at<uchar>(p)), value % 256);
        QCOMPARE(int(frame.right.at<uchar>(p)), (value + 100) % 256);
      }
      BW_COMPARE_NEAR(frame.rig->baseline(), 0.12, 1e-12);
      BW_COMPARE_NEAR(frame.rig->leftMatrix(0, 0), 400.0, 1e-12);
      QCOMPARE(frame.rig->leftDistortion.at<double>(0), 0.01);
    }
  }

  void stampsThatNobodySetAreThoseOfTheRecording_data() { formats("silent"); }
  void stampsThatNobodySetAreThoseOfTheRecording() {
    QFETCH(QString, file);
    const Read read = readAll(*open(file));
    QCOMPARE(read.frames.size(), 5U);
    BW_COMPARE_NEAR(read.frames[4]->stamp, 1000.5, 1e-6);
  }

  void depthIsMetricAndHasItsColour_data() {
    formats("depth");
    addRows("floats");
    addRows("realsense");
  }
  void depthIsMetricAndHasItsColour() {
    QFETCH(QString, file);
    const Read read = readAll(*open(file));
    QCOMPARE(read.frames.size(), 6U);
    const Frame& last = *read.frames.back();
    const double metres = file.contains("floats")      ? 1.5
                          : file.contains("realsense") ? 2005 * 0.0005
                                                       : 2.005;
    BW_COMPARE_NEAR(double(last.cloud->at(20, 5).z()), metres, 6e-4);
    BW_COMPARE_NEAR(double(last.cloud->at(20, 5).x()), metres * (20 - 16) / 400.0, 1e-5);
    QCOMPARE(isMeasured(last.cloud->at(0, 0)), !file.contains("floats"));
    QCOMPARE(last.left.at<cv::Vec3b>(3, 3), cv::Vec3b(30, 20, 10));
  }

  void cloudsHaveTheirFieldsInAnyOrder_data() { formats("cloud"); }
  void cloudsHaveTheirFieldsInAnyOrder() {
    QFETCH(QString, file);
    const Read read = readAll(*open(file));
    QCOMPARE(read.frames.size(), 6U);
    const Cloud& cloud = *read.frames[2]->cloud;
    QCOMPARE(cloud.width, 4);
    QCOMPARE(cloud.height, 3);
    QCOMPARE(cloud.at(3, 2), Eigen::Vector3f(0.75F, 1.0F, 4.0F));
  }

  void theFrameOfACloudIsNamed() {
    const auto source = open(m_folder.filePath(QStringLiteral("cloud-none.bag")));
    COMPARE_CONTAINS(QString::fromStdString(source->info().note), "'velodyne'");
  }

  void camerasThatCannotBeAreRefused() {
    const auto refused = [&](const char* name) {
      return errorOf([&] { open(m_folder.filePath(QString::fromLatin1(name))); });
    };
    COMPARE_CONTAINS(refused("fisheye-none.bag"), "'equidistant' is not read");
    COMPARE_CONTAINS(refused("focusless-none.bag"), "focal length");
  }

  void camerasWithoutDistortionHaveNone() {
    const Read read = readAll(*open(m_folder.filePath(QStringLiteral("straight-none.bag"))));
    QCOMPARE(read.frames.size(), 5U);
    QVERIFY(read.frames[0]->rig->leftDistortion.empty());
    QVERIFY(!read.frames[0]->rig->rectified);
  }

  void rectifiedIsAWordOfTheName() {
    const Read read = readAll(*open(m_folder.filePath(QStringLiteral("direct-none.bag"))));
    QCOMPARE(read.frames.size(), 5U);
    QVERIFY(!read.frames[0]->rig->rectified);
    for (const char* topic : {"/l/image_rect", "/infra1/image_rect_raw", "/l/rectified/image"}) {
      QVERIFY2(namesRectified(topic), topic);
    }
    QVERIFY(!namesRectified("/direct/image_raw") && !namesRectified("/rectangle/image"));
  }

  void severalSourcesAreAskedFor_data() { formats("several"); }
  void severalSourcesAreAskedFor() {
    QFETCH(QString, file);
    const QString message = errorOf([&] { open(file); });
    COMPARE_CONTAINS(message, "2 sources");
    COMPARE_CONTAINS(message, "left=/cam/left/image_raw,right=/cam/right/image_raw");
    COMPARE_CONTAINS(message, "cloud=/points");
    QCOMPARE(readAll(*open(file + ",cloud=/points")).frames.size(), 6U);
    const QString pair = ",left=/cam/left/image_raw,right=/cam/right/image_raw";
    QCOMPARE(readAll(*open(file + pair)).frames.size(), 5U);
    COMPARE_CONTAINS(errorOf([&] { open(file + ",cloud=/none"); }), "no topic '/none'");
    COMPARE_CONTAINS(errorOf([&] { open(file + ",left=/points"); }), "chooses no source");
    const QString swapped = ",left=/cam/right/image_raw,right=/cam/left/image_raw";
    COMPARE_CONTAINS(errorOf([&] { open(file + swapped); }), "swapped");
  }

  void aFolderOfFilesIsOneRecording() {
    QTemporaryDir folder;
    const QString source = m_folder.filePath(QStringLiteral("stereo-cdr.db3"));
    QVERIFY(QFile::copy(source, folder.filePath(QStringLiteral("run_0.db3"))));
    QCOMPARE(readAll(*open(folder.path())).frames.size(), 5U);
    QVERIFY(QFile::copy(m_folder.filePath(QStringLiteral("stereo-lz4.mcap")),
                        folder.filePath(QStringLiteral("run_1.mcap"))));
    const Read both = readAll(*open(folder.path()));
    QVERIFY(both.frames.size() >= 5);
    QCOMPARE(both.bad, 0);
  }

  /// What was recorded before the cut is there; nothing else may happen.
  void aCutBagGivesWhatIsWhole_data() { formats("stereo"); }
  void aCutBagGivesWhatIsWhole() {
    QFETCH(QString, file);
    const std::string whole = bytesOf(file);
    std::size_t before = 0;
    for (int part = 1; part < 40; ++part) {
      const std::size_t frames = framesOf(whole.substr(0, whole.size() * part / 40));
      QVERIFY2(frames >= before && frames <= 5, "a longer piece gives less");
      before = frames;
    }
    if (file.endsWith("db3")) return;  // sqlite wants the whole file
    QVERIFY2(before >= 4, qPrintable(QString::number(before)));
    const auto cut = m_damaged.write(QStringLiteral("cut"),
                                     QByteArray::fromStdString(whole.substr(0, whole.size() - 9)));
    COMPARE_CONTAINS(QString::fromStdString(openBagFile(cut)->damage()), "end is missing");
  }

  void flippedBitsDoNoHarm_data() { formats("stereo"); }
  void flippedBitsDoNoHarm() {
    QFETCH(QString, file);
    const std::string whole = bytesOf(file);
    std::mt19937 random(7);
    for (int k = 0; k < 60; ++k) {
      std::string damaged = whole;
      for (int bit = 0; bit < 1 + k / 4; ++bit) {
        damaged[random() % damaged.size()] ^= static_cast<char>(1 << random() % 8);
      }
      QVERIFY(framesOf(damaged) <= 6);
    }
  }

  void otherFilesAreRefusedByName() {
    const TemporaryFolder folder;
    const auto refused = [&](const QByteArray& bytes) {
      const auto file = folder.write(QStringLiteral("x.bag"), bytes);
      return errorOf([&] { openBagFile(file); });
    };
    COMPARE_CONTAINS(refused("#ROSBAG V1.2\n"), "format 1");
    COMPARE_CONTAINS(refused("\x28\xB5\x2F\xFD..."), "zstd -d");
    COMPARE_CONTAINS(refused("SQLite format 3"), "no ROS 2 bag");
    COMPARE_CONTAINS(refused("hello"), "no bag");
    COMPARE_CONTAINS(errorOf([&] { openBagFile(folder.path("none.bag")); }), "no such file");
    COMPARE_CONTAINS(errorOf([&] { openBagPath(folder.path()); }), "no bag");
  }

 private:
  void formats(const char* content) {
    QTest::addColumn<QString>("file");
    addRows(content);
  }
  void addRows(const char* content) {
    for (const char* format : {"none.bag", "bz2.bag", "lz4.bag", "none.mcap", "lz4.mcap",
                               "zstd.mcap", "unindexed.mcap", "cdr.db3"}) {
      const QString name = QStringLiteral("%1-%2").arg(content, format);
      QTest::newRow(qPrintable(name)) << m_folder.filePath(name);
    }
  }

  static std::unique_ptr<FrameSource> open(const QString& path) {
    return openSource("bag:" + path.toStdString());
  }
  static std::string bytesOf(const QString& file) {
    return readFileBytes(file.toStdString(), 1 << 20);
  }
  /// Frames that a file of these bytes gives; 0 where it is refused.
  std::size_t framesOf(const std::string& bytes) {
    const auto file = m_damaged.write(QStringLiteral("damaged"), QByteArray::fromStdString(bytes));
    try {
      return readAll(*openBagSource(file.string(), "bag:damaged", {})).frames.size();
    } catch (const Error&) {
      return 0;
    }
  }

  QTemporaryDir m_folder;
  TemporaryFolder m_damaged;
};

BOOMWATCH_TEST(TestBagSource)
#include "test_bag_source.moc"
