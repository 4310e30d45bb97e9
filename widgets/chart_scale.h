#pragma once

#include <QString>
#include <vector>

#include "report/figure.h"

namespace boomwatch {

/// Where the values of one axis stand, and what is written beside it.
class ChartScale {
 public:
  struct Tick {
    double value = 0.0;
    QString text;  ///< empty: a small one
  };

  /// Shows low..high and a little more, up to a tick, or what the axis itself says; a span of
  /// nothing is widened. A logarithmic axis begins above 0.
  ChartScale(const Axis& axis, double low, double high);

  double low() const { return m_low; }
  double high() const { return m_high; }
  /// 0 at low(), 1 at high(); outside beyond that.
  double shareOf(double value) const;
  std::vector<Tick> ticks() const;

 private:
  std::vector<Tick> decades() const;

  bool m_logarithmic;
  double m_low, m_high;
};

}  // namespace boomwatch
