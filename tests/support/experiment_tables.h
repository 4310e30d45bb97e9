#pragma once

#include <algorithm>
#include <string>

#include "lab/experiments/experiment.h"

namespace boomwatch {

inline const auto always = [](double) { return true; };

inline ExperimentSetup little() {
  ExperimentSetup setup;
  setup.sequences = 1;
  setup.frames = 14;
  return setup;
}

inline Table tableOf(const Chapter& chapter, const std::string& file) {
  for (const auto& item : chapter.items) {
    const auto* table = std::get_if<Table>(&item);
    if (table && table->file == file) return *table;
  }
  return {};
}

inline std::string cell(const Table& table, const std::string& row, const std::string& heading) {
  const auto column = std::ranges::find(table.headings, heading) - table.headings.begin();
  for (const Cells& cells : table.rows) {
    if (cells[0] == row) return cells.at(static_cast<std::size_t>(column));
  }
  return "no such row";
}

}  // namespace boomwatch
