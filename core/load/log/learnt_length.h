#pragma once

#include <vector>

namespace boomwatch {

/// One of the load's sizes, learnt over the first seconds and from then on from frames that show it
/// better. Along the line of sight a length is a difference of depths, across it one of pixels: of
/// a log that points at the camera a stereo pair sees too little.
class LearntLength {
 public:
  bool empty() const { return m_samples.empty(); }
  /// Metres; the median of what was learnt. Not when empty.
  double value() const { return m_value; }

  /// `crosswise`: sine of the angle between this length and the line of sight. A frame of the
  /// learning time always counts; a later one in place of one that showed clearly less.
  void learn(double length, double crosswise, bool isLearningTime);

 private:
  struct Sample {
    double length, crosswise;
  };
  std::vector<Sample> m_samples;
  double m_value = 0.0;
};

}  // namespace boomwatch
