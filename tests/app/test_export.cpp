#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <csignal>

#include "support/build_paths.h"
#include "support/test_registry.h"

/// Exports a demo with the program itself.
class TestExport : public QObject {
  Q_OBJECT

  static void start(QProcess& process, const QStringList& arguments) {
    process.start(builtProgram("boomwatch-lab"), QStringList{"export"} + arguments);
  }
  static int codeOf(QProcess& process) {
    if (!process.waitForFinished(120000)) process.kill();
    return process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
  }

 private slots:
  void whatIsExportedCanBeRun() {
    const QTemporaryDir folder;
    const QString yard = folder.filePath("yard");
    QProcess exporting;
    start(exporting, {"yard", "--frames", "2", "--output", yard});
    QCOMPARE(codeOf(exporting), 0);
    QVERIFY(exporting.readAllStandardError().contains("frame 2 of 2"));
    QProcess running;
    running.start(builtProgram("boomwatch"), {"--headless", "--source", "stereo:" + yard});
    QCOMPARE(codeOf(running), 0);
    QCOMPARE(running.readAllStandardOutput().count('\n'), 2);
  }

  void anInterruptLeavesNothing() {
    const QTemporaryDir folder;
    QProcess process;
    start(process, {"floor", "--output", folder.filePath("floor")});
    process.setReadChannel(QProcess::StandardError);
    QByteArray said = process.readAllStandardError();
    while (!said.contains("frame 2 of") && process.waitForReadyRead(60000)) {
      said += process.readAllStandardError();
    }
    // Of a process that has ended the number is 0, and 0 would be our own group.
    const auto running = static_cast<pid_t>(process.processId());
    QVERIFY2(running > 0, said);
    ::kill(running, SIGINT);
    QCOMPARE(codeOf(process), 1);
    QVERIFY(process.readAllStandardError().contains("stopped"));
    QVERIFY(QDir(folder.path()).isEmpty());
  }

  void badArgumentsExitWithTwo_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("named");
    QTest::newRow("no folder") << QStringList{"yard"} << QByteArray("--output");
    QTest::newRow("no demo") << QStringList{"--output", "x"} << QByteArray("export DEMO");
    QTest::newRow("no such demo") << QStringList{"roof", "--output", "x"} << QByteArray("roof");
    QTest::newRow("seed") << QStringList{"yard,seed=-1", "--output", "x"}
                          << QByteArray("0..999999");
    QTest::newRow("no frames") << QStringList{"yard", "--frames", "0", "--output", "x"}
                               << QByteArray("--frames");
    QTest::newRow("too many") << QStringList{"yard", "--frames", "12001", "--output", "x"}
                              << QByteArray("1..12000");
    QTest::newRow("not empty") << QStringList{"floor", "--output", "/usr"} << QByteArray("/usr");
  }
  void badArgumentsExitWithTwo() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, named);
    const QTemporaryDir folder;
    QProcess process;
    process.setWorkingDirectory(folder.path());
    start(process, arguments);
    QCOMPARE(codeOf(process), 2);
    const QByteArray said = process.readAllStandardError();
    QVERIFY2(said.contains(named), said.constData());
    QVERIFY(QDir(folder.path()).isEmpty());
  }
};

BOOMWATCH_TEST(TestExport)
#include "test_export.moc"
