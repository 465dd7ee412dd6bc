#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "contact/contact_forces.hpp"
#include "contact/grid_contact_detector.hpp"
#include "integrator/central_difference.hpp"
#include "integrator/gravity.hpp"
#include "integrator/loads.hpp"
#include "integrator/no_damping.hpp"
#include "integrator/prescribed_motion.hpp"
#include "mesh/beam_forces.hpp"
#include "mesh/element_forces.hpp"
#include "simulation.hpp"

/// Simulations put together from modules, undamped with real masses unless told otherwise.
namespace ligament::support {

struct SimulationChoice {
  double skin = 1e-3;  ///< (m)
  TimeStepChoice time_step{.masses = Masses::real, .factor = 0.1};
  std::unique_ptr<Integrator> integrator = {};  ///< in place of central differences
  std::unique_ptr<Damping> damping = std::make_unique<NoDamping>();
  std::vector<PointLoad> loads = {};
  std::vector<PrescribedFreedom> prescribed = {};
  std::optional<Vector> gravity = {};
};

inline Simulation make_simulation(Model model, SimulationChoice choice = {}) {
  Modules modules;
  modules.integrator =
      choice.integrator ? std::move(choice.integrator) : std::make_unique<CentralDifference>(std::move(choice.damping));
  modules.contact_detector = std::make_unique<GridContactDetector>(choice.skin);
  modules.force_providers.push_back(std::make_unique<ContactForces<ParticlePairing>>());
  modules.force_providers.push_back(std::make_unique<ContactForces<FacetPairing>>());
  modules.force_providers.push_back(std::make_unique<ContactForces<CornerPairing>>());
  modules.force_providers.push_back(std::make_unique<ContactForces<SeatPairing>>());
  if (model.elements.size() > 0) modules.force_providers.push_back(std::make_unique<ElementForces>());
  if (model.beam_elements.size() > 0) modules.force_providers.push_back(std::make_unique<BeamForces>());
  if (!choice.loads.empty()) {
    modules.force_providers.push_back(std::make_unique<AppliedLoads>(std::move(choice.loads)));
  }
  if (choice.gravity) modules.force_providers.push_back(std::make_unique<Gravity>(*choice.gravity));
  auto motion = std::make_unique<PrescribedMotion>(std::move(choice.prescribed));
  motion->fix(model);
  modules.constraints.push_back(std::move(motion));
  return {std::move(model), std::move(modules), choice.time_step};
}

/// Sets one body in motion: v(n-½) = v(n+½) = velocity.
inline void set_velocity(Simulation& simulation, Index particle, const Vector& velocity, Spin spin = 0.0) {
  State state = simulation.state();
  state.particles.translation.velocity_before[particle] = state.particles.translation.velocity[particle] = velocity;
  state.particles.rotation.spin_before[particle] = state.particles.rotation.spin[particle] = spin;
  simulation.restore(std::move(state));
}

/// Displaces one body, as if it had been there before.
inline void set_displacement(Simulation& simulation, Index particle, const Vector& displacement) {
  State state = simulation.state();
  state.particles.translation.displacement[particle] = displacement;
  simulation.restore(std::move(state));
}

/// A term of the ledger (J). Throws std::out_of_range if there is none of that name.
inline double energy(const Simulation& simulation, const std::string& name) {
  for (const EnergyTerm& term : simulation.energies()) {
    if (term.name == name) return term.value;
  }
  throw std::out_of_range("the ledger has no line '" + name + "'");
}

/// Both coordinates of a node, or of a particle and its rotation, held.
inline std::vector<PrescribedFreedom> held_node(Index row) {
  using Body = PrescribedFreedom::Body;
  return {{.body = Body::node, .row = row, .axis = 0}, {.body = Body::node, .row = row, .axis = 1}};
}
/// Both ends of a wall, moved at this velocity.
inline std::vector<PrescribedFreedom> moved_wall(const Model& model, std::size_t wall, const Vector& velocity) {
  std::vector<PrescribedFreedom> freedoms;
  for (const Index node : model.wall_nodes(wall)) {
    for (int axis = 0; axis < dimension; ++axis) {
      freedoms.push_back({.row = node, .axis = axis, .motions = {{.velocity = component(velocity, axis)}}});
    }
  }
  return freedoms;
}

inline std::vector<PrescribedFreedom> held_particle(Index row) {
  using Body = PrescribedFreedom::Body;
  return {{.body = Body::particle, .row = row, .axis = 0},
          {.body = Body::particle, .row = row, .axis = 1},
          {.body = Body::particle, .row = row, .axis = dimension}};
}

}  // namespace ligament::support
