#include "chart_scale.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace boomwatch {
namespace {

constexpr double minOfLogarithm = 1e-9;
constexpr int maxTicks = 8;

/// The finest of 1, 2, 5 x 10^n that divides `span` into at most maxTicks.
double stepFor(double span) {
  const double decade = std::pow(10.0, std::floor(std::log10(span / maxTicks)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (span / (step * decade) <= maxTicks + 1e-9) return step * decade;
  }
  return 10.0 * decade;
}

int digitsFor(double step) {
  return std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
}

}  // namespace

ChartScale::ChartScale(const Axis& axis, double low, double high)
    : m_logarithmic(axis.logarithmic),
      m_low(axis.low.value_or(low)),
      m_high(axis.high.value_or(high)) {
  if (m_logarithmic) {
    m_low = std::max(m_low, minOfLogarithm);
    m_high = std::max(m_high, m_low);
    if (m_high <= m_low * 1.001) m_low /= 2.0, m_high *= 2.0;
  } else if (!(m_high - m_low > 1e-9 * std::max(1.0, std::abs(m_low)))) {
    m_high = m_low + 1.0;
  }
  if (m_logarithmic) return;
  // Up to the next tick, unless the axis says where it ends.
  const double step = stepFor(m_high - m_low);
  if (!axis.low) m_low = std::floor(m_low / step + 1e-9) * step;
  if (!axis.high) m_high = std::ceil(m_high / step - 1e-9) * step;
}

double ChartScale::shareOf(double value) const {
  if (!m_logarithmic) return (value - m_low) / (m_high - m_low);
  return std::log(std::max(value, minOfLogarithm) / m_low) / std::log(m_high / m_low);
}

std::vector<ChartScale::Tick> ChartScale::ticks() const {
  if (m_logarithmic) return decades();
  std::vector<Tick> ticks;
  const double step = stepFor(m_high - m_low);
  for (double k = std::ceil(m_low / step - 1e-9); k * step <= m_high + 1e-9 * step; ++k) {
    ticks.push_back({k * step, QLocale().toString(k * step + 0.0, 'f', digitsFor(step))});
  }
  return ticks;
}

/// 1, 2, 5 of every decade with words where the axis is short; of a long one the decades only.
std::vector<ChartScale::Tick> ChartScale::decades() const {
  std::vector<Tick> ticks;
  const bool isShort = m_high / m_low < 2e3;
  for (int decade = static_cast<int>(std::floor(std::log10(m_low)));
       decade <= static_cast<int>(std::ceil(std::log10(m_high))); ++decade) {
    for (int digit = 1; digit <= 9; ++digit) {
      const double value = digit * std::pow(10.0, decade);
      if (value < m_low * (1 - 1e-9) || value > m_high * (1 + 1e-9)) continue;
      const bool named = digit == 1 || (isShort && (digit == 2 || digit == 5));
      ticks.push_back({value, named ? QLocale().toString(value, 'g', 3) : QString()});
    }
  }
  return ticks;
}

}  // namespace boomwatch
