#include <QtTest>

#include "sources/cloud_source.h"
#include "sources/file_sequence.h"
#include "support/compare_near.h"
#include "support/real_data.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

constexpr std::chrono::milliseconds patience{100};

QByteArray onePoint(int z) {
  return "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n0 0 " +
         QByteArray::number(z) + "\n";
}

float depthOf(const ReadResult& read) { return read.frame->cloud->points.at(0).z(); }

}  // namespace

class TestCloudSource : public QObject {
  Q_OBJECT
 private slots:
  void aFolderIsReadInNaturalOrder() {
    const TemporaryFolder folder;
    for (const int k : {1, 2, 10, 9}) folder.write(QString("f%1.PCD").arg(k), onePoint(k));
    folder.write("notes.txt", "not a cloud");
    const auto source = openCloudSource(folder.path(), "cloud:here");
    QCOMPARE(QString::fromStdString(source->info().address), QString("cloud:here"));
    QCOMPARE(source->info().frameCount, std::optional<std::size_t>(4));
    QVERIFY(!source->info().live);
    std::uint64_t sequence = 0;
    for (const float z : {1.0F, 2.0F, 9.0F, 10.0F}) {
      const ReadResult read = source->next(patience);
      QCOMPARE(depthOf(read), z);
      QCOMPARE(read.frame->stamp, 0.1 * double(sequence));
      QCOMPARE(read.frame->sequence, sequence++);
      QVERIFY(read.frame->left.empty());
    }
    QVERIFY(source->next(patience).status == ReadResult::Status::End);
    QVERIFY(source->seek(2));
    QCOMPARE(depthOf(source->next(patience)), 9.0F);
    QVERIFY(!source->seek(4));
    QCOMPARE(depthOf(source->next(patience)), 10.0F);
  }

  void oneFileIsASourceOfOneFrame() {
    const TemporaryFolder folder;
    const auto source = openCloudSource(folder.write("a.pcd", onePoint(3)), "");
    QCOMPARE(source->info().frameCount, std::optional<std::size_t>(1));
    QCOMPARE(depthOf(source->next(patience)), 3.0F);
    QVERIFY(source->next(patience).status == ReadResult::Status::End);
  }

  void aBadFileAmidOthersIsABadFrameThatNamesIt() {
    const TemporaryFolder folder;
    folder.write("1.pcd", onePoint(1));
    const auto bad = folder.write("2.pcd", onePoint(2).left(60));
    folder.write("3.pcd", onePoint(3));
    const auto source = openCloudSource(folder.path(), "");
    QCOMPARE(depthOf(source->next(patience)), 1.0F);
    const ReadResult read = source->next(patience);
    QVERIFY(read.status == ReadResult::Status::Bad);
    QVERIFY(!read.frame);
    COMPARE_CONTAINS(QString::fromStdString(read.message), QString::fromStdString(bad.string()));
    QCOMPARE(depthOf(source->next(patience)), 3.0F);
  }

  void whatHoldsNoCloudIsRefusedAtOnce() {
    const TemporaryFolder folder;
    COMPARE_CONTAINS(errorOf([&] { openCloudSource(folder.path(), ""); }), QString("no .pcd"));
    COMPARE_CONTAINS(errorOf([&] { openCloudSource(folder.path("none.pcd"), ""); }),
                     QString("none.pcd"));
    const auto file = folder.write("bad.pcd", "rubbish");
    COMPARE_CONTAINS(errorOf([&] { openCloudSource(file, ""); }), QString("bad.pcd"));
  }

  void stampsComeFromNamesThatAreTimes_data() {
    QTest::addColumn<QString>("stem");
    QTest::addColumn<double>("stamp");
    QTest::newRow("seconds") << "1305031102.175304" << 1305031102.175304;
    QTest::newRow("nanoseconds") << "1403636579763555584" << 1403636579.763555584;
    QTest::newRow("microseconds") << "1403636579763555" << 1403636579.763555;
    QTest::newRow("date") << "frame_20121214T142255.814212" << 1355494975.814212;
    QTest::newRow("epoch") << "19700101T000000" << 0.0;
    for (const char* stem :
         {"", "0000000012", "12", "f12", "1.5", "20121399T142255", "20121214T992255", "20121214",
          "1305031102.17.5", "12345678901234567"}) {
      QTest::addRow("not a time: %s", stem) << stem << -1.0;
    }
  }
  void stampsComeFromNamesThatAreTimes() {
    QFETCH(QString, stem);
    QFETCH(double, stamp);
    const auto got = stampFromName(stem.toStdString());
    QCOMPARE(got.has_value(), stamp >= 0.0);
    if (got) BW_COMPARE_NEAR(*got, stamp, 1e-5);
  }

  void stampsThatDoNotGrowAreNotBelieved() {
    QCOMPARE(stampsOf({"1305031102.5.pcd", "1305031103.5.pcd"}, 10.0),
             (std::vector<double>{1305031102.5, 1305031103.5}));
    QCOMPARE(stampsOf({"1305031102.5.pcd", "1305031102.50.pcd"}, 10.0),
             (std::vector<double>{0.0, 0.1}));
    QCOMPARE(stampsOf({"1305031102.5.pcd", "b.pcd"}, 10.0), (std::vector<double>{0.0, 0.1}));
  }

  void naturalOrderCountsAsPeopleDo() {
    QVERIFY(naturalOrder("f9", "f10"));
    QVERIFY(!naturalOrder("f10", "f9"));
    QVERIFY(naturalOrder("f9a", "f9b"));
    QVERIFY(naturalOrder("f", "f0"));
    QVERIFY(naturalOrder("1-2", "1-10"));
    QVERIFY(naturalOrder("99999999999999999999998", "99999999999999999999999"));
    QVERIFY(naturalOrder("01", "1") != naturalOrder("1", "01"));
    QVERIFY(!naturalOrder("same", "same"));
  }

  void aRecordedSequenceHasItsClocksStamps() {
    const QString folder = sharedData("pcd_organised_pcl");
    REQUIRE_DATA(folder);
    const std::vector<std::filesystem::path> grabs{
        (folder + "/frame_20121214T142255.814212.pcd").toStdString(),
        (folder + "/frame_20121214T142256.068683.pcd").toStdString()};
    const auto stamps = stampsOf(grabs, 10.0);
    BW_COMPARE_NEAR(stamps[1] - stamps[0], 0.254471, 1e-5);
    const auto source = openCloudSource(folder.toStdString(), "");
    QCOMPARE(source->info().frameCount, std::optional<std::size_t>(7));
    int coloured = 0;
    for (int k = 0; k < 7; ++k) {
      const ReadResult read = source->next(patience);
      QVERIFY(read.status == ReadResult::Status::Ok);
      QVERIFY(read.frame->cloud->organised());
      coloured += read.frame->left.size() == cv::Size(640, 480);
    }
    QCOMPARE(coloured, 6);  // all but person.pcd
  }
};

BOOMWATCH_TEST(TestCloudSource)
#include "test_cloud_source.moc"
