// The rooms of the tree and the arrows between them: a file may include its own room and the rooms
// its row names, and no row names a room that stands below it in the table.
#include <QDirIterator>
#include <QFile>
#include <QTest>

#include "include_arrows.h"
#include "support/build_paths.h"
#include "support/test_registry.h"

namespace {

using boomwatch::Ban;
using boomwatch::includeFaults;
using boomwatch::Room;
using boomwatch::Sources;

const QStringList values{"core/base", "core/files", "core/frame"};
const QStringList stages = values + QStringList{"core/parameters", "core/cloud"};
const QStringList product =
    stages + QStringList{"core/report",   "core/environment", "core/stereo",    "core/tracking",
                         "core/load",     "core/crane",       "core/collision", "core/sources",
                         "core/pipeline", "core/recording"};

// From the bottom of the house to its top.
const QList<Room> rooms{
    {"core/base", {}},
    {"core/frame", {"core/base"}},
    {"core/files", {"core/base"}},
    {"core/report", {"core/base", "core/files"}},
    {"core/parameters", values},
    {"core/cloud", values + QStringList{"core/parameters"}},
    {"core/environment", stages},
    {"core/stereo", stages},
    {"core/tracking", stages},
    {"core/load", stages},
    {"core/crane", stages + QStringList{"core/load"}},
    {"core/collision", stages + QStringList{"core/environment"}},
    {"core/sources", stages + QStringList{"core/stereo"}},
    {"core/pipeline", stages + QStringList{"core/environment", "core/stereo", "core/tracking",
                                           "core/load", "core/crane", "core/collision"}},
    {"core/recording", stages + QStringList{"core/report", "core/sources", "core/pipeline"}},
    {"core/simulation", stages + QStringList{"core/report", "core/stereo", "core/sources"}},
    {"core/lab", product + QStringList{"core/simulation"}},
    {"widgets", product},
    {"app", product + QStringList{"core/simulation", "widgets"}},
    {"app/lab", product + QStringList{"core/simulation", "core/lab", "widgets", "app"}},
};

// Core runs without a window; two libraries bring a second window system along.
const QList<Ban> bans{
    {"core/", "Q"},
    {"core/", "vtk"},
    {"", "opencv2/highgui"},
    {"", "pcl/visualization"},
};

Sources readTree() {
  const QDir root = folderAboveWith(QStringLiteral("CMakePresets.json"));
  Sources sources;
  for (const char* folder : {"core", "widgets", "app"}) {
    QDirIterator files(root.filePath(folder), {"*.h", "*.cpp"}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
      QFile file(files.next());
      if (file.open(QIODevice::ReadOnly))
        sources[root.relativeFilePath(file.fileName())] = QString::fromUtf8(file.readAll());
    }
  }
  return sources;
}

}  // namespace

class TestIncludes : public QObject {
  Q_OBJECT

 private slots:
  void everyArrowOfTheTableGoesDown() {
    QStringList above;
    for (const Room& room : rooms) {
      for (const QString& other : room.below)
        QVERIFY2(above.contains(other), qPrintable(room.folder + " -> " + other));
      above << room.folder;
    }
  }

  void everyIncludeFollowsTheTable() {
    const Sources sources = readTree();
    QVERIFY2(sources.size() > 300, "the tree was not read");
    const QStringList faults = includeFaults(rooms, bans, sources);
    QVERIFY2(faults.isEmpty(), qPrintable('\n' + faults.join('\n')));
  }

  void aMadeUpLineIsNamed_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("fault");
    const auto row = [](const char* file, const char* line, const char* fault) {
      QTest::addRow("%s %s", file, line) << QString(file) << QString(line) << QString(fault);
    };
    row("core/frame/frame.h", "#include \"pipeline/result.h\"",
        "core/frame must not include core/pipeline");
    row("core/load/log/log_fit.cpp", "#  include \"tracking/tracker.h\"",
        "core/load must not include core/tracking");
    row("core/pipeline/pipeline.cpp", "#include \"lab/not_there_yet.h\"",
        "core/pipeline must not include core/lab");
    row("core/pipeline/pipeline.cpp", "#include \"../../app/worker.h\"",
        "core/pipeline must not include app");
    row("core/pipeline/pipeline.cpp", "#include \"worker.h\"",
        "core/pipeline must not include app");
    row("widgets/display.cpp", "#include \"simulation/demo_source.h\"",
        "widgets must not include core/simulation");
    row("app/worker.cpp", "#include \"lab/export_run.h\"", "app must not include app/lab");
    row("app/worker.cpp", "#include \"lab/experiments/experiment.h\"",
        "app must not include core/lab");
    row("core/base/error.h", "#include <QString>", "core/ must not include <Q...>");
    row("core/lab/a.cpp", "#include <vtkActor.h>", "core/ must not include <vtk...>");
    row("widgets/a.cpp", "#include <opencv2/highgui.hpp>",
        " must not include <opencv2/highgui...>");
    row("widgets/display.cpp", "#include <QWidget>", "");
    row("core/pipeline/pipeline.cpp", "#include \"stereo/stereo_stage.h\"", "");
    row("app/lab/evaluate.cpp", "#include \"lab/experiments/experiment.h\"", "");
    row("core/frame/frame.h", "// #include \"pipeline/result.h\"", "");
  }

  void aMadeUpLineIsNamed() {
    QFETCH(QString, file);
    QFETCH(QString, line);
    QFETCH(QString, fault);
    Sources sources{{"app/worker.h", ""},
                    {"app/lab/export_run.h", ""},
                    {"core/lab/experiments/experiment.h", ""}};
    sources[file] = "#pragma once\n\n" + line + "\n";
    const QStringList faults = includeFaults(rooms, bans, sources);
    if (fault.isEmpty()) {
      QCOMPARE(faults, QStringList());
    } else {
      QCOMPARE(faults, QStringList{QString("%1:3: %2: %3").arg(file, fault, line)});
    }
  }

  void aFileOutsideEveryRoomIsNamed() {
    QCOMPARE(includeFaults(rooms, bans, {{"core/attic/a.h", ""}}),
             QStringList{"core/attic/a.h: lies in no room"});
  }
};

BOOMWATCH_TEST(TestIncludes)
#include "test_includes.moc"
