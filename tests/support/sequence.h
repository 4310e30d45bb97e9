#pragma once

#include <QString>
#include <QtTest>
#include <chrono>
#include <functional>
#include <limits>
#include <vector>

#include "open_source.h"
#include "pipeline/pipeline.h"
#include "sources/frame_source.h"

namespace boomwatch::test {

/// Frames `first` to `last` - 1 of a recording.
struct Stretch {
  std::size_t first = 0;
  std::size_t last = std::numeric_limits<std::size_t>::max();
};

/// Runs the whole chain over stretches of a recording, or to its end, and hands every result, with
/// the pipeline, to `look`. Returns the frames that were processed.
inline std::size_t runSequence(const QString& address, const Parameters& parameters,
                               const std::function<void(const Result&, const Pipeline&)>& look,
                               const std::vector<Stretch>& stretches = {Stretch{}}) {
  const auto source = openSource(address.toStdString());
  Pipeline pipeline;
  std::size_t count = 0;
  for (const Stretch& stretch : stretches) {
    if (stretch.first > 0 && !source->seek(stretch.first)) return count;
    for (std::size_t frame = stretch.first; frame < stretch.last; ++frame, ++count) {
      const ReadResult read = source->next(std::chrono::seconds(1));
      if (read.status != ReadResult::Status::Ok) break;
      look(pipeline.process(read.frame, parameters), pipeline);
    }
  }
  return count;
}

/// Share of the cells in columns [c0, c1) and rows [r0, r1) for which `holds` is true.
template <class Predicate>
double shareOfCells(const EnvironmentModel& model, double x0, double x1, double y0, double y1,
                    Predicate&& holds) {
  const GridGeometry& grid = model.geometry();
  std::size_t count = 0, held = 0;
  for (int row = grid.rowOf(y0); row < grid.rowOf(y1); ++row) {
    for (int column = grid.columnOf(x0); column < grid.columnOf(x1); ++column) {
      if (!grid.contains(column, row)) continue;
      ++count;
      held += holds(column, row);
    }
  }
  return count == 0 ? 0.0 : static_cast<double>(held) / static_cast<double>(count);
}

}  // namespace boomwatch::test
