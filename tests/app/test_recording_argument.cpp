#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include "base/error.h"
#include "command_line.h"
#include "support/program_run.h"
#include "support/test_registry.h"

using boomwatch::parseCommandLine;

/// A recording is named without its kind, as a desktop names the file that was clicked.
class TestRecordingArgument : public QObject {
  Q_OBJECT
 private slots:
  void aFileGetsItsKind_data();
  void aFileGetsItsKind();
  void aFolderGetsItsKind();
  void aFileOfNoKindIsRefusedByName_data();
  void aFileOfNoKindIsRefusedByName();
  void aWordThatIsNoFileIsRefused();
  void onlyOneRecordingIsTaken();
  void theProgramOpensIt();

 private:
  QString file(const char* name) const {
    return writeFile(m_folder.filePath(QString::fromLatin1(name)), "");
  }
  QTemporaryDir m_folder;
};

void TestRecordingArgument::aFileGetsItsKind_data() {
  QTest::addColumn<QString>("kind");
  QTest::newRow("a.pcd") << "cloud:";
  QTest::newRow("a.PLY") << "cloud:";
  QTest::newRow("heights.asc") << "map:";
}

void TestRecordingArgument::aFileGetsItsKind() {
  QFETCH(const QString, kind);
  const QString path = file(QTest::currentDataTag());
  QCOMPARE(parseCommandLine({"boomwatch", path}).source, kind + path);
}

void TestRecordingArgument::aFolderGetsItsKind() {
  const QString folder = m_folder.filePath(QStringLiteral("kitti"));
  QVERIFY(QDir().mkpath(folder + "/image_0") && QDir().mkpath(folder + "/image_1"));
  writeFile(folder + "/image_0/0.png", "");
  writeFile(folder + "/image_1/0.png", "");
  QCOMPARE(parseCommandLine({"boomwatch", folder}).source, QString("stereo:" + folder));
}

void TestRecordingArgument::aFileOfNoKindIsRefusedByName_data() {
  QTest::addColumn<QString>("name");
  // Beside a cloud, which would open for a picture.
  QTest::newRow("bag") << "walk.bag";
  QTest::newRow("mcap") << "walk.mcap";
}

void TestRecordingArgument::aFileOfNoKindIsRefusedByName() {
  QFETCH(const QString, name);
  file("beside.pcd");
  const ProgramRun run = runProgram({file(qPrintable(name)), "--frames", "1"});
  QCOMPARE(run.exitCode, 2);
  QVERIFY2(run.errors.contains(name.toUtf8()), run.errors.constData());
  QVERIFY(run.lines.isEmpty());
}

void TestRecordingArgument::aWordThatIsNoFileIsRefused() {
  QVERIFY_EXCEPTION_THROWN(parseCommandLine({"boomwatch", "nowhere.pcd"}), boomwatch::Error);
}

void TestRecordingArgument::onlyOneRecordingIsTaken() {
  const QString one = file("one.pcd");
  const QString two = file("two.pcd");
  QVERIFY_EXCEPTION_THROWN(parseCommandLine({"boomwatch", one, two}), boomwatch::Error);
  QVERIFY_EXCEPTION_THROWN(parseCommandLine({"boomwatch", one, "--source", "demo:yard"}),
                           boomwatch::Error);
}

void TestRecordingArgument::theProgramOpensIt() {
  const QString path =
      writeCloud(m_folder.filePath(QStringLiteral("wall.pcd")), [](int, int) { return 3.0F; });
  const QStringList options{"--load", "0,0,2,0.3,0.3,0.3,0,0,0", "--frames", "3"};
  const ProgramRun bare = runProgram(QStringList{path} + options);
  QCOMPARE(bare.errors, QByteArray());
  QCOMPARE(bare.exitCode, 0);
  const ProgramRun named = runProgram(QStringList{"--source", "cloud:" + path} + options);
  QCOMPARE(bare.lines.size(), named.lines.size());
  QVERIFY(!bare.lines.isEmpty());
  QCOMPARE(bare.lines.last()["distance_m"], named.lines.last()["distance_m"]);
}

BOOMWATCH_TEST(TestRecordingArgument)
#include "test_recording_argument.moc"
