#include <QImage>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>

#include "support/program_run.h"
#include "support/test_registry.h"

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

/// Bad input, end to end: the program as a person starts it, its exit code and what it says. Each
/// case leads to a message that names the thing, or to a state that says why there is no distance.
class TestBadInput : public QObject {
  Q_OBJECT

 private slots:
  void recordings_data();
  void recordings();
  void framesOfARecording_data();
  void framesOfARecording();
  void calibrations_data();
  void calibrations();
  void parameters_data();
  void parameters();
  void presets_data();
  void presets();
  void aLoadOutsideTheBoundsHasNoDistance();
  void aFullDiskIsAFaultOfTheRun();
  void aPictureThatCannotBeWrittenIsAFaultOfTheRun();

 private:
  QString path(const QString& name) const { return m_folder.filePath(name); }
  QString write(const QString& name, const QByteArray& bytes) const {
    return writeFile(path(name), bytes);
  }
  QString writePairs(const QString& name, const QByteArray& calibration) const;

  QTemporaryDir m_folder;
};

namespace {

constexpr QSize pictureSize(160, 120);

QByteArray matrix(const QByteArray& key, int rows, int columns, const QByteArray& data) {
  return key + ": !!opencv-matrix\n   rows: " + QByteArray::number(rows) +
         "\n   cols: " + QByteArray::number(columns) + "\n   dt: d\n   data: [" + data + "]\n";
}

struct Calibration {
  QByteArray focalLength = "100.";
  QByteArray translation = "-0.2, 0., 0.";
  QByteArray left = "M1";

  QByteArray text() const {
    const QByteArray camera = focalLength + ", 0., 80., 0., " + focalLength + ", 60., 0., 0., 1.";
    const QByteArray none = "0., 0., 0., 0., 0.";
    return "%YAML:1.0\n---\nimage_width: 160\nimage_height: 120\n" + matrix(left, 3, 3, camera) +
           matrix("D1", 1, 5, none) + matrix("M2", 3, 3, camera) + matrix("D2", 1, 5, none) +
           matrix("R", 3, 3, "1., 0., 0., 0., 1., 0., 0., 0., 1.") + matrix("T", 3, 1, translation);
  }
};

/// A picture of random texture, moved to the left by `disparity`.
QImage texture(int disparity, int frame) {
  QImage image(pictureSize, QImage::Format_Grayscale8);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const auto hash =
          static_cast<quint32>(x + disparity) * 73856093U ^ static_cast<quint32>(y) * 19349663U;
      image.scanLine(y)[x] = static_cast<uchar>((hash * 2654435761U) >> 24);
    }
  }
  image.scanLine(0)[frame] = static_cast<uchar>(~image.scanLine(0)[frame]);  // no two alike
  return image;
}

}  // namespace

/// Eight pairs of a wall, 20 m / 8 = 2.5 m away, and a calibration.
QString TestBadInput::writePairs(const QString& name, const QByteArray& calibration) const {
  for (const char* half : {"left", "right"}) {
    QDir().mkpath(path(name + '/' + half));
    for (int i = 0; i < 8; ++i) {
      texture(half[0] == 'l' ? 0 : 8, i).save(path(QString("%1/%2/%3.png").arg(name, half).arg(i)));
    }
  }
  if (!calibration.isEmpty()) write(name + "/calibration.yaml", calibration);
  return path(name);
}

void TestBadInput::recordings_data() {
  QTest::addColumn<QString>("address");
  QTest::addColumn<QByteArray>("named");
  const auto row = [](const char* name, const QString& address, const char* named) {
    QTest::newRow(name) << address << QByteArray(named);
  };
  row("missing folder, stereo", "stereo:" + path("absent"), "absent: there is no such folder");
  row("missing folder, cloud", "cloud:" + path("absent"),
      "absent: there is no such file or folder");
  row("missing folder, depth", "depth:" + path("absent"), "absent: there is no such folder");
  row("no path, stereo", "stereo:", "stereo:: no path is given");
  row("no path, cloud", "cloud:", "cloud:: no path is given");
  row("no path, depth", "depth:", "depth:: no path is given");
  QDir().mkpath(path("empty folder ä"));
  row("empty folder", "cloud:" + path("empty folder ä"), "empty folder \xC3\xA4: there is no .pcd");
  const QString unequal = writePairs("unequal", Calibration{}.text());
  QFile::remove(unequal + "/right/7.png");
  row("unequal counts", "stereo:" + unequal, "8 left and 7 right pictures");
  row("empty PCD", "cloud:" + write("empty.pcd", ""), "empty.pcd: the file is empty");
  row("PCD without points", "cloud:" + write("none.pcd", pcdHeader(0, 0, "ascii")), "no points");
  row("truncated PCD", "cloud:" + write("cut.pcd", pcdHeader(200, 200, "binary") + "abc"),
      "cut.pcd: its header claims 480000 bytes");
  row("PCD of 4 billion points", "cloud:" + write("huge.pcd", pcdHeader(4000000000, 1, "binary")),
      "huge.pcd: it claims more than");
  row("rubbish", "cloud:" + write("rubbish.pcd", QByteArray(5000, '\xEE')), "rubbish.pcd, line 1");
  QDir().mkpath(path("folder.pcd"));
  row("a folder with a file's name", "cloud:" + path("folder.pcd"), "folder.pcd: there is no .pcd");
  row("a device", "cloud:/dev/zero", "/dev/zero: not a cloud");
  QFile::link(path("loop.pcd"), path("loop.pcd"));
  row("a link to itself", "cloud:" + path("loop.pcd"), "loop.pcd: there is no such file");
  write("rubbish/calibration.yaml", Calibration{}.text());
  write("rubbish/left.mp4", QByteArray(5000, '\xEE'));
  write("rubbish/right.mp4", QByteArray(5000, '\xEE'));
  row("a video of rubbish", "stereo:" + path("rubbish"), "left.mp4: this is not a video");
  row("a camera that is not there", "camera:1,2", "need a calibration");
  row("an unknown kind", "smell:here", "'smell:here'");
#ifdef Q_OS_UNIX
  mkfifo(qPrintable(path("pipe.pcd")), 0600);
  row("a pipe as cloud", "cloud:" + path("pipe.pcd"), "pipe.pcd: this is not an ordinary file");
  write("pipes/calibration.yaml", Calibration{}.text());
  mkfifo(qPrintable(path("pipes/left.mp4")), 0600);
  mkfifo(qPrintable(path("pipes/right.mp4")), 0600);
  row("pipes as videos", "stereo:" + path("pipes/left.mp4") + ',' + path("pipes/right.mp4"),
      "left.mp4: this is not an ordinary file");
#endif
}

void TestBadInput::recordings() {
  QFETCH(QString, address);
  QFETCH(QByteArray, named);
  const ProgramRun result = runWithLoad(address);
  QCOMPARE(result.exitCode, 2);
  QVERIFY2(result.errors.contains(named), result.errors);
  QVERIFY(result.lines.isEmpty());
}

void TestBadInput::framesOfARecording_data() {
  QTest::addColumn<QString>("address");
  QTest::addColumn<int>("exitCode");
  QTest::addColumn<int>("frame");
  QTest::addColumn<QString>("reason");
  QTest::addColumn<QByteArray>("named");
  const QString pair = writePairs("unreadable", Calibration{}.text());
  write("unreadable/left/5.png", "rubbish");
  QTest::newRow("unreadable image")
      << "stereo:" + pair << 1 << 5 << "unreadable_frame" << QByteArray("left/5.png");
  const QString sizes = writePairs("sizes", Calibration{}.text());
  for (const char* half : {"left", "right"}) {
    texture(0, 0).scaled(80, 60).save(sizes + '/' + half + "/5.png");
  }
  QTest::newRow("wrong size in mid-sequence")
      << "stereo:" + sizes << 1 << 5 << "unreadable_frame"
      << QByteArray("pair 6: the pictures changed from 160 x 120 to 80 x 60");
  for (int i = 0; i < 8; ++i) {
    const auto wall = [i](int, int) { return unsteady(3.0F, i); };
    writeCloud(path(QString("nan/%1.pcd").arg(i)), [&](int x, int y) {
      return i < 5 ? wall(x, y) : std::numeric_limits<float>::quiet_NaN();
    });
    writeCloud(path(QString("cut/%1.pcd").arg(i)), wall);
    writeCloud(path(QString("frozen/%1.pcd").arg(i)), [](int, int) { return 3.0F; });
  }
  QTest::newRow("NaN everywhere") << "cloud:" + path("nan") << 0 << 5 << "few_depth_pixels"
                                  << QByteArray();
  write("cut/5.pcd", pcdHeader(cloudSide, cloudSide, "binary") + "abc");
  QTest::newRow("truncated PCD in mid-sequence")
      << "cloud:" + path("cut") << 1 << 5 << "unreadable_frame" << QByteArray("5.pcd");
  QTest::newRow("a frozen picture")
      << "cloud:" + path("frozen") << 0 << 5 << "identical_frames" << QByteArray();
}

void TestBadInput::framesOfARecording() {
  QFETCH(QString, address);
  QFETCH(int, exitCode);
  QFETCH(int, frame);
  QFETCH(QString, reason);
  QFETCH(QByteArray, named);
  const ProgramRun result = runWithLoad(address);
  QCOMPARE(result.exitCode, exitCode);
  QVERIFY2(result.errors.contains(named), result.errors);
  QCOMPARE(result.lines.size(), 8);
  if (reason != QLatin1String("identical_frames")) {
    QCOMPARE(result.lines[4]["state"].toString(), QStringLiteral("measured"));
  }
  QCOMPARE(result.lines[frame]["reason"].toString(), reason);
  QVERIFY(result.lines[frame]["distance_m"].isNull());
  QCOMPARE(result.lines[frame]["level"].toString(), QStringLiteral("no_distance"));
}

void TestBadInput::calibrations_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QByteArray>("named");
  QTest::newRow("missing key") << Calibration{.left = "M7"}.text() << QByteArray("the key M1");
  QTest::newRow("zero focal length")
      << Calibration{.focalLength = "0."}.text() << QByteArray("focal length that is zero");
  QTest::newRow("focal length in millimetres")
      << Calibration{.focalLength = "3.6"}.text() << QByteArray("not in millimetres");
  QTest::newRow("swapped baseline") << Calibration{.translation = "0.2, 0., 0."}.text()
                                    << QByteArray("Left and right are swapped");
  QTest::newRow("baseline in millimetres")
      << Calibration{.translation = "-200., 0., 0."}.text() << QByteArray("must be in metres");
  QTest::newRow("no baseline") << Calibration{.translation = "0., 0., 0."}.text()
                               << QByteArray("baseline that is zero");
  QTest::newRow("no number") << Calibration{.translation = ".nan, 0., 0."}.text()
                             << QByteArray("T ");
  QTest::newRow("another size") << Calibration{}.text().replace("160", "320")
                                << QByteArray("the calibration is for 320 x 120");
  QTest::newRow("rubbish") << QByteArray(5000, '\0') << QByteArray("not a text file");
  QTest::newRow("empty") << QByteArray("\n") << QByteArray("this is empty");
}

void TestBadInput::calibrations() {
  QFETCH(QByteArray, text);
  QFETCH(QByteArray, named);
  const QString pairs = writePairs("pairs", {});
  const QString file = write("given calibration.yaml", text);
  const ProgramRun result = runWithLoad("stereo:" + pairs, {"--calibration", file});
  QCOMPARE(result.exitCode, 2);
  QVERIFY2(result.errors.contains(named), result.errors);
  // The same pictures with a calibration that fits: what failed is what was said.
  write("given calibration.yaml", Calibration{}.text());
  QCOMPARE(runWithLoad("stereo:" + pairs, {"--calibration", file}).exitCode, 0);
}

void TestBadInput::parameters_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QByteArray>("named");
  const auto row = [](const char* name, const QStringList& settings, const char* named) {
    QStringList arguments;
    for (const QString& setting : settings) arguments << "--set" << setting;
    QTest::newRow(name) << arguments << QByteArray(named);
  };
  row("unknown key", {"resolutoin=1"}, "Did you mean 'resolution'");
  row("out of range", {"resolution=5"}, "'5' is not among 0.001 to 1 m");
  row("not a number", {"resolution=nan"}, "'nan' is not among");
  row("no value", {"resolution"}, "'resolution' is not a key, '=' and a value");
  row("no key", {"=5"}, "'=5' is not a key");
  row("min >= max", {"x_min=5", "x_max=5"}, "'x_min' and 'x_max': 5 is not below 5");
  row("too much memory", {"resolution=0.001"}, "1150 MB, more than memory_limit (1024 MB)");
  row("a division by zero in the matcher", {"stereo_uniqueness=100"}, "stereo_uniqueness");
  row("a block that sgbm refuses", {"stereo_block_size=51"}, "sgbm takes at most 15");
  row("a leave threshold above the other", {"model_update=hysteresis", "leave_threshold=0.6"},
      "'leave_threshold' and 'probtresh': 0.6 is not below 0.5");
  row("a reprojection out of the bounds", {"z_reprojection=11"}, "z_max (10)");
  for (const char* load : {"nan,0,2,1,1,1,0,0,0", "0,0,2,1e308,1,1,0,0,0", "0,0,2,0,1,1,0,0,0"}) {
    QTest::addRow("load %s", load) << QStringList{"--load", load} << QByteArray("is not among");
  }
  for (const char* frames : {"-1", "0", "99999999999999999999", "few"}) {
    QTest::addRow("frames %s", frames) << QStringList{"--frames", frames} << QByteArray("--frames");
  }
}

void TestBadInput::parameters() {
  QFETCH(QStringList, arguments);
  QFETCH(QByteArray, named);
  const ProgramRun result = runProgram(QStringList{"--source", "demo:floor"} + arguments);
  QCOMPARE(result.exitCode, 2);
  QVERIFY2(result.errors.contains(named), result.errors);
}

void TestBadInput::presets_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QByteArray>("named");
  QTest::newRow("unknown key") << QByteArray("resolutoin: 1\n") << QByteArray("line 1: parameter");
  QTest::newRow("out of range") << QByteArray("\nresolution: 5\n") << QByteArray("line 2");
  QTest::newRow("min >= max") << QByteArray("x_min: 5\nx_max: -5\n") << QByteArray("x_min");
  QTest::newRow("a list") << QByteArray("resolution: [1, 2]\n") << QByteArray("a list");
  QTest::newRow("deep") << "resolution: " + QByteArray(100000, '[') << QByteArray("not YAML");
  QTest::newRow("rubbish") << QByteArray(5000, '\xEE') << QByteArray("preset.yaml");
  QTest::newRow("empty") << QByteArray() << QByteArray("the file is empty");
}

void TestBadInput::presets() {
  QFETCH(QByteArray, text);
  QFETCH(QByteArray, named);
  const QString file = write("preset.yaml", text);
  const ProgramRun result = runProgram({"--source", "demo:floor", "--parameters", file});
  QCOMPARE(result.exitCode, 2);
  QVERIFY2(result.errors.contains("preset.yaml"), result.errors);
  QVERIFY2(result.errors.contains(named), result.errors);
}

void TestBadInput::aLoadOutsideTheBoundsHasNoDistance() {
  const ProgramRun result =
      runProgram({"--source", "demo:floor", "--frames", "6", "--load", "0,0,20,1,1,1,0,0,0"});
  QCOMPARE(result.exitCode, 0);
  QCOMPARE(result.lines.constLast()["reason"].toString(), QStringLiteral("load_outside_bounds"));
  QVERIFY(result.lines.constLast()["distance_m"].isNull());
}

void TestBadInput::aFullDiskIsAFaultOfTheRun() {
  if (!QFile::exists("/dev/full")) QSKIP("no device that is always full");
  const ProgramRun result =
      runProgram({"--source", "demo:floor", "--frames", "3", "--output", "/dev/full"});
  QCOMPARE(result.exitCode, 1);
  QVERIFY2(result.errors.contains("/dev/full"), result.errors);
}

void TestBadInput::aPictureThatCannotBeWrittenIsAFaultOfTheRun() {
  const ProgramRun result = runProgram({"--source", "demo:floor", "--frames", "3", "--screenshot",
                                        path("absent/folder/window.png")});
  QCOMPARE(result.exitCode, 1);
  QVERIFY2(result.errors.contains("window.png: cannot be written"), result.errors);
}

BOOMWATCH_TEST(TestBadInput)
#include "test_bad_input.moc"
