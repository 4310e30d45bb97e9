#include <QApplication>
#include <stdexcept>

#include "base/error.h"
#include "command_line.h"
#include "console.h"
#include "headless.h"
#include "parameter_document.h"
#include "program/bash_completion.h"
#include "program/manual_page.h"
#include "program/program_help.h"
#include "program/program_main.h"
#include "result_json.h"

namespace boomwatch {
namespace {

bool hasDisplay() {
  return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
         qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
}

int runHeadlessly(const CommandLine& line, int& argc, char** argv) {
  const auto outcome = runHeadless(line);
  if (line.screenshot.isEmpty() || !outcome.last) return outcome.exitCode;
  // The picture of the window needs no display.
  if (!hasDisplay()) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication application(argc, argv);
  if (!saveWindowScreenshot(outcome.last, line.screenshot)) {
    throw std::runtime_error(line.screenshot.toStdString() +
                             ": cannot be written. Name a PNG file in a folder that can be "
                             "written.");
  }
  return outcome.exitCode;
}

std::string document(const std::string& name) {
  if (name == "parameters") return parameterDocument();
  if (name == "schema") return resultSchema();
  if (name == "man") return manualPage(boomwatchProgram());
  if (name == "completion") return bashCompletion(boomwatchProgram());
  throw Error("--print", "there is no document '" + name + "'",
              "Give parameters, schema, man or completion.");
}

int run(int argc, char** argv) {
  const CommandLine line = parseCommandLine(argumentsOf(argc, argv));
  if (line.help) return print(helpText(boomwatchProgram()));
  if (line.version) return print("boomwatch " + programVersion() + '\n');
  if (!line.print.isEmpty()) return print(document(line.print.toStdString()));
  if (line.headless) return runHeadlessly(line, argc, argv);
  if (!hasDisplay()) {
    throw Error("window", "there is no display",
                "Add --headless, or set DISPLAY or WAYLAND_DISPLAY.");
  }
  QApplication application(argc, argv);
  return runConsole(application, line);
}

}  // namespace
}  // namespace boomwatch

int main(int argc, char** argv) {
  return boomwatch::runProgram("boomwatch", [&] { return boomwatch::run(argc, argv); });
}
