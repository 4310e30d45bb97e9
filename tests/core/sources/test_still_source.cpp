#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include "open_source.h"
#include "pipeline/pipeline.h"
#include "sources/frame_source.h"
#include "support/compare_near.h"
#include "support/flat_scene.h"
#include "support/test_registry.h"

using namespace boomwatch;

namespace {

constexpr std::chrono::milliseconds patience{0};

/// A wall at 3 m as an ASCII PCD.
void writeWall(const QString& path) {
  const auto cloud = test::wallCloud(3.0F);
  QByteArray text = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n";
  text += "WIDTH 160\nHEIGHT 160\nPOINTS 25600\nDATA ascii\n";
  for (const auto& p : cloud->points) {
    text += QByteArray::number(p.x()) + ' ' + QByteArray::number(p.y()) + ' ' +
            QByteArray::number(p.z()) + '\n';
  }
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
}

}  // namespace

class TestStillSource : public QObject {
  Q_OBJECT
 private slots:
  void aSingleCloudIsMeasured();
  void itCanBeSoughtAndEnds();
  void aSequenceIsLeftAsItIs();
  void aSingleBadFileSaysSoAndEnds();
};

void TestStillSource::aSingleCloudIsMeasured() {
  const QTemporaryDir folder;
  writeWall(folder.filePath("wall.pcd"));
  const auto source = openSource("cloud:" + folder.filePath("wall.pcd").toStdString());
  Parameters parameters = test::smallParameters();
  test::hangLoad(parameters, 1.5);
  Pipeline pipeline;
  Result result;
  std::size_t frames = 0;
  for (ReadResult read = source->next(patience); read.frame; read = source->next(patience)) {
    result = pipeline.process(read.frame, parameters);
    ++frames;
  }
  QCOMPARE(frames, std::size_t{20});
  QVERIFY(result.clearance.nearest);
  BW_COMPARE_NEAR(result.clearance.nearest->distance, 1.3, result.clearance.nearest->quantisation);
}

void TestStillSource::itCanBeSoughtAndEnds() {
  const QTemporaryDir folder;
  writeWall(folder.filePath("wall.pcd"));
  const auto source = openSource("cloud:" + folder.filePath("wall.pcd").toStdString());
  QVERIFY(source->seek(19));
  QVERIFY(!source->seek(20));
  const ReadResult last = source->next(patience);
  QCOMPARE(last.frame->sequence, std::uint64_t{19});
  QVERIFY(last.frame->still);
  QVERIFY(source->next(patience).status == ReadResult::Status::End);
}

void TestStillSource::aSequenceIsLeftAsItIs() {
  const QTemporaryDir folder;
  writeWall(folder.filePath("1.pcd"));
  writeWall(folder.filePath("2.pcd"));
  const auto source = openSource("cloud:" + folder.path().toStdString());
  QCOMPARE(source->info().frameCount.value_or(0), std::size_t{2});
  QVERIFY(!source->next(patience).frame->still);
}

void TestStillSource::aSingleBadFileSaysSoAndEnds() {
  const QTemporaryDir folder;
  QFile file(folder.filePath("bad.pcd"));
  QVERIFY(file.open(QIODevice::WriteOnly) && file.write("rubbish") > 0);
  file.close();
  try {
    const auto source = openSource("cloud:" + file.fileName().toStdString());
    std::size_t bad = 0;
    for (ReadResult read = source->next(patience); read.status != ReadResult::Status::End;
         read = source->next(patience)) {
      QVERIFY(read.status == ReadResult::Status::Bad &&
              read.message.find("bad.pcd") != std::string::npos);
      QVERIFY(++bad <= 1);
    }
  } catch (const std::exception& fault) {
    QVERIFY(QByteArray(fault.what()).contains("bad.pcd"));
  }
}

BOOMWATCH_TEST(TestStillSource)
#include "test_still_source.moc"
