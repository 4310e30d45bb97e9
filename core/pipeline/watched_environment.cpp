#include "pipeline/watched_environment.h"

#include <algorithm>

#include "collision/nearest_pair.h"
#include "collision/ray_clearance.h"

namespace boomwatch {
namespace {

/// Unknown is not clear, even where somebody asks for no share at all.
constexpr double noShare = 1e-9;

/// Of what the probability tends to: with the thesis's values reached after 7 frames in a row.
constexpr double certainShare = 0.9;

EnvironmentModel without(const EnvironmentModel& model, std::span<const std::size_t> cells) {
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

bool WatchedEnvironment::learn(const Cloud& cloud, const StaticScene& scene,
                               const Parameters& parameters) {
  const GridGeometry geometry(parameters.bounds, parameters.model.resolution,
                              parameters.model.projection);
  const bool anew = !m_exists || !(m_model.geometry() == geometry);
  if (anew) m_model = EnvironmentModel(geometry);
  m_exists = true;
  m_evidence = parameters.model.cellDepth == CellDepth::Surface
                   ? m_surfaces.of(scene.statics, geometry)
                   : scene.statics;
  m_evidence.insert(m_evidence.end(), scene.beyond.begin(), scene.beyond.end());
  // Noise is not believed, but neither does it show that nothing is there.
  m_hidden = scene.removed;
  m_hidden.insert(m_hidden.end(), scene.noise.begin(), scene.noise.end());
  const DepthView view(cloud);
  m_model.update(m_evidence, parameters.model, m_hidden, &view);

  m_components.rebuild(m_model, parameters.filter.clusterTolerance);
  const ClearanceParameters& search = parameters.clearance;
  const bool solid = search.unknownSpace == UnknownSpace::Solid;
  m_suppressed = m_components.doubtful(m_model, {search.smallestThing, search.doubtfulThing,
                                                 certainShare * maxProbability(parameters.model)});
  std::vector<std::size_t> exempt = m_suppressed;
  if (solid) {
    const auto own = hiddenAndUnseen();
    exempt.insert(exempt.end(), own.begin(), own.end());
  }
  m_exact.rebuild(m_model, exempt, solid);
  m_observed.rebuild(m_model);
  return anew;
}

/// Cells that show nothing but boom, tool and load: that these hide what is behind them is no
/// reason to take it for an obstacle, or the load would always be in one.
std::vector<std::size_t> WatchedEnvironment::hiddenAndUnseen() const {
  const GridGeometry& geometry = m_model.geometry();
  std::vector<std::size_t> cells;
  for (const Eigen::Vector3f& point : m_hidden) {
    const auto cell = geometry.indexAt(point);
    if (cell && m_model.state(*cell) == CellState::NeverObserved) cells.push_back(*cell);
  }
  return cells;
}

Clearance WatchedEnvironment::around(const OrientedBox& box, const Parameters& parameters) const {
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
    clearance = rayClearance(without(m_model, m_suppressed), box, method.interval, method.radius);
  }
  // Rays may meet something farther away than they are long, in front of what they did not reach.
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
  // Of a cell that was taken for solid only its surface was seen.
  nearest.unseen =
      level == 0 || nearest.onEnvironment.z() > geometry.zOf(level) + geometry.levelStep() / 2;
  if (nearest.unseen) return;
  clearance.evidence = m_components.evidenceAt(nearest.onEnvironment);
  if (!clearance.evidence) return;
  clearance.evidence->confidence = confidenceOf(*clearance.evidence, maxProbability(parameters));
}

void WatchedEnvironment::addObservedShare(Clearance& clearance, const OrientedBox& box,
                                          const Parameters& parameters) const {
  // With nothing in range, "clear" promises something about the caution zone.
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
