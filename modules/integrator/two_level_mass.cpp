#include "integrator/two_level_mass.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "integrator/freedom_columns.hpp"

namespace ligament {
namespace {

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

TwoLevelMass::TwoLevelMass(const Model& model, const State& state, const StiffnessSum& stiffness,
                           std::optional<double> coarse_cell)
    : coarse_(model, stiffness, coarse_cell ? *coarse_cell : default_cell(model)),
      inverse_mass_(inverse_masses(model, state)) {
  // Power iteration on M⁻¹ K; what it lacks to the largest eigenvalue is left to the margin below 4, where a step of 1
  // s becomes unstable.
  constexpr int n_iterations = 40;
  constexpr double wanted = 3.4;
  std::vector<double> motion = velocities(any_column(inverse_mass_.size()));
  double largest = 0.0;
  for (int i = 0; i < n_iterations; ++i) {
    const double size = std::sqrt(product(motion, motion));
    if (!(size > 0.0)) break;
    for (double& value : motion) value /= size;
    motion = velocities(stiffness.times(motion));
    largest = std::sqrt(product(motion, motion));
  }
  if (!(largest > 0.0)) return;
  scale_ = wanted / largest;
  for (double& value : inverse_mass_) value *= scale_;
}

std::vector<double> TwoLevelMass::velocities(const std::vector<double>& momenta) {
  std::vector<double> motion(momenta.size());
  for (std::size_t i = 0; i < momenta.size(); ++i) motion[i] = inverse_mass_[i] * momenta[i];
  coarse_.add_answer(momenta, scale_, motion);
  return motion;
}

}  // namespace ligament
