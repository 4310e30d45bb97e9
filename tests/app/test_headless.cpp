#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QtMath>
#include <QtTest>
#include <cmath>

#include "parameters/parameter_table.h"
#include "support/build_paths.h"
#include "support/compare_near.h"
#include "support/test_registry.h"

/// Runs the program itself, as a person or a script would.
class TestHeadless : public QObject {
  Q_OBJECT
 private slots:
  void writesOneLineAFrame();
  void writesToAFile();
  void theDemosAgreeWithTheirTruth_data();
  void theDemosAgreeWithTheirTruth();
  void loadAndSettingsAreUsed();
  void theLastSettingWins();
  void helpNamesEveryParameter();
  void badArgumentsExitWithTwo_data();
  void badArgumentsExitWithTwo();
  void aFaultInTheRunExitsWithOne();
  void warnsOfAProbtreshThatLetsNothingThrough();
  void savesTheWholeWindow();

 private:
  struct Run {
    int exitCode = -1;
    QByteArray output;
    QByteArray errors;
  };
  static Run run(const QStringList& arguments);
  static QList<QJsonObject> lines(const QByteArray& output);
};

TestHeadless::Run TestHeadless::run(const QStringList& arguments) {
  QProcess process;
  process.start(builtProgram("boomwatch"), arguments);
  if (!process.waitForFinished(120000)) {
    process.kill();
    process.waitForFinished();
    return {};
  }
  const bool normal = process.exitStatus() == QProcess::NormalExit;
  return {normal ? process.exitCode() : -1, process.readAllStandardOutput(),
          process.readAllStandardError()};
}

QList<QJsonObject> TestHeadless::lines(const QByteArray& output) {
  QList<QJsonObject> objects;
  for (const QByteArray& line : output.split('\n')) {
    if (!line.isEmpty()) objects << QJsonDocument::fromJson(line).object();
  }
  return objects;
}

void TestHeadless::writesOneLineAFrame() {
  const Run result = run({"--headless", "--source", "demo:floor", "--frames", "7"});
  QCOMPARE(result.exitCode, 0);
  const auto objects = lines(result.output);
  QCOMPARE(objects.size(), 7);
  for (const char* key : {"frame", "stamp", "state", "reason", "distance_m", "nearest", "on_load",
                          "level", "observed_share", "timings_ms"}) {
    QVERIFY2(objects.constLast().contains(QLatin1String(key)), key);
  }
  // Three frames are too few for a model (Eq. 22-23): no number, and the reason.
  QVERIFY(objects[2]["distance_m"].isNull());
  QCOMPARE(objects[2]["state"].toString(), QStringLiteral("unknown"));
  QCOMPARE(objects[2]["reason"].toString(), QStringLiteral("no_model_yet"));
  QCOMPARE(objects[2]["level"].toString(), QStringLiteral("no_distance"));
  QCOMPARE(objects[6]["state"].toString(), QStringLiteral("measured"));
  QCOMPARE(objects[6]["nearest"].toArray().size(), 3);
  QVERIFY(objects[6]["timings_ms"].toObject().contains("model"));
}

void TestHeadless::writesToAFile() {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("results.jsonl"));
  const Run result =
      run({"--headless", "--source", "demo:floor", "--frames", "2", "--output", file});
  QCOMPARE(result.exitCode, 0);
  QVERIFY(result.output.isEmpty());
  QFile written(file);
  QVERIFY(written.open(QIODevice::ReadOnly));
  QCOMPARE(lines(written.readAll()).size(), 2);
}

void TestHeadless::theDemosAgreeWithTheirTruth_data() {
  QTest::addColumn<QString>("source");
  QTest::newRow("floor") << "demo:floor";
  QTest::newRow("cylinders") << "demo:cylinders";
}

/// Never longer than the truth by more than the quantisation says, except for what 2.5-D cannot
/// see, which the observed share then admits.
void TestHeadless::theDemosAgreeWithTheirTruth() {
  QFETCH(QString, source);
  const Run result = run({"--headless", "--source", source, "--frames", "200"});
  QCOMPARE(result.exitCode, 0);
  int measured = 0;
  QList<double> errors;
  for (const QJsonObject& line : lines(result.output)) {
    if (line["state"].toString() != QLatin1String("measured")) continue;
    ++measured;
    errors << line["distance_m"].toDouble() - line["truth_m"].toDouble();
  }
  QVERIFY(measured > 150);
  std::sort(errors.begin(), errors.end());
  qInfo("%s: error median %.3f, smallest %.3f, largest %.3f m", qPrintable(source),
        errors[errors.size() / 2], errors.constFirst(), errors.constLast());
  BW_COMPARE_NEAR(errors[errors.size() / 2], 0.0, 0.08);
}

void TestHeadless::loadAndSettingsAreUsed() {
  // The ground, y cos 20 + z sin 20 = 3.6 m, is nearest where the bounds cut it off: at the row of
  // cells in which y is 2.19 m. The load reaches to y = 0.25 m and 0.25 m beyond its own z.
  const double y = 2.19, angle = qDegreesToRadians(20.0);
  const double z = (3.6 - y * std::cos(angle)) / std::sin(angle);
  for (const double loadZ : {2.0, 1.0}) {
    const Run result = run({"--headless", "--source", "demo:floor", "--frames", "5", "--load",
                            QStringLiteral("0,0,%1,0.5,0.5,0.5,0,0,0").arg(loadZ)});
    QCOMPARE(result.exitCode, 0);
    BW_COMPARE_NEAR(lines(result.output).constLast()["distance_m"].toDouble(),
                    std::hypot(y - 0.25, z - loadZ - 0.25), 0.05);
  }
}

void TestHeadless::theLastSettingWins() {
  const Run result = run({"--headless", "--source", "demo:floor", "--frames", "4", "--set",
                          "probtresh=0.6", "--set", "probtresh=0.15"});
  // At 0.15 the first frame suffices.
  QVERIFY2(!lines(result.output).isEmpty(), result.errors.constData());
  QCOMPARE(lines(result.output).constFirst()["state"].toString(), QStringLiteral("measured"));
}

void TestHeadless::helpNamesEveryParameter() {
  const Run result = run({"--help"});
  QCOMPARE(result.exitCode, 0);
  for (const auto& info : boomwatch::parameterTable()) {
    QVERIFY2(result.output.contains(QByteArray(info.key.data(), qsizetype(info.key.size()))),
             info.key.data());
  }
}

void TestHeadless::badArgumentsExitWithTwo_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QByteArray>("named");
  const auto row = [](const char* name, const QStringList& arguments, const char* named) {
    QTest::newRow(name) << QStringList{"--headless"} + arguments << QByteArray(named);
  };
  row("unknown option", {"--nonsense"}, "nonsense");
  row("unknown key", {"--set", "resolutoin=1"}, "'resolution'");
  row("no value", {"--set", "resolution"}, "resolution");
  row("out of range", {"--set", "resolution=5"}, "resolution");
  row("not a number", {"--set", "resolution=nan"}, "resolution");
  row("minimum above maximum", {"--set", "x_min=20"}, "x_min");
  row("too much memory", {"--set", "resolution=0.001"}, "memory_limit");
  row("load with eight values", {"--load", "0,0,1,1,1,1,0,0"}, "--load");
  row("load with a word", {"--load", "0,0,1,1,big,1,0,0,0"}, "load_size_y");
  row("negative load", {"--load", "0,0,1,1,-1,1,0,0,0"}, "load_size_y");
  row("tool", {"--tool", "12"}, "--tool");
  row("frames", {"--frames", "0"}, "--frames");
  row("missing folder", {"--source", "stereo:absent/folder"}, "absent/folder");
  row("missing cloud", {"--source", "cloud:absent.pcd"}, "absent.pcd");
  row("unknown demo", {"--source", "demo:ocean"}, "ocean");
  row("unknown kind", {"--source", "smell:here"}, "smell");
  row("missing preset", {"--parameters", "absent.yaml"}, "absent.yaml");
  row("stray word", {"recording"}, "recording");
  row("output nowhere", {"--source", "demo:floor", "--output", "absent/folder/x"}, "absent/folder");
}

void TestHeadless::badArgumentsExitWithTwo() {
  QFETCH(QStringList, arguments);
  QFETCH(QByteArray, named);
  const Run result = run(arguments);
  QCOMPARE(result.exitCode, 2);
  QVERIFY2(result.errors.contains(named), result.errors);
}

void TestHeadless::aFaultInTheRunExitsWithOne() {
  const QTemporaryDir folder;
  for (const char* name : {"0.pcd", "1.pcd", "2.pcd"}) {
    QFile file(folder.filePath(QLatin1String(name)));
    QVERIFY(file.open(QIODevice::WriteOnly));
    const bool bad = name[0] == '1';
    file.write(bad ? "rubbish"
                   : "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n"
                     "COUNT 1 1 1\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\n"
                     "DATA ascii\n0 0 2\n0.1 0 2\n");
  }
  const Run result = run({"--headless", "--source", "cloud:" + folder.path()});
  QCOMPARE(result.exitCode, 1);
  QVERIFY2(result.errors.contains("1.pcd"), result.errors);
  const auto objects = lines(result.output);
  QCOMPARE(objects.size(), 3);
  QCOMPARE(objects[1]["reason"].toString(), QStringLiteral("unreadable_frame"));
}

void TestHeadless::warnsOfAProbtreshThatLetsNothingThrough() {
  const Run result =
      run({"--headless", "--source", "demo:floor", "--frames", "1", "--set", "probtresh=0.67"});
  QCOMPARE(result.exitCode, 0);
  QVERIFY2(result.errors.contains("no object enters the model"), result.errors);
}

void TestHeadless::savesTheWholeWindow() {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("window.png"));
  const Run result =
      run({"--headless", "--source", "demo:floor", "--frames", "5", "--screenshot", file});
  QCOMPARE(result.exitCode, 0);
  const QImage image(file);
  QVERIFY(image.width() >= 800 && image.height() >= 600);
}

BOOMWATCH_TEST(TestHeadless)
#include "test_headless.moc"
