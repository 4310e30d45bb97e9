#include "lab/export_run.h"

#include <cstdio>

#include "program/interrupt_watch.h"

namespace boomwatch {

int runExport(const DemoExport& what) {
  const InterruptWatch watch;
  const bool whole = exportDemo(what, [](std::size_t done, std::size_t all) {
    std::fprintf(stderr, "\rboomwatch-lab: frame %zu of %zu", done, all);
    std::fflush(stderr);
    return !InterruptWatch::interrupted();
  });
  std::fprintf(stderr,
               whole ? "\nboomwatch-lab: %s is written\n"
                     : "\nboomwatch-lab: stopped; nothing is left of %s\n",
               what.folder.c_str());
  return whole ? 0 : 1;
}

}  // namespace boomwatch
