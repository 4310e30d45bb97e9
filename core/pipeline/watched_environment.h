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

/// The model of the static surroundings together with all that is asked of it. learn() writes;
/// everything else is const. Used by one thread.
class WatchedEnvironment {
 public:
  /// One frame that is evidence, `scene` being what its `cloud` was split into. True when the model
  /// was begun anew: the first time, after forget(), and when its size or its projection has
  /// changed.
  bool learn(const Cloud& cloud, const StaticScene& scene, const Parameters& parameters);
  /// What was learnt holds no more: the next frame begins a new model.
  void forget() { m_exists = false; }

  const EnvironmentModel& model() const { return m_model; }
  /// Indices of the cells that are occupied but do not count (smallest_thing, doubtful_thing),
  /// ascending.
  std::span<const std::size_t> suppressed() const { return m_suppressed; }

  /// The distance from a box to what is around it, with what stands behind it and how much of the
  /// neighbourhood was seen; or why that is not known.
  Clearance around(const OrientedBox& box, const Parameters& parameters) const;

  /// For searches of other kinds among the same cells as those of around().
  const ExactClearance& exact() const { return m_exact; }

 private:
  Clearance search(const OrientedBox& box, const Parameters& parameters) const;
  void addEvidence(Clearance& clearance, const ModelParameters& parameters) const;
  void addObservedShare(Clearance& clearance, const OrientedBox& box,
                        const Parameters& parameters) const;
  std::vector<std::size_t> hiddenAndUnseen() const;

  CellSurfaces m_surfaces;
  EnvironmentModel m_model;
  bool m_exists = false;
  Components m_components;
  ExactClearance m_exact;
  ObservedShare m_observed;
  std::vector<std::size_t> m_suppressed;
  Points m_evidence;  ///< scratch: what the model learns from this frame
  Points m_hidden;    ///< scratch: what shows neither that something is there nor that nothing is
};

}  // namespace boomwatch
