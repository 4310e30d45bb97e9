#include "export_run.h"

#include <atomic>
#include <csignal>
#include <cstdio>

namespace boomwatch {
namespace {

std::atomic<bool> stopped = false;
static_assert(std::atomic<bool>::is_always_lock_free);  // a signal handler may set it

}  // namespace

int runExport(const DemoExport& what) {
  stopped = false;
  std::signal(SIGINT, [](int) { stopped = true; });
  std::signal(SIGTERM, [](int) { stopped = true; });
  const bool whole = exportDemo(what, [](std::size_t done, std::size_t all) {
    std::fprintf(stderr, "\rboomwatch: frame %zu of %zu", done, all);
    std::fflush(stderr);
    return !stopped;
  });
  std::fprintf(
      stderr,
      whole ? "\nboomwatch: %s is written\n" : "\nboomwatch: stopped; nothing is left of %s\n",
      what.folder.c_str());
  return whole ? 0 : 1;
}

}  // namespace boomwatch
