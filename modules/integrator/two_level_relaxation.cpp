#include "integrator/two_level_relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/block_sum.hpp"
#include "core/parameters.hpp"
#include "integrator/freedom_columns.hpp"
#include "integrator/move_bodies.hpp"

namespace ligament {
namespace {

constexpr const char* damping_line = "damping";

double product(const std::vector<double>& a, const std::vector<double>& b) {
  return block_sum(a.size(), [&](std::size_t i) { return a[i] * b[i]; });
}

/// Numbers between -1 and 1, the same on every machine.
std::vector<double> any_column(std::size_t size) {
  std::mt19937_64 numbers(1);
  std::vector<double> column(size);
  for (double& value : column) value = static_cast<double>(static_cast<std::int64_t>(numbers())) * 0x1p-63;
  return column;
}

/// A cell that puts two of them across the shorter side of the structure.
double default_cell(const Model& model) {
  const Rectangle extent = extent_of(model);
  const Vector size = extent.size();
  const double shorter = std::min(component(size, 0), component(size, 1));
  return shorter > 0.0 ? 0.5 * shorter : largest_component(size);
}

}  // namespace

void TwoLevelRelaxation::declare(Parameters& parameters) {
  parameters.number("smallest_damping", smallest_damping_, "lower bound of c Δt").at_least(0.0).less_than(2.0);
  parameters.number("largest_damping", largest_damping_, "upper bound of c Δt; above 2 the damping would overshoot")
      .greater_than(0.0)
      .less_than(2.0);
  parameters
      .quantity("coarse_cell", coarse_cell_, "m",
                "size of the cells of the coarse motions; default half of the shorter side of the structure")
      .greater_than(0.0);
}

void TwoLevelRelaxation::use_stiffness(const Model& model, const State& state, const StiffnessSum& stiffness) {
  const double cell = coarse_cell_ ? *coarse_cell_ : default_cell(model);
  coarse_.emplace(model, stiffness, cell);
  inverse_mass_ = inverse_masses(model, state);
  scale_ = 1.0;
  // Power iteration on M⁻¹ K; what it lacks to the largest eigenvalue is left to the margin below 4, where a step of 1
  // s becomes unstable.
  constexpr int n_iterations = 40;
  constexpr double wanted = 3.4;
  std::vector<double> motion = answer(any_column(inverse_mass_.size()));
  double largest = 0.0;
  for (int i = 0; i < n_iterations; ++i) {
    const double size = std::sqrt(product(motion, motion));
    if (!(size > 0.0)) break;
    for (double& value : motion) value /= size;
    motion = answer(stiffness.times(motion));
    largest = std::sqrt(product(motion, motion));
  }
  scale_ = largest > 0.0 ? wanted / largest : 1.0;
  for (double& value : inverse_mass_) value *= scale_;
}

std::vector<double> TwoLevelRelaxation::answer(const std::vector<double>& momenta) {
  std::vector<double> motion(momenta.size());
  for (std::size_t i = 0; i < momenta.size(); ++i) motion[i] = inverse_mass_[i] * momenta[i];
  coarse_->add_answer(momenta, scale_, motion);
  return motion;
}

void TwoLevelRelaxation::update_positions(const Model& /*model*/, State& state) const { move_bodies(state); }

double TwoLevelRelaxation::damping_of(const std::vector<double>& velocities, const std::vector<double>& forces,
                                      const RelaxationState& memory) const {
  if (memory.momentum.empty()) return smallest_damping_;
  const double stiffness =
      block_sum(forces.size(), [&](std::size_t i) { return -velocities[i] * (forces[i] - memory.force[i]); });
  const double mass = product(velocities, memory.momentum);
  const double frequency = stiffness > 0.0 && mass > 0.0 ? std::sqrt(stiffness / mass) : 0.0;
  return std::min(largest_damping_, std::max(smallest_damping_, 2.0 * frequency));
}

void TwoLevelRelaxation::update_velocities(const Model& model, State& state) {
  RelaxationState& memory = state.relaxation;
  std::vector<double> forces = free_forces(model, state);
  const double damping = damping_of(free_velocities(model, state), forces, memory);
  if (memory.momentum.empty()) memory.momentum.assign(forces.size(), 0.0);
  impulses_.resize(forces.size());
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const double before = memory.momentum[i];
    memory.momentum[i] = ((2.0 - damping) * before + 2.0 * forces[i]) / (2.0 + damping);
    impulses_[i] = memory.momentum[i] - before - forces[i];
  }
  memory.damping = damping;
  memory.force = std::move(forces);
  set_free_velocities(model, answer(memory.momentum), state);
}

void TwoLevelRelaxation::book_work(const Model& model, State& state) {
  const std::vector<double> behind = free_increments(model, state);
  const std::vector<double> ahead = free_velocities(model, state);
  state.ledger[state.ledger.open(damping_line)].book(0.5 * product(impulses_, behind), 0.5 * product(impulses_, ahead));
}

std::vector<EnergyTerm> TwoLevelRelaxation::energies(const Model& model, const State& state) const {
  const std::vector<double> before = free_velocities_before(model, state);
  return {{"kinetic_free", EnergyKind::kinetic, 0.5 * product(before, state.relaxation.momentum)},
          {"kinetic_prescribed", EnergyKind::kinetic, prescribed_kinetic_energy(model, state)},
          {"damping", EnergyKind::dissipated, 0.0 - state.ledger.total(damping_line)}};
}

}  // namespace ligament
