#include <QJsonArray>
#include <QTemporaryDir>
#include <QtTest>

#include "support/build_paths.h"
#include "support/program_run.h"
#include "support/test_registry.h"

namespace {

/// A post of the demo stands in 590,180,40,120.
ProgramRun demo(const QStringList& more) {
  return runProgram(QStringList{"--source", "demo:cylinders", "--frames", "8"} + more);
}

QJsonObject toolOf(const ProgramRun& run, qsizetype line) {
  return run.lines[line]["tool"].toObject();
}

}  // namespace

/// The program without a window follows a tool, as a script would have it do.
class TestHeadlessTool : public QObject {
  Q_OBJECT

 private slots:
  void withoutAToolItIdles() {
    const ProgramRun run = demo({});
    QCOMPARE(run.exitCode, 0);
    const QJsonObject tool = toolOf(run, 7);
    QCOMPARE(tool["state"].toString(), QStringLiteral("idle"));
    for (const char* key : {"box", "confidence", "pixel", "point", "velocity", "age_s"}) {
      QVERIFY2(tool.contains(key) && tool[key].isNull(), key);
    }
  }

  void aBoxIsFollowed_data() {
    QTest::addColumn<QString>("tracker");
    for (const char* name : {"tld", "klt", "csrt"}) QTest::newRow(name) << QString(name);
  }

  void aBoxIsFollowed() {
    QFETCH(QString, tracker);
    const ProgramRun run = demo({"--track", "590,180,40,120", "--tracker", tracker});
    QCOMPARE(run.exitCode, 0);
    const QJsonObject tool = toolOf(run, 7);
    QCOMPARE(tool["state"].toString(), QStringLiteral("tracked"));
    QCOMPARE(tool["box"].toArray().size(), 4);
    QVERIFY(tool["confidence"].toDouble() > 0.0);
    QCOMPARE(tool["pixel"].toArray().size(), 2);
    QCOMPARE(tool["point"].toArray().size(), 3);
    QCOMPARE(tool["velocity"].toArray().size(), 3);
    QCOMPARE(tool["age_s"].toDouble(-1.0), 0.0);
    QVERIFY(run.lines[7]["timings_ms"].toObject().contains("tool"));
  }

  void aBoxThatDoesNotFitGivesNoDistance() {
    const ProgramRun run = demo({"--track", "5000,10,60,60"});
    QCOMPARE(run.exitCode, 1);
    QVERIFY(run.errors.contains("reaches outside the picture"));
    QCOMPARE(run.errors.count('\n'), 1);
    QCOMPARE(run.lines.size(), 8);
    for (const QJsonObject& line : run.lines) {
      QCOMPARE(line["reason"].toString(), QStringLiteral("tool_lost"));
      QVERIFY(line["distance_m"].isNull());
    }
  }

  void aModelIsSavedAndFoundByAgain() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("known.tool"), other = folder.filePath("other.tool");
    const QStringList save{"--track", "590,180,40,120", "--save-tracker-model"};
    QCOMPARE(demo(save + QStringList(file)).exitCode, 0);
    QVERIFY(QFile::exists(file));
    QCOMPARE(demo(save + QStringList(other)).exitCode, 0);
    const ProgramRun run =
        demo({"--tracker-model", file, "--tracker-model", other, "--learn", "off"});
    QCOMPARE(run.exitCode, 0);
    QVERIFY(!toolOf(run, 7)["box"].isNull());
    QCOMPARE(toolOf(run, 7)["learning"].toString(), QStringLiteral("off"));
  }

  void nothingLearntIsNothingToSave() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("none.tool");
    const ProgramRun run = demo({"--save-tracker-model", file});
    QCOMPARE(run.exitCode, 1);
    QVERIFY(run.errors.contains(file.toLocal8Bit()));
    QVERIFY(!QFile::exists(file));
  }

  void badValuesExitWithTwo_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("names");
    const auto row = [](const char* name, const QStringList& arguments, const char* names) {
      QTest::newRow(name) << arguments << QByteArray(names);
    };
    row("three numbers", {"--track", "1,2,3"}, "--track");
    row("a word", {"--track", "1,2,3,x"}, "--track");
    row("an empty box", {"--track", "10,10,0,0"}, "--track");
    row("one pixel", {"--track", "10,10,1,1"}, "--track");
    row("outside to the left", {"--track", "-5,10,60,60"}, "--track");
    row("no such tracker", {"--tracker", "goturn"}, "goturn");
    row("neither on nor off", {"--learn", "maybe"}, "--learn");
    row("no such model", {"--tracker-model", "/there/is/no.tool"}, "/there/is/no.tool");
    row("a model that is none", {"--tracker-model", builtProgram("boomwatch")}, "app/boomwatch");
    row("a model for klt", {"--tracker", "klt", "--tracker-model", "a.tool"}, "--tracker-model");
    row("klt saves none", {"--tracker", "klt", "--save-tracker-model", "a.tool"}, "tld");
    row("a box by hand", {"--tracker", "manual", "--track", "1,1,60,60"}, "--track");
    row("two beginnings", {"--tool", "3,3", "--track", "1,1,60,60"}, "--tool");
  }

  void badValuesExitWithTwo() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, names);
    const ProgramRun run = demo(arguments);
    QCOMPARE(run.exitCode, 2);
    QVERIFY2(run.errors.contains(names), run.errors.constData());
    QVERIFY(run.lines.isEmpty());
  }
};

BOOMWATCH_TEST(TestHeadlessTool)
#include "test_headless_tool.moc"
