#include <QtTest>
#include <opencv2/imgcodecs.hpp>

#include "sources/depth_source.h"
#include "support/camera_check.h"
#include "support/compare_near.h"
#include "support/real_data.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

constexpr std::chrono::milliseconds patience{100};

QByteArray png(const cv::Mat& image) {
  std::vector<uchar> bytes;
  cv::imencode(".png", image, bytes);
  return {reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size())};
}

/// 4 x 3 units of `value`; the first is not measured.
QByteArray depthPng(int value, cv::Size size = {4, 3}) {
  cv::Mat depth(size, CV_16UC1, cv::Scalar(value));
  depth.at<std::uint16_t>(0, 0) = 0;
  return png(depth);
}

QByteArray colourPng(int value, cv::Size size = {4, 3}) {
  return png(cv::Mat(size, CV_8UC3, cv::Scalar(value, 0, 0)));
}

const QByteArray intrinsics = "%YAML:1.0\nfx: 100.0\nfy: 50.0\ncx: 1.0\ncy: 2.0\n";

std::unique_ptr<FrameSource> open(const TemporaryFolder& folder) {
  return openDepthSource(folder.path(), "depth:here");
}

QString badMessage(const ReadResult& read) {
  return read.status == ReadResult::Status::Bad ? QString::fromStdString(read.message) : QString();
}

/// Columns for files that are faulty, and what adds a row: its title, the file's name and content,
/// and what is said of it.
auto faultRows() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<QString>("complaint");
  return [](const char* title, const QString& name, const QByteArray& bytes,
            const char* complaint) { QTest::newRow(title) << name << bytes << complaint; };
}

}  // namespace

class TestDepthSource : public QObject {
  Q_OBJECT
 private slots:
  void aPlainLayoutGivesOrganisedCloudsInMetres() {
    const TemporaryFolder folder;
    folder.write("intrinsics.yaml", intrinsics);
    folder.write("depth/9.png", depthPng(2000));
    folder.write("depth/10.png", depthPng(3000));
    folder.write("colour/9.png", colourPng(9));
    folder.write("colour/10.png", colourPng(10));
    const auto source = open(folder);
    QCOMPARE(source->info().frameCount, std::optional<std::size_t>(2));
    QCOMPARE(QString::fromStdString(source->info().address), QString("depth:here"));
    const ReadResult read = source->next(patience);
    QVERIFY(read.status == ReadResult::Status::Ok);
    const Cloud& cloud = *read.frame->cloud;
    QCOMPARE(cloud.width, 4);
    QCOMPARE(cloud.height, 3);
    QVERIFY(cloud.at(0, 0).array().isNaN().all());
    // (u - cx) z / fx, (v - cy) z / fy
    QVERIFY(cloud.at(3, 0).isApprox(Eigen::Vector3f(0.04F, -0.08F, 2.0F)));
    QCOMPARE(*cloud.camera, (PinholeCamera{4, 3, 100.0, 50.0, 1.0, 2.0}));
    QVERIFY(missOfCamera(cloud) < 1e-5);
    QCOMPARE(cloud.noise.at(10.0), 0.14);  // a Kinect's, at 10 m
    QCOMPARE(read.frame->left.at<cv::Vec3b>(0, 0), cv::Vec3b(9, 0, 0));
    const FramePtr second = source->next(patience).frame;
    QCOMPARE(second->cloud->at(1, 2), Eigen::Vector3f(0.0F, 0.0F, 3.0F));
    QCOMPARE(second->left.at<cv::Vec3b>(0, 0)[0], uchar(10));
    QCOMPARE(second->sequence, std::uint64_t(1));
    QCOMPARE(second->stamp, 0.1);
    QVERIFY(source->next(patience).status == ReadResult::Status::End);
    QVERIFY(source->seek(0));
    QCOMPARE(source->next(patience).frame->sequence, std::uint64_t(0));
    QVERIFY(!source->seek(2));
  }

  void intrinsicsAreReadHoweverTheyAreSpelt_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("text");
    const QByteArray matrix =
        ": !!opencv-matrix\n  rows: 3\n  cols: 3\n  dt: d\n"
        "  data: [ 100., 0., 1., 0., 50., 2., 0., 0., 1. ]\n";
    for (const char* key : {"camera_matrix", "M1", "K", "intrinsic"}) {
      QTest::newRow(key) << "calibration.yml"
                         << "%YAML:1.0\n---\n" + (key + matrix);
    }
    QTest::newRow("numbers") << "camera.yaml" << intrinsics;
    QTest::newRow("whole numbers")
        << "camera.json" << QByteArray("{\"fx\":100,\"fy\":50,\"cx\":1,\"cy\":2}");
    QTest::newRow("factor") << "camera.yaml" << intrinsics + "depth_factor: 1000.0\n";
  }
  void intrinsicsAreReadHoweverTheyAreSpelt() {
    QFETCH(QString, name);
    QFETCH(QByteArray, text);
    const TemporaryFolder folder;
    folder.write(name, text);
    folder.write("depth/1.png", depthPng(2000));
    const FramePtr frame = open(folder)->next(patience).frame;
    QVERIFY(frame->cloud->at(3, 0).isApprox(Eigen::Vector3f(0.04F, -0.08F, 2.0F)));
    QVERIFY(frame->left.empty());
  }

  void tumsListsAreMatchedByTime() {
    const TemporaryFolder folder;
    folder.write("depth.txt",
                 "# depth maps\n1000.00 depth/a.png\n1000.10 depth/b.png\n1000.20 depth/c.png\n");
    folder.write("rgb.txt",
                 "# colour\n1000.019 rgb/late.png\n999.99 rgb/early.png\n1000.075 rgb/far.png\n"
                 "1000.121 rgb/tooLate.png\n1000.2 rgb/same.png\n");
    folder.write("depth/a.png", depthPng(5000));
    folder.write("depth/b.png", depthPng(10000));
    folder.write("depth/c.png", depthPng(15000));
    folder.write("rgb/early.png", colourPng(1));
    folder.write("rgb/same.png", colourPng(2));
    const auto source = open(folder);
    const FramePtr first = source->next(patience).frame;
    QCOMPARE(first->left.at<cv::Vec3b>(0, 0)[0], uchar(1));
    QCOMPARE(first->stamp, 1000.0);
    QCOMPARE(first->cloud->at(1, 1).z(), 1.0F);  // 5000 units a metre
    QCOMPARE(*first->cloud->camera, (PinholeCamera{4, 3, 525.0, 525.0, 319.5, 239.5}));
    BW_COMPARE_NEAR(first->cloud->at(1, 1).x(), (1 - 319.5F) / 525.0F, 1e-6F);
    BW_COMPARE_NEAR(first->cloud->at(1, 1).y(), (1 - 239.5F) / 525.0F, 1e-6F);
    const FramePtr second = source->next(patience).frame;
    QVERIFY(second->left.empty());  // 21 ms and 25 ms away
    QCOMPARE(second->cloud->at(1, 1).z(), 2.0F);
    QCOMPARE(source->next(patience).frame->left.at<cv::Vec3b>(0, 0)[0], uchar(2));
    BW_COMPARE_NEAR(source->info().nominalRate, 10.0, 1e-6);
  }

  void aFileBesideTumsListsReplacesItsIntrinsics() {
    const TemporaryFolder folder;
    folder.write("depth.txt", "1 a.png\n");
    folder.write("a.png", depthPng(2000));
    folder.write("intrinsics.yaml", intrinsics);
    QVERIFY(open(folder)->next(patience).frame->cloud->at(3, 0).isApprox(
        Eigen::Vector3f(0.04F, -0.08F, 2.0F)));
  }

  void coloursOfOtherNamesAreMatchedInOrder() {
    const TemporaryFolder folder;
    folder.write("intrinsics.yaml", intrinsics);
    folder.write("depth/d2.png", depthPng(2));
    folder.write("depth/d10.png", depthPng(10));
    folder.write("rgb/c9.png", colourPng(2));
    folder.write("rgb/c11.png", colourPng(10));
    const auto source = open(folder);
    for (const int value : {2, 10}) {
      const FramePtr frame = source->next(patience).frame;
      QCOMPARE(int(frame->left.at<cv::Vec3b>(0, 0)[0]), value);
      QCOMPARE(frame->cloud->at(1, 1).z(), float(value) / 1000.0F);
    }
    folder.write("rgb/c12.png", colourPng(10));
    COMPARE_CONTAINS(errorOf([&] { open(folder); }), QString("rgb"));
  }

  void whatCannotBeOpenedIsRefusedByName_data() {
    const auto row = faultRows();
    row("no intrinsics", "note.txt", "hello", "no intrinsics");
    row("empty", "intrinsics.yaml", "", "empty");
    row("not YAML", "intrinsics.yaml", "\x01\x02 rubbish", "intrinsics.yaml");
    row("no key", "intrinsics.yaml", "%YAML:1.0\na: 1\n", "camera_matrix");
    row("half of it", "intrinsics.yaml", "%YAML:1.0\nfx: 1.0\nfy: 1.0\ncx: 3.0\n", "cy");
    row("a word", "intrinsics.yaml", "%YAML:1.0\nfx: wide\nfy: 1.0\ncx: 3.0\ncy: 1.0\n", "fx");
    row("zero focal length", "intrinsics.yaml", "%YAML:1.0\nfx: 0.0\nfy: 1.0\ncx: 3.0\ncy: 1.0\n",
        "focal length");
    row("broken XML", "intrinsics.xml", "<?xml version=\"1.0\"?>\n<opencv_storage>\n<fx>1</f",
        "line 3");
    row("nested XML", "intrinsics.xml", QByteArray("<a>").repeated(300000), "too many tags");
    row("nested YAML", "intrinsics.yaml", QByteArray(900000, '['), "intrinsics.yaml");
    row("not finite", "intrinsics.yaml", "%YAML:1.0\nfx: .nan\nfy: 1.0\ncx: 3.0\ncy: 1.0\n", "fx");
    row("factor", "intrinsics.yaml", intrinsics + "depth_factor: 0\n", "depth_factor");
    row("small matrix", "intrinsics.yaml",
        "%YAML:1.0\nK: !!opencv-matrix\n  rows: 1\n  cols: 1\n  dt: d\n  data: [ 1. ]\n", "3 x 3");
    row("matrix without data", "intrinsics.yaml",
        "%YAML:1.0\nK: !!opencv-matrix\n  rows: 3\n  cols: 3\n  dt: d\n  data: [ 1. ]\n",
        "intrinsics.yaml");
    row("huge matrix", "intrinsics.yaml",
        "%YAML:1.0\nK: !!opencv-matrix\n  rows: 99999\n  cols: 99999\n  dt: d\n  data: [ 1. ]\n",
        "intrinsics.yaml");
    row("a matrix that is a word", "intrinsics.yaml", "%YAML:1.0\nK: wide\n", "intrinsics.yaml");
    row("faulty list", "depth.txt", "1000.0 a.png\nsoon b.png\n", "line 2");
    row("list of nothing", "depth.txt", "# nothing\n", "no depth images");
  }
  void whatCannotBeOpenedIsRefusedByName() {
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    QFETCH(QString, complaint);
    const TemporaryFolder folder;
    folder.write("depth/1.png", depthPng(1));
    folder.write(name, bytes);
    const QString message = errorOf([&] { open(folder); });
    COMPARE_CONTAINS(message, QString::fromStdString(folder.path().string()));
    COMPARE_CONTAINS(message, complaint);
  }

  void emptyAndAbsentFoldersAreRefused() {
    const TemporaryFolder folder;
    COMPARE_CONTAINS(errorOf([&] { open(folder); }), QString("no depth images"));
    COMPARE_CONTAINS(errorOf([&] { openDepthSource(folder.path("none"), ""); }),
                     QString("no such folder"));
  }

  void badImagesAreBadFramesAndTheNextOneIsRead_data() {
    const auto row = faultRows();
    row("empty", "depth/2.png", "", "empty");
    row("not an image", "depth/2.png", "hello", "not a PNG");
    row("truncated", "depth/2.png", depthPng(7, {64, 48}).left(60), "damaged");
    row("wrong size", "depth/2.png", depthPng(7, {5, 3}), "5 x 3");
    row("eight bits", "depth/2.png", png(cv::Mat(3, 4, CV_8UC1, cv::Scalar(3))), "16 bits");
    row("colour instead", "depth/2.png", colourPng(1), "16 bits");
    row("colour of other size", "colour/2.png", colourPng(1, {8, 6}), "8 x 6");
    QByteArray bomb = depthPng(7);
    bomb.replace(16, 8, QByteArray::fromHex("0000ffff0000ffff"));
    row("claims four billion pixels", "depth/2.png", bomb, "65535 x 65535");
    row("jpeg that claims four billion", "colour/2.png",
        QByteArray::fromHex("ffd8ffe0000400 00ffc0001108ffffffff03"), "65535 x 65535");
    row("jpeg without a frame", "colour/2.png", QByteArray::fromHex("ffd8ffd9"), "not a PNG");
  }
  void badImagesAreBadFramesAndTheNextOneIsRead() {
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    QFETCH(QString, complaint);
    const TemporaryFolder folder;
    folder.write("intrinsics.yaml", intrinsics);
    for (const char* k : {"1", "2", "3"}) {
      folder.write(QString("depth/%1.png").arg(k), depthPng(2000));
      folder.write(QString("colour/%1.png").arg(k), colourPng(1));
    }
    folder.write(name, bytes);
    const auto source = open(folder);
    QVERIFY(source->next(patience).status == ReadResult::Status::Ok);
    const QString message = badMessage(source->next(patience));
    COMPARE_CONTAINS(message, QString::fromStdString(folder.path(name).string()));
    COMPARE_CONTAINS(message, complaint);
    const ReadResult third = source->next(patience);
    QVERIFY(third.status == ReadResult::Status::Ok);
    QCOMPARE(third.frame->sequence, std::uint64_t(2));
  }

  void aDepthImageThatIsGoneIsABadFrame() {
    const TemporaryFolder folder;
    folder.write("depth.txt", "1 gone.png\n2 here.png\n");
    folder.write("here.png", depthPng(5000));
    const auto source = open(folder);
    COMPARE_CONTAINS(badMessage(source->next(patience)), QString("gone.png"));
    QVERIFY(source->next(patience).status == ReadResult::Status::Ok);
  }

  void theRecordedKinectSequenceIsReadAsItsNotesSay() {
    const QString folder = sharedData("rgbd_static_person_uva");
    REQUIRE_DATA(folder);
    const auto source = openDepthSource(folder.toStdString(), "");
    const std::size_t count = source->info().frameCount.value();
    QVERIFY(count >= 60);
    for (const std::size_t k : {std::size_t(0), count - 1}) {
      QVERIFY(source->seek(k));
      const FramePtr frame = source->next(patience).frame;
      QVERIFY(frame);
      QCOMPARE(frame->left.size(), cv::Size(640, 480));
      const std::string name = QString("%1_depth.png").arg(k, 10, 10, QChar('0')).toStdString();
      const cv::Mat depth = cv::imread(folder.toStdString() + "/" + name, cv::IMREAD_UNCHANGED);
      std::size_t measured = 0;
      for (int v = 0; v < 480; ++v) {
        for (int u = 0; u < 640; ++u) {
          const auto& p = frame->cloud->at(u, v);
          const float z = depth.at<std::uint16_t>(v, u) / 1000.0F;
          QCOMPARE(isMeasured(p), z > 0.0F);
          if (z <= 0.0F) continue;
          ++measured;
          const Eigen::Vector3f wanted((u - 320) * z / 525.0F, (v - 240) * z / 525.0F, z);
          QVERIFY((p - wanted).norm() < 1e-5F);
        }
      }
      QVERIFY(measured > 640 * 480 / 2);
    }
  }
};

BOOMWATCH_TEST(TestDepthSource)
#include "test_depth_source.moc"
