#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>
#include <sys/stat.h>

#include <random>

#include "sources/cloud_file.h"
#include "support/real_data.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

pcl::PointCloud<pcl::PointXYZRGBL> randomCloud(unsigned width, unsigned height) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> coordinate(-5.0F, 5.0F);
  pcl::PointCloud<pcl::PointXYZRGBL> cloud(width, height);
  for (std::size_t k = 0; k < cloud.size(); ++k) {
    auto& p = cloud[k];
    p.x = k % 7 == 3 ? std::numeric_limits<float>::quiet_NaN() : coordinate(random);
    p.y = coordinate(random);
    p.z = coordinate(random);
    p.r = static_cast<std::uint8_t>(random());
    p.g = static_cast<std::uint8_t>(random());
    p.b = static_cast<std::uint8_t>(random());
    p.a = 255;
    p.label = k % 5;
  }
  cloud.is_dense = false;
  return cloud;
}

/// Bit for bit, but for points of which PCL keeps a part that was measured.
template <class P>
void compareWithPcl(const Cloud& cloud, const pcl::PointCloud<P>& peer, float tolerance) {
  QCOMPARE(cloud.width, int(peer.width));
  QCOMPARE(cloud.height, int(peer.height));
  QCOMPARE(cloud.points.size(), peer.size());
  std::size_t measured = 0;
  for (std::size_t k = 0; k < peer.size(); ++k) {
    const Eigen::Vector3f wanted = peer[k].getVector3fMap();
    const bool finite = wanted.allFinite() && !wanted.isZero(0.0F);
    if (isMeasured(cloud.points[k]) != finite ||
        (finite && (cloud.points[k] - wanted).cwiseAbs().maxCoeff() > tolerance)) {
      QFAIL(qPrintable(QString("point %1 differs").arg(k)));
    }
    measured += finite;
  }
  QVERIFY(measured > 0);
}

const QByteArray header =
    "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
    "WIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\n";

QByteArray replaced(QByteArray text, const char* from, const char* to) {
  return text.replace(from, to);
}

}  // namespace

class TestCloudFile : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() { pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); }

  void pcdsThatPclWritesAreReadAsPclReadsThem_data() {
    QTest::addColumn<int>("encoding");
    QTest::newRow("ascii") << 0;
    QTest::newRow("binary") << 1;
    QTest::newRow("compressed") << 2;
  }
  void pcdsThatPclWritesAreReadAsPclReadsThem() {
    QFETCH(int, encoding);
    const TemporaryFolder folder;
    const std::string file = folder.path("cloud.pcd").string();
    const auto cloud = randomCloud(40, 30);
    pcl::PCDWriter writer;
    if (encoding == 0) writer.writeASCII(file, cloud, 9);
    if (encoding == 1) writer.writeBinary(file, cloud);
    if (encoding == 2) writer.writeBinaryCompressed(file, cloud);
    const CloudFile read = readCloudFile(file);
    compareWithPcl(*read.cloud, cloud, 1e-6F);
    QCOMPARE(read.image.type(), CV_8UC3);
    QCOMPARE(read.image.size(), cv::Size(40, 30));
    for (int k = 0; k < 1200; ++k) {
      const auto& p = cloud[std::size_t(k)];
      QCOMPARE(read.image.at<cv::Vec3b>(k / 40, k % 40), cv::Vec3b(p.b, p.g, p.r));
      QCOMPARE(read.labels[std::size_t(k)], p.label);
    }
  }

  void pliesThatPclWritesAreReadAsPclReadsThem_data() {
    QTest::addColumn<bool>("binary");
    QTest::newRow("ascii") << false;
    QTest::newRow("binary") << true;
  }
  void pliesThatPclWritesAreReadAsPclReadsThem() {
    QFETCH(bool, binary);
    const TemporaryFolder folder;
    const std::string file = folder.path("cloud.ply").string();
    pcl::PointCloud<pcl::PointXYZ> cloud;
    for (const auto& p : randomCloud(100, 1)) {
      if (std::isfinite(p.x)) cloud.push_back({p.x, p.y, p.z});
    }
    pcl::PLYWriter().write(file, cloud, binary, false);
    compareWithPcl(*readCloudFile(file).cloud, cloud, 1e-4F);
  }

  void bigEndianDoublesAndListsAfterTheVerticesAreRead() {
    QByteArray bytes =
        "ply\r\nformat binary_big_endian 1.0\r\nelement other 2\r\nproperty short a\r\n"
        "element vertex 1\r\nproperty double x\r\nproperty float y\r\nproperty int z\r\n"
        "element face 1\r\nproperty list uchar int vertex_indices\r\nend_header\r\n";
    bytes += QByteArray::fromHex(
        "00010002"
        "3ff8000000000000"
        "c0000000"
        "00000007"
        "00");
    const TemporaryFolder folder;
    const CloudFile read = readCloudFile(folder.write("a.ply", bytes));
    QCOMPARE(read.cloud->points.at(0), Eigen::Vector3f(1.5F, -2.0F, 7.0F));
  }

  void aPlyOfARangeGridIsOrganised() {
    const TemporaryFolder folder;
    const CloudFile read = readCloudFile(folder.write(
        "a.ply",
        "ply\nformat ascii 1.0\nobj_info num_cols 2\nobj_info num_rows 2\nelement vertex 4\n"
        "property float x\nproperty float y\nproperty float z\nproperty uchar red\n"
        "property uchar green\nproperty uchar blue\nend_header\n"
        "1 2 3 10 20 30\n4 5 6 0 0 0\n0 0 0 0 0 0\nnan 1 1 255 254 253\n"));
    QCOMPARE(read.cloud->width, 2);
    QCOMPARE(read.cloud->height, 2);
    QCOMPARE(read.cloud->at(1, 0), Eigen::Vector3f(4, 5, 6));
    QVERIFY(!isMeasured(read.cloud->at(0, 1)));
    QVERIFY(!isMeasured(read.cloud->at(1, 1)));
    QCOMPARE(read.image.at<cv::Vec3b>(0, 0), cv::Vec3b(30, 20, 10));
  }

  void doublesIntegersAndExtraFieldsAreRead() {
    const TemporaryFolder folder;
    const CloudFile read = readCloudFile(folder.write(
        "a.pcd",
        "FIELDS z histogram x y\nSIZE 8 4 2 1\nTYPE F F I U\nCOUNT 1 3 1 1\nWIDTH 1\nHEIGHT 1\n"
        "POINTS 1\nDATA ascii\n\n2.5 0 0 0 -300 200\n"));
    QCOMPARE(read.cloud->points.at(0), Eigen::Vector3f(-300.0F, 200.0F, 2.5F));
  }

  void aPointWithAnyCoordinateMissingIsUnmeasured() {
    const TemporaryFolder folder;
    const CloudFile read =
        readCloudFile(folder.write("a.pcd", header + "DATA ascii\nnan nan nan\n1 inf 1e300\n"));
    QCOMPARE(read.cloud->size(), std::size_t(2));
    for (const auto& p : read.cloud->points) QVERIFY(p.array().isNaN().all());
  }

  void whatCannotBeTrueIsRefusedByName_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("complaint");
    const QByteArray text = header + "DATA ascii\n1 2 3\n4 5 6\n";
    const auto pcd = [&](const char* row, const QByteArray& bytes, const char* complaint) {
      QTest::newRow(row) << "bad.pcd" << bytes << complaint;
    };
    const auto changed = [&](const char* row, const char* from, const char* to,
                             const char* complaint) {
      pcd(row, replaced(text, from, to), complaint);
    };
    pcd("empty", "", "empty");
    pcd("not a header", "hello\n", "line 1");
    pcd("binary rubbish", QByteArray(5000, '\xfe'), "header");
    pcd("truncated in the header", header, "no DATA line");
    pcd("truncated in the text", header + "DATA ascii\n1 2 3\n", "truncated");
    pcd("truncated in the bytes", header + "DATA binary\n" + QByteArray(23, 'a'), "truncated");
    changed("four billion points", "WIDTH 2\nHEIGHT 1", "WIDTH 65536\nHEIGHT 65536", "50000000");
    changed("more points than bytes", "WIDTH 2\nHEIGHT 1\n", "WIDTH 40000000\nHEIGHT 1\n",
            "POINTS is not WIDTH times HEIGHT");
    pcd("more points than bytes, agreed",
        replaced(replaced(text, "WIDTH 2", "WIDTH 40000000"), "POINTS 2", "POINTS 40000000"),
        "truncated");
    changed("width and points differ", "POINTS 2", "POINTS 3", "WIDTH times HEIGHT");
    changed("overflowing product", "HEIGHT 1", "HEIGHT 9223372036854775809", "more than");
    changed("negative width", "WIDTH 2", "WIDTH -2", "line 7");
    changed("no points", "WIDTH 2", "WIDTH 0", "no points");
    changed("negative count", "COUNT 1 1 1", "COUNT 1 -1 1", "COUNT");
    changed("huge count", "COUNT 1 1 1", "COUNT 1 4294967295 1", "COUNT");
    changed("no z", "FIELDS x y z", "FIELDS x y w", "x, y and z");
    changed("unequal lists", "SIZE 4 4 4", "SIZE 4 4", "equally long");
    changed("size zero", "SIZE 4 4 4", "SIZE 4 0 4", "SIZE");
    changed("half floats", "SIZE 4 4 4", "SIZE 4 2 4", "SIZE");
    changed("unknown type", "TYPE F F F", "TYPE F X F", "TYPE");
    changed("unknown encoding", "DATA ascii", "DATA gzip", "DATA");
    changed("too few numbers", "4 5 6", "4.00 5.00", "line 13");
    changed("not a number", "4 5 6", "4 five 6", "line 13");
    const auto sizes = [](quint32 packed, quint32 unpacked) {
      QByteArray b(8, 0);
      memcpy(b.data(), &packed, 4);
      memcpy(b.data() + 4, &unpacked, 4);
      return header + "DATA binary_compressed\n" + b;
    };
    pcd("compressed, no sizes", header + "DATA binary_compressed\n123", "truncated");
    pcd("compressed, truncated", sizes(10, 24) + "123", "truncated");
    pcd("compressed, wrong size", sizes(3, 25) + "123", "unpacked size");
    pcd("compressed, damaged", sizes(3, 24) + "\xff\xff\xff", "damaged");
    const QByteArray bomb =
        replaced(replaced(sizes(3, 480000000) + "123", "WIDTH 2", "WIDTH 40000000"), "POINTS 2",
                 "POINTS 40000000");
    pcd("compressed, bomb", bomb, "too short");
    QTest::newRow("ply without end") << "bad.ply" << QByteArray("ply\nformat ascii 1.0\n") << "end";
    QTest::newRow("ply of four billion")
        << "bad.ply"
        << QByteArray(
               "ply\nformat ascii 1.0\nelement vertex 4294967296\nproperty float x\n"
               "property float y\nproperty float z\nend_header\n1 2 3\n")
        << "50000000";
    QTest::newRow("ply truncated")
        << "bad.ply"
        << QByteArray(
               "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\n"
               "property float y\nproperty float z\nend_header\n12345678901234567890123")
        << "truncated";
    QTest::newRow("ply negative count")
        << "bad.ply" << QByteArray("ply\nformat ascii 1.0\nelement vertex -1\nend_header\n")
        << "line 3";
    QTest::newRow("ply without vertices")
        << "bad.ply" << QByteArray("ply\nformat ascii 1.0\nend_header\n") << "vertex";
    QTest::newRow("other file") << "bad.txt" << QByteArray("1 2 3\n") << "not a cloud";
  }
  void whatCannotBeTrueIsRefusedByName() {
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    QFETCH(QString, complaint);
    const TemporaryFolder folder;
    const auto file = folder.write(name, bytes);
    const QString message = errorOf([&] { readCloudFile(file); });
    COMPARE_CONTAINS(message, QString::fromStdString(file.string()));
    COMPARE_CONTAINS(message, complaint);
  }

  void absentFilesFoldersAndPipesAreRefused() {
    const TemporaryFolder folder;
    COMPARE_CONTAINS(errorOf([&] { readCloudFile(folder.path("none.pcd")); }), QString("no such"));
    std::filesystem::create_directory(folder.path("folder.pcd"));
    COMPARE_CONTAINS(errorOf([&] { readCloudFile(folder.path("folder.pcd")); }),
                     QString("ordinary"));
    QCOMPARE(mkfifo(folder.path("pipe.pcd").c_str(), 0600), 0);
    COMPARE_CONTAINS(errorOf([&] { readCloudFile(folder.path("pipe.pcd")); }), QString("ordinary"));
  }

  void recordedCloudsAreReadAsPclReadsThem_data() {
    QTest::addColumn<QString>("file");
    for (const char* file :
         {"pcd_labelled_mosd/learn0.pcd", "pcd_labelled_mosd/test3.pcd",
          "pcd_organised_pcl/office1.pcd", "pcd_organised_pcl/person.pcd",
          "pcd_organised_pcl/table_scene_mug_stereo_textured.pcd",
          "lidar_seq_street_udacity/0000000000.pcd", "terrain_isprs_als/samp11-utm.pcd"}) {
      QTest::newRow(file) << file;
    }
  }
  void recordedCloudsAreReadAsPclReadsThem() {
    QFETCH(QString, file);
    REQUIRE_DATA(sharedData(file));
    const std::string path = sharedData(file).toStdString();
    pcl::PointCloud<pcl::PointXYZ> peer;
    QVERIFY(pcl::io::loadPCDFile(path, peer) == 0);
    compareWithPcl(*readCloudFile(path).cloud, peer, 0.0F);
  }

  void recordedDoublesAreReadInMetres() {
    const QString file = sharedData("pcd_boxes_oakd/example_1.ply");
    REQUIRE_DATA(file);
    const CloudFile read = readCloudFile(file.toStdString());
    QCOMPARE(read.cloud->size(), std::size_t(20055));
    QVERIFY(read.image.empty());
    for (const auto& p : read.cloud->points) QVERIFY(p.z() > -2.0F && p.z() < -0.8F);
  }

  void recordedLabelsBelongToMeasuredPoints() {
    const QString file = sharedData("pcd_labelled_mosd/learn0.pcd");
    REQUIRE_DATA(file);
    const CloudFile read = readCloudFile(file.toStdString());
    QCOMPARE(read.labels.size(), read.cloud->size());
    std::size_t agreed = 0;
    for (std::size_t k = 0; k < read.labels.size(); ++k) {
      agreed += (read.labels[k] == 0) == !isMeasured(read.cloud->points[k]);
    }
    QCOMPARE(agreed, read.labels.size());
  }
};

BOOMWATCH_TEST(TestCloudFile)
#include "test_cloud_file.moc"
