#pragma once

#include <optional>
#include <string>
#include <vector>

namespace boomwatch {

/// A place on a line; absent y: nothing is known there, and the line has a gap.
struct Sample {
  double x = 0.0;
  std::optional<double> y;
};

/// One line or cloud of marks of a figure.
struct Series {
  enum class Kind {
    Line,    ///< told from others by its dashes
    Marked,  ///< a line with a mark at every sample
    Steps,   ///< as Line, but level up to the next sample
    Marks,   ///< marks alone
  };
  std::string name;
  std::vector<Sample> samples;
  Kind kind = Kind::Line;
};

/// A band across the figure.
struct Zone {
  double low = 0.0, high = 0.0;
  std::string name;  ///< stands in it; may be empty
};

/// What an axis shows. Without limits it shows all samples.
struct Axis {
  std::string title;  ///< with the unit: "distance (m)"
  bool logarithmic = false;
  std::optional<double> low, high;
};

/// A chart as data; widgets/chart.h draws it.
struct Figure {
  std::string file;   ///< name without extension
  std::string title;  ///< a sentence
  Axis x, y;
  std::vector<Series> series;
  std::vector<Zone> zones;  ///< of y, the worst last: each is darker than the one before
  std::vector<Zone> gaps;   ///< of x, hatched: nothing is known there; the name says why
};

}  // namespace boomwatch
