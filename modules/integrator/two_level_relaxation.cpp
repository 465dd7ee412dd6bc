#include "integrator/two_level_relaxation.hpp"

#include "core/parameters.hpp"
#include "integrator/freedom_columns.hpp"
#include "integrator/ledger_lines.hpp"
#include "integrator/move_bodies.hpp"

namespace ligament {

void TwoLevelRelaxation::declare(Parameters& parameters) {
  bounds_.declare(parameters);
  parameters
      .quantity("coarse_cell", coarse_cell_, "m",
                "size of the cells of the coarse motions; default half of the shorter side of the structure")
      .greater_than(0.0);
}

void TwoLevelRelaxation::use_stiffness(const Model& model, const State& state, const StiffnessSum& stiffness) {
  bounds_.check();
  mass_.emplace(model, state, stiffness, coarse_cell_);
}

StepTravel TwoLevelRelaxation::update_positions(const Model& /*model*/, State& state) const {
  return move_bodies(state);
}

void TwoLevelRelaxation::update_velocities(const Model& model, State& state) {
  RelaxationState& memory = state.relaxation;
  std::vector<double> forces = free_forces(model, state);
  memory.damping = bounds_.smallest;
  if (memory.momentum.empty()) {
    memory.momentum.assign(forces.size(), 0.0);
  } else {
    memory.damping = adaptive_damping(free_velocities(model, state), memory.momentum, forces, memory.force, bounds_);
  }
  drag_ = memory.momentum;
  update_momenta(memory.momentum, forces, memory.damping);
  for (std::size_t i = 0; i < drag_.size(); ++i) drag_[i] = memory.momentum[i] - drag_[i] - forces[i];
  memory.force = std::move(forces);
  set_free_velocities(model, mass_->velocities(memory.momentum), state);
}

void TwoLevelRelaxation::book_work(const Model& model, State& state) {
  const std::vector<double> behind = free_increments(model, state);
  const std::vector<double> ahead = free_velocities(model, state);
  state.ledger[state.ledger.open(ledger_lines::damping)].book(0.5 * product(drag_, behind),
                                                              0.5 * product(drag_, ahead));
}

std::vector<EnergyTerm> TwoLevelRelaxation::energies(const Model& model, const State& state) const {
  const std::vector<double> before = free_velocities_before(model, state);
  return {{"kinetic_free", EnergyKind::kinetic, 0.5 * product(before, state.relaxation.momentum)},
          {"kinetic_prescribed", EnergyKind::kinetic, prescribed_kinetic_energy(model, state)},
          {"damping", EnergyKind::dissipated, 0.0 - state.ledger.total(ledger_lines::damping)}};
}

}  // namespace ligament
