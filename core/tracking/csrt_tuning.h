#pragma once

#include <cstddef>

namespace boomwatch {

/// Numbers of the confidence of CsrtTracker. "Measured": on six recordings with ground truth, when
/// the tracker was made.
struct CsrtTuning {
  double minConfidence = 0.5;  ///< NCC; measured: 1 in 500 boxes on the target has less, and 5 in 6
                               ///< of those beside it, unless the box slid off slowly
  double surelyTarget = 0.6;   ///< NCC from which a view may be kept; chosen, not measured
  double sameView = 0.92;      ///< NCC from which a view is known already; chosen, not measured
  std::size_t maxViews = 40;   ///< chosen, not measured
  int viewSide = 20;           ///< pixels; chosen, not measured
  double minContrast = 2.0;    ///< grey levels, standard deviation; chosen, not measured
};

}  // namespace boomwatch
