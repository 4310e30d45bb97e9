#pragma once

namespace boomwatch {

/// Numbers of ToolMotion. "Chosen": by judgement; not measured one by one.
struct ToolMotionTuning {
  double gate = 16.27;  ///< chi squared with three degrees of freedom: 99.9 % lie below
  double firstSpeed =
      2.0;  ///< m/s, standard deviation before the velocity is known: cranes are not faster
  int agreeingOutliers = 3;       ///< in a row, after which the filter begins anew; chosen
  int agreedForVelocity = 3;      ///< measurements before a velocity is reported; chosen
  int agreedForCertainty = 10;    ///< measurements that three outliers cannot overrule; chosen
  double maxContradiction = 3.0;  ///< seconds after which a place out of reach is believed; chosen
  double toolExtent = 1.0;        ///< metres: another part of the tool may be measured now; chosen
  double besideHeld = 0.4;        ///< metres from where the load says the tool is; chosen
};

}  // namespace boomwatch
