#include "integrator/gravity.hpp"

#include "core/block_sum.hpp"
#include "core/parallel.hpp"

namespace ligament {
namespace {

void add_weight(const Field<double>& mass, const Vector& acceleration, Field<Vector>& force) {
  parallel_bodies(mass.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) force[i] += mass[i] * acceleration;
  });
}

/// A constant force: its work is a function of the displacement.
double work(const Field<double>& mass, const Vector& acceleration, const Field<Vector>& displacement) {
  return block_sum(mass.size(), [&](std::size_t i) { return mass[i] * dot(acceleration, displacement[i]); });
}

}  // namespace

void Gravity::add_forces(const Model& model, State& state) {
  add_weight(model.particles.real_mass, acceleration_, state.particles.translation.force);
  add_weight(model.nodes.real_mass, acceleration_, state.nodes.translation.force);
  add_weight(model.beam_nodes.real_mass, acceleration_, state.beam_nodes.translation.force);
}

std::vector<EnergyTerm> Gravity::energies(const Model& model, const State& state) const {
  return {{"gravity", EnergyKind::work,
           work(model.particles.real_mass, acceleration_, state.particles.translation.displacement) +
               work(model.nodes.real_mass, acceleration_, state.nodes.translation.displacement) +
               work(model.beam_nodes.real_mass, acceleration_, state.beam_nodes.translation.displacement)}};
}

}  // namespace ligament
