#pragma once

#include <QString>
#include <QtTest>
#include <chrono>
#include <functional>

#include "pipeline/pipeline.h"
#include "sources/frame_source.h"

namespace boomwatch::test {

/// Runs the whole chain over a recording and hands every result, with the pipeline, to `look`.
/// Returns the frames that were processed.
inline std::size_t runSequence(const QString& address,
                               const std::function<Parameters(std::size_t)>& parameters,
                               const std::function<void(const Result&, const Pipeline&)>& look,
                               std::size_t frames = std::numeric_limits<std::size_t>::max()) {
  const auto source = openSource(address.toStdString());
  Pipeline pipeline;
  std::size_t count = 0;
  for (; count < frames; ++count) {
    const ReadResult read = source->next(std::chrono::seconds(1));
    if (read.status != ReadResult::Status::Ok) break;
    look(pipeline.process(read.frame, parameters(count)), pipeline);
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
