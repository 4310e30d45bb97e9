#include <QApplication>
#include <cstdio>

#include "base/error.h"
#include "base/freed_memory.h"
#include "command_line.h"
#include "console.h"
#include "headless.h"
#include "lab/evaluate.h"
#include "lab/experiments_run.h"
#include "lab/export_run.h"

namespace {

enum ExitCode { Done = 0, FaultInRun = 1, BadArguments = 2 };

int fail(const std::string& message, ExitCode code) {
  std::fprintf(stderr, "boomwatch: %s\n", message.c_str());
  return code;
}

void print(const QString& text) { std::fputs(qPrintable(text), stdout); }

bool hasDisplay() {
  return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
         qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
}

int runHeadlessly(const boomwatch::CommandLine& line, int& argc, char** argv) {
  const auto outcome = boomwatch::runHeadless(line);
  if (line.screenshot.isEmpty() || !outcome.last) return outcome.exitCode;
  // The picture of the window needs no display.
  if (!hasDisplay()) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication application(argc, argv);
  if (!boomwatch::saveWindowScreenshot(outcome.last, line.screenshot)) {
    return fail(line.screenshot.toStdString() +
                    ": cannot be written. Name a PNG file in a folder "
                    "that can be written.",
                FaultInRun);
  }
  return outcome.exitCode;
}

int run(const boomwatch::CommandLine& line, int& argc, char** argv) {
  if (!line.exportDemo.isEmpty()) {
    return boomwatch::runExport({line.exportDemo.toStdString(), line.frames,
                                 line.output.toStdString(), line.exportTruthImages});
  }
  if (line.evaluate) return boomwatch::runEvaluation(line);
  if (line.experiments) {
    // Figures need fonts, but no display.
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication application(argc, argv);
    return boomwatch::runExperiments(line, BOOMWATCH_VERSION);
  }
  if (line.headless) return runHeadlessly(line, argc, argv);
  if (!hasDisplay()) {
    throw boomwatch::Error("window", "there is no display",
                           "Add --headless, or set DISPLAY or WAYLAND_DISPLAY.");
  }
  QApplication application(argc, argv);
  return boomwatch::runConsole(application, line);
}

QStringList toArguments(int argc, char** argv) {
  QStringList arguments;
  for (int i = 0; i < argc; ++i) arguments << QString::fromLocal8Bit(argv[i]);
  return arguments;
}

/// Our own messages name the file and what to do; those of the decoders below only add noise.
void quietenLibraries() {
  if (!qEnvironmentVariableIsSet("OPENCV_LOG_LEVEL")) qputenv("OPENCV_LOG_LEVEL", "SILENT");
  if (!qEnvironmentVariableIsSet("OPENCV_FFMPEG_LOGLEVEL")) qputenv("OPENCV_FFMPEG_LOGLEVEL", "-8");
}

}  // namespace

int main(int argc, char** argv) {
  boomwatch::keepFreedMemory();
  quietenLibraries();
  boomwatch::CommandLine line;
  try {
    line = boomwatch::parseCommandLine(toArguments(argc, argv));
  } catch (const std::exception& fault) {
    return fail(fault.what(), BadArguments);
  }
  if (line.help) {
    const QCoreApplication application(argc, argv);
    print(boomwatch::helpText());
    return Done;
  }
  if (line.version) {
    print(QStringLiteral("boomwatch " BOOMWATCH_VERSION "\n"));
    return Done;
  }
  try {
    return run(line, argc, argv);
  } catch (const boomwatch::Error& fault) {
    return fail(fault.what(), BadArguments);
  } catch (const std::exception& fault) {
    return fail(fault.what(), FaultInRun);
  }
}
