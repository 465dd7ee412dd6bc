#include "integrator/loads.hpp"

#include <algorithm>
#include <limits>

#include "integrator/ledger_lines.hpp"

namespace ligament {
namespace {

using ledger_lines::applied_loads;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Share of the load that acts at time n.
double share_at(const PointLoad& load, const State& state) {
  if (state.stage.number < load.stage) return 0.0;
  const double time = state.stage.number > load.stage ? infinite : state.clock.time - state.stage.begin_time;
  if (!load.schedule.empty()) return load.schedule.value(time);
  return load.rise_time > 0.0 ? std::min(1.0, time / load.rise_time) : 1.0;
}

}  // namespace

void AppliedLoads::add_forces(const Model& /*model*/, State& state) {
  for (const PointLoad& load : loads_) {
    const double share = share_at(load, state);
    translation_of(state, load.body).force[load.row] += share * load.force;
    if (load.body != BodyTable::node) rotation_of(state, load.body).moment[load.row] += share * load.moment;
  }
}

void AppliedLoads::book_work(const Model& /*model*/, State& state) {
  double behind = 0.0;
  double ahead = 0.0;
  const double time_step = state.clock.time_step;
  for (const PointLoad& load : loads_) {
    const TranslationState& bodies = translation_of(state, load.body);
    const double share = share_at(load, state);
    const Vector force = share * load.force;
    behind += 0.5 * dot(force, bodies.increment[load.row]);
    ahead += 0.5 * time_step * dot(force, bodies.velocity[load.row]);
    if (load.body == BodyTable::node) continue;
    const RotationState& rotation = rotation_of(state, load.body);
    behind += 0.5 * share * load.moment * rotation.increment[load.row];
    ahead += 0.5 * time_step * share * load.moment * rotation.spin[load.row];
  }
  state.ledger[state.ledger.open(applied_loads)].book(behind, ahead);
}

std::vector<EnergyTerm> AppliedLoads::energies(const Model& /*model*/, const State& state) const {
  return {{applied_loads, EnergyKind::work, state.ledger.total(applied_loads)}};
}

}  // namespace ligament
