#include <sys/resource.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <csignal>
#include <opencv2/imgcodecs.hpp>

#include "frame/stereo_rig.h"
#include "open_source.h"
#include "simulation/demo_export.h"
#include "sources/frame_source.h"
#include "support/temporary_file.h"
#include "support/test_registry.h"
#include "support/yard_frames.h"

using namespace boomwatch;

namespace {

bool goOn(std::size_t, std::size_t) { return true; }

QList<QJsonObject> truthLines(const std::filesystem::path& folder) {
  QFile file(QString::fromStdString((folder / "truth.jsonl").string()));
  QList<QJsonObject> lines;
  if (!file.open(QIODevice::ReadOnly)) return lines;
  while (!file.atEnd()) lines << QJsonDocument::fromJson(file.readLine()).object();
  return lines;
}

Eigen::Vector3d vectorIn(const QJsonValue& value) {
  return {value[0].toDouble(), value[1].toDouble(), value[2].toDouble()};
}

QStringList namesIn(const std::filesystem::path& folder) {
  return QDir(QString::fromStdString(folder.string()))
      .entryList(QDir::AllEntries | QDir::NoDotAndDotDot, QDir::Name);
}

/// No file may grow above a limit: what a full disk does, without one.
class SmallFiles {
 public:
  explicit SmallFiles(rlim_t most) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &m_before);
    const rlimit limit{most, m_before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SmallFiles() { setrlimit(RLIMIT_FSIZE, &m_before); }

 private:
  rlimit m_before{};
};

}  // namespace

class TestDemoExport : public QObject {
  Q_OBJECT

  YardFrames m_frames;

 private slots:
  void aYardComesBackAsItWas() {
    const TemporaryFolder temporary;
    const auto folder = temporary.path("yard");
    QVERIFY(exportDemo({"yard,rain=0.3", 3, folder, true}, goOn));
    QCOMPARE(namesIn(folder), QStringList({"calibration.yaml", "left", "right", "timestamps.txt",
                                           "truth", "truth.jsonl"}));
    const auto source = openSource("stereo:" + folder.string());
    QCOMPARE(source->info().frameCount, std::optional<std::size_t>(3));
    const auto lines = truthLines(folder);
    QCOMPARE(lines.size(), 3);
    for (std::size_t k = 0; k < 3; ++k) {
      const YardFrame shown = m_frames.withTruth("rain=0.3", k);
      const FramePtr &wanted = shown.frame, got = source->next({}).frame;
      QVERIFY(got && samePicture(got->left, wanted->left));
      QVERIFY(samePicture(got->right, wanted->right));
      QCOMPARE(got->stamp, wanted->stamp);
      QVERIFY(got->rig->rectified);
      QVERIFY(cv::norm(got->rig->leftMatrix - wanted->rig->leftMatrix) < 1e-12);
      QVERIFY(cv::norm(got->rig->translation - wanted->rig->translation) < 1e-12);
      QCOMPARE(got->rig->imageSize, wanted->left.size());
      const YardTruth& truth = *shown.truth;
      const QJsonObject line = lines[int(k)];
      QCOMPARE(line["frame"].toInt(), int(k));
      QCOMPARE(line["distance_m"].toDouble(), *wanted->trueDistance);
      QCOMPARE(vectorIn(line["load"]["centre"]), truth.load.centre);
      QCOMPARE(vectorIn(line["load"]["axes"][1]), Eigen::Vector3d(truth.load.rotation.col(1)));
      QCOMPARE(vectorIn(line["tool"]["point"]), truth.toolPoint);
      QCOMPARE(line["tool"]["box"][2].toInt(), truth.toolBox.width);
      QCOMPARE(vectorIn(line["nearest"]["on_load"]), truth.nearest.pair.onA);
      QCOMPARE(line["person"]["distance_m"].toDouble(), truth.person->pair.distance);
    }
  }

  void truthImagesAreWhatIsTrue() {
    const TemporaryFolder temporary;
    const auto folder = temporary.path("yard");
    QVERIFY(exportDemo({"yard", 1, folder, true}, goOn));
    const YardFrame shown = m_frames.withTruth("", 0);
    const YardTruth& truth = *shown.truth;
    const auto read = [&](const char* name) {
      return cv::imread((folder / "truth" / name / "000000.png").string(), cv::IMREAD_UNCHANGED);
    };
    QVERIFY(samePicture(read("kind"), truth.kind));
    const cv::Mat depth = read("depth"), disparity = read("disparity"), wanted = truth.disparity();
    for (int v = 0; v < depth.rows; v += 7) {
      for (int u = 0; u < depth.cols; u += 7) {
        const float z = truth.depth.at<float>(v, u);
        const auto millimetres = depth.at<std::uint16_t>(v, u);
        QVERIFY(std::isnan(z) ? millimetres == 0 : std::abs(z * 1000.0F - millimetres) < 0.51F);
        const auto parts = disparity.at<std::uint16_t>(v, u);
        QVERIFY(std::isnan(z) ? parts == 0
                              : std::abs(wanted.at<float>(v, u) * 256.0F - parts) < 0.51F);
      }
    }
  }

  void theOtherDemosComeBackAsDepth() {
    const TemporaryFolder temporary;
    const auto folder = temporary.path("cylinders");
    QVERIFY(exportDemo({"cylinders", 2, folder, false}, goOn));
    const auto source = openSource("depth:" + folder.string());
    const auto demo = openSource("demo:cylinders");
    for (int k = 0; k < 2; ++k) {
      const FramePtr got = source->next({}).frame, wanted = demo->next({}).frame;
      QVERIFY(got && got->cloud->width == wanted->cloud->width);
      for (std::size_t i = 0; i < got->cloud->size(); ++i) {
        const Eigen::Vector3f &a = got->cloud->points[i], &b = wanted->cloud->points[i];
        QCOMPARE(isMeasured(a), isMeasured(b));
        if (isMeasured(a)) QVERIFY((a - b).norm() < 0.001F);
      }
      QCOMPARE(truthLines(folder)[k]["distance_m"].toDouble(), *wanted->trueDistance);
    }
  }

  void whatIsStoppedLeavesNothing() {
    const TemporaryFolder temporary;
    const auto folder = temporary.path("floor");
    QVERIFY(!exportDemo({"floor", 5, folder, false},
                        [](std::size_t done, std::size_t) { return done < 2; }));
    QVERIFY(namesIn(temporary.path()).isEmpty());
  }

  void aFullDiskLeavesNothing() {
    const TemporaryFolder temporary;
    const auto folder = temporary.path("floor");
    std::string message;
    {
      const SmallFiles limit(20000);
      try {
        exportDemo({"floor", 2, folder, false}, goOn);
      } catch (const std::runtime_error& fault) {
        message = fault.what();
      }
    }
    COMPARE_CONTAINS(QString::fromStdString(message), "floor.partial/colour/000000.png");
    COMPARE_CONTAINS(QString::fromStdString(message), "cannot be written");
    QVERIFY(namesIn(temporary.path()).isEmpty());
  }

  void whatIsThereIsNotTouched() {
    const TemporaryFolder temporary;
    temporary.write("full/mine.txt", "mine");
    temporary.write("file", "mine");
    temporary.write("half.partial/mine.txt", "mine");
    for (const char* name : {"full", "file", "half"}) {
      const QString message = errorOf([&] {
        exportDemo({"floor", 1, temporary.path(name), false}, goOn);
      });
      COMPARE_CONTAINS(message, name);
    }
    COMPARE_CONTAINS(errorOf([] {
                       exportDemo({"floor", 1, "/proc/floor", false}, goOn);
                     }),
                     "/proc/floor");
    QCOMPARE(namesIn(temporary.path()), QStringList({"file", "full", "half.partial"}));
    QCOMPARE(namesIn(temporary.path("full")), QStringList({"mine.txt"}));
  }

  void anEmptyFolderIsFilled() {
    const TemporaryFolder temporary;
    QDir().mkpath(QString::fromStdString(temporary.path("floor").string()));
    QVERIFY(exportDemo({"floor", 1, temporary.path("floor/"), false}, goOn));
    QVERIFY(namesIn(temporary.path("floor")).contains("truth.jsonl"));
  }

  void whatCannotBeIsRefused() {
    const TemporaryFolder temporary;
    const auto folder = temporary.path("new");
    const auto refused = [&](const std::string& demo, std::size_t frames) {
      return errorOf([&] { exportDemo({demo, frames, folder, false}, goOn); });
    };
    COMPARE_CONTAINS(refused("roof", 1), "demo:roof");
    COMPARE_CONTAINS(refused("yard", 12001), "1..12000");
    COMPARE_CONTAINS(refused("yard,frames=5", 6), "6 frames");
    COMPARE_CONTAINS(refused("wall", 601), "601 frames");
    COMPARE_CONTAINS(errorOf([] { exportDemo({"wall", 1, "", false}, goOn); }), "--output");
    QVERIFY(namesIn(temporary.path()).isEmpty());
  }
};

BOOMWATCH_TEST(TestDemoExport)
#include "test_demo_export.moc"
