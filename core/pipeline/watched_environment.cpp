#include "pipeline/watched_environment.h"

#include <algorithm>

#include "collision/nearest_pair.h"
#include "collision/ray_clearance.h"

namespace boomwatch {
namespace {

/// Unknown is not clear, even where min_observed is 0.
constexpr double noShare = 1e-9;

/// Of the highest probability that the update can reach; with the thesis's values 7 frames in a row
/// give it.
constexpr double certainShare = 0.9;

EnvironmentModel withCellsFreed(const EnvironmentModel& model, std::span<const std::size_t> cells) {
  EnvironmentModel rest = model;
  const int columns = model.geometry().columns();
  for (const std::size_t k : cells) {
    const auto column = static_cast<int>(k % static_cast<std::size_t>(columns));
    const auto row = static_cast<int>(k / static_cast<std::size_t>(columns));
    rest.set(column, row, model.probabilities()[k], 0);
  }
  return rest;
}

}  // namespace

bool WatchedEnvironment::update(const Cloud& cloud, const StaticScene& scene,
                                const Parameters& parameters) {
  const GridGeometry geometry(parameters.bounds, parameters.model.resolution,
                              parameters.model.projection);
  const bool anew = !m_exists || !(m_model.geometry() == geometry);
  if (anew) m_model = EnvironmentModel(geometry);
  m_exists = true;
  m_evidence = parameters.model.cellDepth == CellDepth::Surface
                   ? m_surfaces.extract(scene.statics, geometry)
                   : scene.statics;
  m_evidence.insert(m_evidence.end(), scene.beyond.begin(), scene.beyond.end());
  // Noise is no object, and no evidence of free space either.
  m_masked = scene.removed;
  m_masked.insert(m_masked.end(), scene.noise.begin(), scene.noise.end());
  const DepthView view(cloud);
  m_model.update(m_evidence, parameters.model, m_masked, &view);

  m_components.rebuild(m_model, parameters.filter.clusterTolerance);
  const ClearanceParameters& search = parameters.clearance;
  const bool solid = search.unknownSpace == UnknownSpace::Solid;
  m_suppressed = m_components.doubtful(m_model, {search.smallestThing, search.doubtfulThing,
                                                 certainShare * maxProbability(parameters.model)});
  std::vector<std::size_t> exempt = m_suppressed;
  if (solid) {
    const auto own = maskedAndUnobserved();
    exempt.insert(exempt.end(), own.begin(), own.end());
  }
  m_exact.rebuild(m_model, exempt, solid);
  m_observed.rebuild(m_model);
  return anew;
}

/// Cells in which only boom, tool and load were measured. Taken for solid, they would put the load
/// into an obstacle at every moment.
std::vector<std::size_t> WatchedEnvironment::maskedAndUnobserved() const {
  const GridGeometry& geometry = m_model.geometry();
  std::vector<std::size_t> cells;
  for (const Eigen::Vector3f& point : m_masked) {
    const auto cell = geometry.indexAt(point);
    if (cell && m_model.state(*cell) == CellState::NeverObserved) cells.push_back(*cell);
  }
  return cells;
}

Clearance WatchedEnvironment::clearanceOf(const OrientedBox& box,
                                          const Parameters& parameters) const {
  const auto needed = framesToEnter(parameters.model);
  if (!needed || m_model.frames() < static_cast<std::size_t>(*needed)) {
    return Clearance::unknown(Reason::NoModel);
  }
  Clearance clearance = search(box, parameters);
  addEvidence(clearance, parameters.model);
  addObservedShare(clearance, box, parameters);
  return clearance;
}

Clearance WatchedEnvironment::search(const OrientedBox& box, const Parameters& parameters) const {
  const ClearanceParameters& method = parameters.clearance;
  Clearance clearance;
  if (method.method == ClearanceMethod::Exact) {
    clearance = m_exact.query(box, method.range);
  } else if (m_suppressed.empty()) {
    clearance = rayClearance(m_model, box, method.interval, method.radius);
  } else {
    clearance =
        rayClearance(withCellsFreed(m_model, m_suppressed), box, method.interval, method.radius);
  }
  // Rays may meet a surface beyond their length, and nearer ones lie where they did not reach.
  if (searchIsShort(parameters) &&
      !(clearance.nearest && clearance.nearest->distance <= searchReach(parameters))) {
    clearance.state = ClearanceState::Unknown;
    clearance.reason = Reason::SearchTooShort;
    clearance.nearest.reset();
  }
  return clearance;
}

void WatchedEnvironment::addEvidence(Clearance& clearance,
                                     const ModelParameters& parameters) const {
  if (!clearance.nearest) return;
  Nearest& nearest = *clearance.nearest;
  const GridGeometry& geometry = m_model.geometry();
  const Eigen::Vector2d place = geometry.onPlane(nearest.onEnvironment);
  const int column = geometry.columnOf(place.x()), row = geometry.rowOf(place.y());
  if (!geometry.contains(column, row)) return;
  const int level = m_model.levels()[geometry.index(column, row)];
  // Of a cell that unknown_space makes solid only the surface was seen.
  nearest.unseen =
      level == 0 || nearest.onEnvironment.z() > geometry.zOf(level) + geometry.levelStep() / 2;
  if (nearest.unseen) return;
  clearance.evidence = m_components.evidenceAt(nearest.onEnvironment);
  if (!clearance.evidence) return;
  clearance.evidence->confidence = confidenceOf(*clearance.evidence, maxProbability(parameters));
}

void WatchedEnvironment::addObservedShare(Clearance& clearance, const OrientedBox& box,
                                          const Parameters& parameters) const {
  // With nothing in range, "clear" is a statement about the caution zone.
  const double reach = clearance.nearest
                           ? clearance.nearest->distance
                           : std::min(searchReach(parameters), parameters.warning.cautionDistance);
  const double share = m_observed.query(box, reach) * watchedDepth(box, reach, parameters.bounds);
  const bool touches = clearance.nearest && reach == 0.0;
  if (parameters.clearance.unknownSpace != UnknownSpace::Ignore && !touches &&
      share < std::max(parameters.validity.minObserved, noShare)) {
    clearance = Clearance::unknown(Reason::NothingObserved);
  }
  clearance.observedShare = share;
}

}  // namespace boomwatch
