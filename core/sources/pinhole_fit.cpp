#include "sources/pinhole_fit.h"

#include <algorithm>

namespace boomwatch {
namespace {

/// Least squares of pixel = f ratio + c over a sample.
class LineFit {
 public:
  void add(double ratio, double pixel) {
    ++m_n;
    m_x += ratio;
    m_y += pixel;
    m_xx += ratio * ratio;
    m_xy += ratio * pixel;
    m_yy += pixel * pixel;
  }
  /// False where the sample does not lie on a rising line to `tolerance` pixels (rms).
  bool solve(double tolerance, double& f, double& c) const {
    const double spread = m_xx - m_x * m_x / m_n;
    if (m_n < 30 || !(spread > 1e-9 * m_n)) return false;
    f = (m_xy - m_x * m_y / m_n) / spread;
    c = (m_y - f * m_x) / m_n;
    const double residual = (m_yy - m_y * m_y / m_n) - f * f * spread;
    return f > 0.0 && residual <= tolerance * tolerance * m_n;
  }

 private:
  double m_n = 0, m_x = 0, m_y = 0, m_xx = 0, m_xy = 0, m_yy = 0;
};

}  // namespace

std::optional<PinholeCamera> fitPinhole(const Cloud& cloud) {
  constexpr double tolerance = 2.0;  // pixels
  if (!cloud.organised() || cloud.width < 2) return std::nullopt;
  const int step =
      std::max(1, static_cast<int>(std::sqrt(static_cast<double>(cloud.size()) / 5e3)));
  LineFit horizontal;
  LineFit vertical;
  for (int row = 0; row < cloud.height; row += step) {
    for (int column = 0; column < cloud.width; column += step) {
      const Eigen::Vector3d p = cloud.at(column, row).cast<double>();
      if (!p.allFinite() || p.z() < 1e-3) continue;
      horizontal.add(p.x() / p.z(), column);
      vertical.add(p.y() / p.z(), row);
    }
  }
  PinholeCamera fit;
  fit.width = cloud.width;
  fit.height = cloud.height;
  if (!horizontal.solve(tolerance, fit.fx, fit.cx)) return std::nullopt;
  if (!vertical.solve(tolerance, fit.fy, fit.cy)) return std::nullopt;
  return fit;
}

}  // namespace boomwatch
