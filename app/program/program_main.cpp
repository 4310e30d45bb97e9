#include "program/program_main.h"

#include <cstdio>

#include "base/error.h"
#include "base/freed_memory.h"

namespace boomwatch {
namespace {

/// Our own messages name the file and what to do; those of the decoders below only add noise.
void quietenLibraries() {
  if (!qEnvironmentVariableIsSet("OPENCV_LOG_LEVEL")) qputenv("OPENCV_LOG_LEVEL", "SILENT");
  if (!qEnvironmentVariableIsSet("OPENCV_FFMPEG_LOGLEVEL")) qputenv("OPENCV_FFMPEG_LOGLEVEL", "-8");
}

int fail(const char* name, const char* message, ExitCode code) {
  std::fprintf(stderr, "%s: %s\n", name, message);
  return code;
}

}  // namespace

int runProgram(const char* name, const std::function<int()>& work) {
  keepFreedMemory();
  quietenLibraries();
  try {
    return work();
  } catch (const Error& fault) {
    return fail(name, fault.what(), BadArguments);
  } catch (const std::exception& fault) {
    return fail(name, fault.what(), FaultInRun);
  }
}

std::string programVersion() { return BOOMWATCH_VERSION; }

QStringList argumentsOf(int argc, char** argv) {
  QStringList arguments;
  for (int i = 0; i < argc; ++i) arguments << QString::fromLocal8Bit(argv[i]);
  return arguments;
}

int print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  return Done;
}

}  // namespace boomwatch
