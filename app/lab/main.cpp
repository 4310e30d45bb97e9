#include <QGuiApplication>

#include "lab/evaluate.h"
#include "lab/experiments_run.h"
#include "lab/export_run.h"
#include "lab/lab_command_line.h"
#include "program/program_main.h"

namespace boomwatch {
namespace {

class LabRun {
 public:
  LabRun(int& argc, char** argv) : m_argc(argc), m_argv(argv) {}

  int operator()(const TextOrder& order) const { return print(order.text); }
  int operator()(const DemoExport& order) const { return runExport(order); }
  int operator()(const EvaluationOrder& order) const { return runEvaluation(order); }
  int operator()(const ExperimentsOrder& order) const {
    // Figures need fonts, but no display.
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication application(m_argc, m_argv);
    return runExperiments(order, programVersion());
  }

 private:
  int& m_argc;
  char** m_argv;
};

}  // namespace
}  // namespace boomwatch

int main(int argc, char** argv) {
  using namespace boomwatch;
  return runProgram("boomwatch-lab", [&] {
    return std::visit(LabRun(argc, argv), parseLabCommandLine(argumentsOf(argc, argv)));
  });
}
