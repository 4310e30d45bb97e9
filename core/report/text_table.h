#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace boomwatch {

/// One row of a table, as text; an empty cell is one of which nothing is known.
using Cells = std::vector<std::string>;

/// Fixed notation, in no locale; empty where there is no value.
std::string fixedText(std::optional<double> value, int decimals, double factor = 1.0);

/// A row of CSV, with its line feed; what parts fields is quoted.
std::string csvLine(std::span<const std::string> cells);

/// A row of a Markdown table, with its line feed; a dash for an empty cell.
std::string markdownLine(std::span<const std::string> cells);

/// The line below the headings: the first `texts` columns stand on the left, the others are
/// numbers.
std::string markdownRule(std::size_t columns, std::size_t texts);

}  // namespace boomwatch
