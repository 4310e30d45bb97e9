#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <csignal>

#include "support/build_paths.h"
#include "support/test_registry.h"
#include "support/tracking_folder.h"

/// boomwatch-lab experiments, run as a person would.
class TestExperiments : public QObject {
  Q_OBJECT

  struct Run {
    int exitCode = -1;
    QByteArray errors;
  };

  static Run run(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments);
    // Just before QtTest would give up, which waits longer with sanitizers (tests/CMakeLists.txt).
    const int limit = qEnvironmentVariableIntValue("QTEST_FUNCTION_TIMEOUT");
    if (!process.waitForFinished(limit > 0 ? limit / 6 * 5 : 500000)) {
      process.kill();
      process.waitForFinished();
      return {-1, "ended because it took too long"};
    }
    const bool normal = process.exitStatus() == QProcess::NormalExit;
    return {normal ? process.exitCode() : -1, process.readAllStandardError()};
  }
  static Run run(const QStringList& arguments) {
    return run(builtProgram("boomwatch-lab"), QStringList{"experiments"} + arguments);
  }
  static QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  static void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), qint64(bytes.size()));
  }
  QString path(const QString& name) const { return m_folder->filePath(name); }

  std::unique_ptr<QTemporaryDir> m_folder;

 private slots:
  void init() { m_folder = std::make_unique<QTemporaryDir>(); }

  void aWholeReport() {
    boomwatch::test::writePictures(path("one"), 6);
    write(path("one/groundtruth_rect.txt"), boomwatch::test::sizeLines(6));
    write(path("bench.json"),
          R"([{"name": "octomap_insertion_4cm", "value": 2345.6, "unit": "ms", "bar": "-"}])");
    const Run result = run({"--sequences", "1", "--frames", "14", "--hours", "0.0003", "--output",
                            path("new/report"), "--tracking", path("one"), "--bench",
                            path("bench.json"), "--set", "probtresh=0.45"});
    QVERIFY2(result.exitCode == 0, result.errors.constData());
    QVERIFY(result.errors.contains("experiment 12 of 12, an hour of work: 100 %"));
    const QByteArray report = contents(path("new/report/report.md"));
    QVERIFY(report.contains("2346 ms"));
    QVERIFY(report.contains("`probtresh=0.45`"));
    QVERIFY(report.contains("| one | tld | complete |"));
    QVERIFY(report.contains("1 random yards from seed 1, 14 frames each"));
    // Everything it names is there, and is what its name says.
    static const QRegularExpression link(QStringLiteral("\\]\\(([^)]+)\\)"));
    int links = 0;
    for (const auto& match : link.globalMatch(QString::fromUtf8(report))) {
      const QByteArray bytes = contents(path("new/report/" + match.captured(1)));
      const bool picture = match.captured(1).endsWith(QLatin1String(".png"));
      QVERIFY2(picture ? bytes.startsWith("\x89PNG") : bytes.contains(','),
               qPrintable(match.captured(1)));
      ++links;
    }
    QVERIFY2(links >= 25, qPrintable(QString::number(links)));
    QCOMPARE(QDir(path("new")).entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
             QStringList{"report"});
  }

  void onlyWhatIsNamed() {
    const Run result = run({"--only", "gap, frames to enter", "--output", path("report")});
    QVERIFY2(result.exitCode == 0, result.errors.constData());
    QVERIFY(result.errors.contains("experiment 2 of 2, gap: 100 %"));
    const QByteArray report = contents(path("report/report.md"));
    QVERIFY(report.contains("Fig. 17") && report.contains("Eq. 2"));
    QVERIFY(!report.contains("Table 6"));
  }

  void aMomentOfWorkIsAFrame() {
    const Run result =
        run({"--only", "an hour of work", "--hours", "1e-12", "--output", path("report")});
    QVERIFY2(result.exitCode == 0, result.errors.constData());
    // What is counted is said, also where there is no other chapter.
    QVERIFY(contents(path("report/report.md")).contains("**Missed**"));
  }

  void anInterruptLeavesNothing() {
    QProcess process;
    process.start(builtProgram("boomwatch-lab"),
                  {"experiments", "--sequences", "1", "--output", path("report")});
    process.setReadChannel(QProcess::StandardError);
    QByteArray said = process.readAllStandardError();
    while (!said.contains("experiment 1 of") && process.waitForReadyRead(60000)) {
      said += process.readAllStandardError();
    }
    // Of a process that has ended the number is 0, and 0 would be our own group.
    const auto running = static_cast<pid_t>(process.processId());
    QVERIFY2(running > 0, said);
    QCOMPARE(::kill(running, SIGINT), 0);
    QVERIFY(process.waitForFinished(120000));
    QVERIFY(process.exitStatus() == QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 1);
    QVERIFY(process.readAllStandardError().contains("stopped"));
    QVERIFY(QDir(m_folder->path()).isEmpty());
  }

  // A limit on the size of files stands for a disk that is full.
  void aFullDiskIsSaidAndLeavesNothing() {
    const QString command = QStringLiteral(
        "trap '' XFSZ; ulimit -f 1; exec \"$0\" experiments --sequences 1 --frames 4 --output "
        "\"$1\"");
    const Run result = run("bash", {"-c", command, builtProgram("boomwatch-lab"), path("full")});
    QVERIFY2(result.exitCode == 1, result.errors.constData());
    QVERIFY2(result.errors.contains("cannot be written"), result.errors.constData());
    QVERIFY(result.errors.contains(path("full").toLocal8Bit()));
    QVERIFY(QDir(m_folder->path()).isEmpty());
  }

  void badArgumentsExitWithTwo_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("named");
    const auto row = [](const char* name, const QStringList& arguments, const char* named) {
      QTest::newRow(name) << arguments << QByteArray(named);
    };
    const QStringList output{"--output", "FOLDER/new"};
    row("no folder", {}, "--output");
    row("not empty", {"--output", "/usr"}, "/usr");
    row("below a file", {"--output", "FOLDER/file/new"}, "cannot be made");
    row("no yards", output + QStringList{"--sequences", "0"}, "--sequences");
    row("too many yards", output + QStringList{"--sequences", "1000000"}, "0..999999");
    row("too many yards for the hours", output + QStringList{"--sequences", "999990"}, "0..999999");
    row("yards too long", output + QStringList{"--frames", "12001"}, "1..12000");
    row("no recordings", output + QStringList{"--tracking", "FOLDER/absent"}, "absent");
    row("no hours", output + QStringList{"--hours", "0"}, "--hours");
    row("hours that are none", output + QStringList{"--hours", "nan"}, "--hours");
    row("no such experiment", output + QStringList{"--only", "gap,nothing"}, "'nothing'");
    row("a word", output + QStringList{"gap"}, "--only");
    row("a setting that is none", output + QStringList{"--set", "resolution=5"}, "resolution");
    row("no benchmarks", output + QStringList{"--bench", "FOLDER/absent.json"}, "absent.json");
    row("other benchmarks", output + QStringList{"--bench", "FOLDER/file"}, "no figures");
  }
  void badArgumentsExitWithTwo() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, named);
    write(path("file"), "nothing");
    arguments.replaceInStrings("FOLDER", m_folder->path());
    const Run result = run(arguments);
    QVERIFY2(result.exitCode == 2, result.errors.constData());
    QVERIFY2(result.errors.contains(named), result.errors.constData());
    QCOMPARE(QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
             QStringList{"file"});
  }
};

BOOMWATCH_TEST(TestExperiments)
#include "test_experiments.moc"
