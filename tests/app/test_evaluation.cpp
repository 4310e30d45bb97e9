#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <csignal>

#include "support/build_paths.h"
#include "support/test_registry.h"
#include "support/tracking_folder.h"

using namespace boomwatch::test;

/// boomwatch-lab evaluate, run as a person would.
class TestEvaluation : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void tablesOfAFolderOfSequences();
  void framesAreLimited();
  void theTargetGoesAndComesBackWhereAskedFor();
  void oneBadSequenceAmongSeveral();
  void badArgumentsExitWithTwo_data();
  void badArgumentsExitWithTwo();
  void anOutputThatCannotBeWrittenIsSaidAtOnce();
  void interruptedItSaysWhatIsWhole();

 private:
  struct Run {
    int exitCode = -1;
    QString output, errors;
  };
  Run run(const QStringList& arguments) const;
  QString path(const QString& name) const { return m_folder->filePath(name); }
  /// A sequence of `frames` pictures, in a folder of that name.
  void writeSequence(const QString& name, int frames) const;
  static QStringList linesOf(const QString& file);

  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestEvaluation::init() { m_folder = std::make_unique<QTemporaryDir>(); }

TestEvaluation::Run TestEvaluation::run(const QStringList& arguments) const {
  QProcess process;
  process.start(builtProgram("boomwatch-lab"), QStringList{"evaluate"} + arguments);
  if (!process.waitForFinished(120000)) {
    process.kill();
    process.waitForFinished();
    return {};
  }
  const bool normal = process.exitStatus() == QProcess::NormalExit;
  return {normal ? process.exitCode() : -1, QString::fromUtf8(process.readAllStandardOutput()),
          QString::fromUtf8(process.readAllStandardError())};
}

void TestEvaluation::writeSequence(const QString& name, int frames) const {
  writePictures(path(name), frames);
  QFile truth(path(name + "/groundtruth_rect.txt"));
  QVERIFY(truth.open(QIODevice::WriteOnly));
  truth.write(sizeLines(frames));
}

QStringList TestEvaluation::linesOf(const QString& file) {
  QFile written(file);
  if (!written.open(QIODevice::ReadOnly)) return {};
  return QString::fromUtf8(written.readAll()).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
}

void TestEvaluation::tablesOfAFolderOfSequences() {
  writeSequence("all/first", 10);
  writeSequence("all/second", 6);
  const Run result = run({"tracking", path("all"), "--output", path("new/tables")});
  QCOMPARE(result.exitCode, 0);
  const QStringList lines = linesOf(path("new/tables/tracking.csv"));
  // Seven trackers over two sequences, and their means.
  QCOMPARE(lines.size(), 1 + 14 + 7);
  const auto column = [&](const QString& line, const char* name) {
    return line.split(',')[lines[0].split(',').indexOf(QLatin1String(name))];
  };
  for (const char* tracker :
       {"tld", "cmt", "klt", "csrt", "opencv_tld", "opencv_csrt", "opencv_medianflow"}) {
    const QStringList own = lines.filter(QStringLiteral(",%1,").arg(tracker));
    QCOMPARE(own.size(), 3);
    QCOMPARE(column(own[0], "sequence"), QStringLiteral("first"));
    QCOMPARE(column(own[2], "frames"), QStringLiteral("14"));
    QVERIFY2(column(own[2], "success_auc").toDouble() > 0.4, qPrintable(own[2]));
    QVERIFY(column(own[2], "fps").toDouble() > 0.0);
    QVERIFY2(result.output.contains(tracker), qPrintable(result.output));
  }
  QVERIFY(linesOf(path("new/tables/tracking.md")).join(' ').contains("| second |"));
  QCOMPARE(QDir(path("new/tables")).entryList(QDir::Files).size(), 2);
  QVERIFY2(result.errors.contains("sequence 2 of 2 (second), frame 6 of 6"),
           qPrintable(result.errors));
}

void TestEvaluation::framesAreLimited() {
  writeSequence("one", 10);
  const Run result = run({path("one"), "--tracker", "klt", "--frames", "4"});
  QCOMPARE(result.exitCode, 0);
  // A heading, one run, its mean.
  QCOMPARE(result.output.count(QLatin1Char('\n')), 3);
  QVERIFY(result.output.contains(QRegularExpression("one +klt +complete +3 ")));
}

void TestEvaluation::theTargetGoesAndComesBackWhereAskedFor() {
  writeSequence("one", 110);
  const Run result =
      run({path("one"), "--tracker", "klt", "--absences", "1", "--output", path("out")});
  QCOMPARE(result.exitCode, 0);
  const QStringList lines = linesOf(path("out/tracking.csv"));
  QVERIFY2(lines.value(0).endsWith("found_again,followed_before,followed_found_again"),
           qPrintable(lines.value(0)));
  QVERIFY2(lines.value(1).startsWith("one+absences,klt,complete,109,"), qPrintable(lines.value(1)));
  QVERIFY2(lines.value(1).endsWith(",1,0,1,0"), qPrintable(lines.value(1)));
}

void TestEvaluation::oneBadSequenceAmongSeveral() {
  writeSequence("all/a", 5);
  writeSequence("all/b", 5);
  writeSequence("all/c", 5);
  QVERIFY(QFile::remove(path("all/b/img/0005.png")));
  const Run result = run({path("all"), "--tracker", "klt", "--output", path("out")});
  QCOMPARE(result.exitCode, 1);
  QVERIFY2(result.errors.contains("all/b"), qPrintable(result.errors));
  const QStringList lines = linesOf(path("out/tracking.csv"));
  QVERIFY(lines[1].startsWith("a,klt,complete,4,"));
  QVERIFY(lines[2].startsWith("b,klt,failed,,"));
  QVERIFY(lines[3].startsWith("c,klt,complete,4,"));
  QVERIFY(lines[4].startsWith("mean,klt,2 of 3,8,"));
}

void TestEvaluation::badArgumentsExitWithTwo_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QString>("named");
  const auto row = [](const char* name, const QStringList& arguments, const char* named) {
    QTest::newRow(name) << arguments << QString::fromLatin1(named);
  };
  row("nothing to evaluate", {"dancing", "."}, "dancing");
  row("no folder", {}, "no folder");
  row("no folder behind the word", {"tracking"}, "no folder");
  row("absent folder", {"absent/folder"}, "absent/folder");
  row("no sequence in it", {"EMPTY"}, "no sequence");
  row("unknown tracker", {"EMPTY", "--tracker", "goturn"}, "opencv_medianflow");
  row("no absences", {"EMPTY", "--absences", "0"}, "--absences");
  row("no frames", {"EMPTY", "--frames", "0"}, "--frames");
}

void TestEvaluation::badArgumentsExitWithTwo() {
  QFETCH(QStringList, arguments);
  QFETCH(QString, named);
  arguments.replaceInStrings("EMPTY", m_folder->path());
  const Run result = run(arguments);
  QCOMPARE(result.exitCode, 2);
  QVERIFY2(result.errors.contains(named), qPrintable(result.errors));
  QVERIFY(result.output.isEmpty());
}

void TestEvaluation::anOutputThatCannotBeWrittenIsSaidAtOnce() {
  writeSequence("one", 5);
  const QString file = path("one/groundtruth_rect.txt");
  const Run result = run({path("one"), "--output", file});
  QCOMPARE(result.exitCode, 2);
  QVERIFY2(result.errors.contains(file), qPrintable(result.errors));
  QVERIFY(result.output.isEmpty());
}

void TestEvaluation::interruptedItSaysWhatIsWhole() {
  writeSequence("all/a", 5);
  writeSequence("all/b", 400);
  QProcess process;
  process.start(builtProgram("boomwatch-lab"),
                {"evaluate", path("all"), "--tracker", "klt", "--tracker", "opencv_csrt",
                 "--output", path("out")});
  QByteArray errors;
  process.setReadChannel(QProcess::StandardError);
  while (!errors.contains("(b), frame 50") && process.waitForReadyRead(120000)) {
    errors += process.readAllStandardError();
  }
  QVERIFY2(errors.contains("(b), frame 50"), errors);
  // Of a process that has ended the number is 0, and 0 would be our own group.
  const auto running = static_cast<pid_t>(process.processId());
  QVERIFY(running > 0);
  QCOMPARE(::kill(running, SIGINT), 0);
  QVERIFY(process.waitForFinished(120000));
  QVERIFY(process.exitStatus() == QProcess::NormalExit);
  QCOMPARE(process.exitCode(), 1);
  const QStringList lines = linesOf(path("out/tracking.csv"));
  QVERIFY(lines[1].startsWith("a,klt,complete,4,"));
  QVERIFY(lines[3].startsWith("b,klt,interrupted,,"));
  QVERIFY(lines[5].startsWith("mean,klt,1 of 2,4,"));
}

BOOMWATCH_TEST(TestEvaluation)
#include "test_evaluation.moc"
