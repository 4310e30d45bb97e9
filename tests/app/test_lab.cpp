#include <QProcess>
#include <QtTest>

#include "support/build_paths.h"
#include "support/test_registry.h"

/// The commands of boomwatch-lab, and what boomwatch answers to those that it had itself.
class TestLab : public QObject {
  Q_OBJECT

  struct Run {
    int exitCode = -1;
    QByteArray output, errors;
  };
  static Run run(const char* program, const QStringList& arguments) {
    QProcess process;
    process.start(builtProgram(program), arguments);
    if (!process.waitForFinished(60000)) {
      process.kill();
      process.waitForFinished();
    }
    const bool normal = process.exitStatus() == QProcess::NormalExit;
    return {normal ? process.exitCode() : -1, process.readAllStandardOutput(),
            process.readAllStandardError()};
  }

 private slots:
  void whatMovedNamesItsPlace_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("place");
    const auto row = [](const char* name, const QStringList& arguments, const char* place) {
      QTest::newRow(name) << arguments << QByteArray(place);
    };
    const char* const report = "boomwatch-lab experiments --output REPORT";
    row("experiments", {"--experiments", "--output", "x"}, report);
    row("sequences", {"--headless", "--sequences", "3"}, report);
    row("hours", {"--hours=3"}, report);
    row("only", {"--only", "gap"}, report);
    row("tracking", {"--tracking", "x"}, report);
    row("bench", {"--bench", "x"}, report);
    row("a command", {"experiments"}, report);
    row("evaluate", {"--evaluate", "tracking", "x"}, "boomwatch-lab evaluate FOLDER");
    row("absences", {"--headless", "--absences", "2"}, "boomwatch-lab evaluate FOLDER");
    row("evaluate, a command", {"evaluate", "x"}, "boomwatch-lab evaluate FOLDER");
    row("export", {"--export-demo", "yard"}, "boomwatch-lab export DEMO --output FOLDER");
    row("images", {"--export-truth-images"}, "--truth-images");
    row("export, a command", {"export", "yard"}, "boomwatch-lab export DEMO --output FOLDER");
  }
  void whatMovedNamesItsPlace() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, place);
    const Run result = run("boomwatch", arguments);
    QCOMPARE(result.exitCode, 2);
    QVERIFY2(result.errors.contains(place), result.errors);
    QVERIFY(result.output.isEmpty());
  }

  void badArgumentsExitWithTwo_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("named");
    const auto row = [](const char* name, const QStringList& arguments, const char* named) {
      QTest::newRow(name) << arguments << QByteArray(named);
    };
    row("nothing", {}, "export, evaluate or experiments");
    row("unknown command", {"dance"}, "'dance'");
    row("unknown option", {"--dance"}, "dance");
    row("option of another command", {"export", "yard", "--hours", "3"}, "hours");
    row("option before the command", {"--frames", "3", "export"}, "frames");
    row("unknown document", {"--print", "poem"}, "'poem'");
    row("document of boomwatch", {"--print", "schema"}, "'schema'");
  }
  void badArgumentsExitWithTwo() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, named);
    const Run result = run("boomwatch-lab", arguments);
    QCOMPARE(result.exitCode, 2);
    QVERIFY2(result.errors.contains(named), result.errors);
    QVERIFY(result.output.isEmpty());
  }

  void everyCommandHasItsHelp_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("named");
    QTest::newRow("none") << QStringList{"--help"} << QByteArray("boomwatch-lab evaluate FOLDER");
    QTest::newRow("short") << QStringList{"-h"} << QByteArray("depth_noise");
    QTest::newRow("export") << QStringList{"export", "--help"} << QByteArray("--truth-images");
    QTest::newRow("evaluate") << QStringList{"evaluate", "--help"} << QByteArray("--absences N");
    QTest::newRow("experiments") << QStringList{"experiments", "-h"} << QByteArray("--hours H");
  }
  void everyCommandHasItsHelp() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, named);
    const Run result = run("boomwatch-lab", arguments);
    QCOMPARE(result.exitCode, 0);
    QVERIFY2(result.output.contains(named), result.output);
  }

  void bothProgramsHaveOneVersion() {
    const QByteArray lab = run("boomwatch-lab", {"--version"}).output;
    QVERIFY2(lab.startsWith("boomwatch-lab "), lab);
    QCOMPARE("boomwatch " + lab.mid(14), run("boomwatch", {"--version"}).output);
  }
};

BOOMWATCH_TEST(TestLab)
#include "test_lab.moc"
