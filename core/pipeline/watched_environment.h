#pragma once

#include <optional>
#include <span>

#include "collision/exact_clearance.h"
#include "collision/observed_share.h"
#include "crane/static_scene.h"
#include "environment/cell_surfaces.h"
#include "environment/components.h"
#include "environment/environment_model.h"
#include "frame/clearance.h"
#include "parameters/parameters.h"

namespace boomwatch {

/// Owns the model of the static environment, and all that is derived from it to be searched.
/// Everything but update() and forget() is const. Camera frame, metres. Used by one thread.
class WatchedEnvironment {
 public:
  /// Updates the model with a valid frame; `scene` is what its `cloud` was separated into. True
  /// when it began a new model: the first time, after forget(), and when the model's size or
  /// projection has changed.
  bool update(const Cloud& cloud, const StaticScene& scene, const Parameters& parameters);
  /// Makes the next update() begin a new model. Until then the old one is searched.
  void forget() { m_exists = false; }

  const EnvironmentModel& model() const { return m_model; }
  /// Indices of the cells that are occupied and not searched (smallest_thing, doubtful_thing),
  /// ascending.
  std::span<const std::size_t> suppressed() const { return m_suppressed; }

  /// The distance from `box` to the nearest cell, with the evidence for that cell and the share of
  /// the neighbourhood that was observed; or the reason why it is not known. A box that can be
  /// searched (see isUsable).
  Clearance clearanceOf(const OrientedBox& box, const Parameters& parameters) const;

  /// For other searches among the cells that clearanceOf() searches.
  const ExactClearance& exact() const { return m_exact; }

 private:
  Clearance search(const OrientedBox& box, const Parameters& parameters) const;
  void addEvidence(Clearance& clearance, const ModelParameters& parameters) const;
  void addObservedShare(Clearance& clearance, const OrientedBox& box,
                        const Parameters& parameters) const;
  std::vector<std::size_t> maskedAndUnobserved() const;

  CellSurfaces m_surfaces;
  EnvironmentModel m_model;
  bool m_exists = false;
  Components m_components;
  ExactClearance m_exact;
  ObservedShare m_observed;
  std::vector<std::size_t> m_suppressed;
  Points m_evidence;  ///< scratch: this frame's points that update the model
  Points m_masked;    ///< scratch: this frame's points that occlude what is behind them
};

}  // namespace boomwatch
