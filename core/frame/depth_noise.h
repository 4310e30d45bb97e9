#pragma once

namespace boomwatch {

/// How far off the depth z of a measured point is. Depth by disparity (Eq. 5) errs with the square
/// of z, as depth cameras do. The inverse depth 1/z therefore errs by the same amount everywhere.
struct DepthNoise {
  /// Standard deviation of 1/z, 1/m: dz = deviation z^2. The default is that of a Kinect
  /// (Khoshelham and Elberink 2012), for sources without a figure of their own.
  double deviation = 0.0014;
  /// Change of 1/z with one pixel of disparity, 1/m: 1 / (f B). 0 unless of a stereo pair.
  double perPixel = 0.0;

  /// Of a stereo pair: matching leaves a quarter of a pixel uncertain. `focalLength` in pixels,
  /// `baseline` in metres.
  static constexpr DepthNoise ofStereo(double focalLength, double baseline) {
    constexpr double matching = 0.25;  // pixels
    const double perPixel = 1.0 / (focalLength * baseline);
    return {matching * perPixel, perPixel};
  }

  /// Standard deviation of a depth, metres.
  constexpr double at(double z) const { return z * z * deviation; }
};

}  // namespace boomwatch
