#pragma once

#include "constitutive/mohr_coulomb_bilinear.hpp"
#include "integrator/register_methods.hpp"
#include "support/hand_made_model.hpp"
#include "support/hand_made_simulation.hpp"

/// A row of discs with bonds that soften, pulled apart in increments.
namespace ligament::support {

inline constexpr double radius = 0.01;
inline constexpr double strength = 2e6;
inline constexpr double fracture_energy = 40.0;

inline std::unique_ptr<IncrementalLoading> make_loading(const std::string& method,
                                                        std::vector<PrescribedFreedom> freedoms,
                                                        std::vector<std::vector<double>> corners,
                                                        const std::string& key, const ParameterValue& value) {
  auto result = loading_methods().create(method);
  Parameters parameters;
  result->declare(parameters);
  for (Parameter& parameter : parameters.list()) {
    if (parameter.name == "increment") parameter.assign(1e-6);
    if (parameter.name == key) parameter.assign(value);
  }
  result->set_loading(std::move(freedoms), std::move(corners), 1e-6);
  return result;
}

/// A row of discs that touch, the first one held, the last one moved along the row in one stage of 1 s.
struct Row {
  Simulation simulation;

  Row(int n_discs, double displacement, std::vector<StageVelocity> motions = {}, const std::string& key = "increment",
      const ParameterValue& value = 1e-6, const std::string& method = "quasi_static",
      std::vector<SpringTerm> gauge = {})
      : simulation(make(n_discs, displacement, std::move(motions), key, value, method, std::move(gauge))) {
    simulation.open_stages(2, 0);
  }

  static Simulation make(int n_discs, double displacement, std::vector<StageVelocity> motions, const std::string& key,
                         const ParameterValue& value, const std::string& method, std::vector<SpringTerm> gauge) {
    MohrCoulombBilinear law;
    law.tensile_strength = strength;
    law.cohesion = 10.0 * strength;
    law.fracture_energy_tension = fracture_energy;
    law.fracture_energy_shear = 10.0 * fracture_energy;
    Model model = empty_model({.young_modulus = 20e9});
    model.laws[bond_law] = {"rock.bond", std::make_shared<BatchLaw<MohrCoulombBilinear>>(law),
                            MohrCoulombBilinear::n_history};
    // The first bond of a longer row is the weakest.
    const double first_radius = n_discs > 30 ? 0.8 * radius : radius;
    add_particle(model, {radius - first_radius, 0.0}, first_radius);
    for (int i = 1; i < n_discs; ++i) add_particle(model, {2.0 * radius * i, 0.0}, radius);
    if (motions.empty()) motions = {{.velocity = displacement, .stop_time = 1.0}};
    std::vector<PrescribedFreedom> freedoms = held_particle(0);
    for (const PrescribedFreedom& held : held_particle(static_cast<Index>(n_discs - 1))) freedoms.push_back(held);
    freedoms[3].motions = motions;
    std::vector<std::vector<double>> corners;
    for (const StageVelocity& motion : motions) {
      corners.push_back(motion.schedule.empty() ? std::vector<double>{1.0} : motion.schedule.times);
    }
    PrescribedMotion constraint(freedoms);
    constraint.fix(model);
    Modules modules;
    modules.loading = make_loading(method, freedoms, corners, key, value);
    modules.loading->set_control(std::move(gauge));
    modules.contact_detector = std::make_unique<GridContactDetector>(1e-3);
    modules.force_providers.push_back(std::make_unique<ContactForces<ParticlePairing>>());
    modules.constraints.push_back(std::make_unique<PrescribedMotion>(std::move(constraint)));
    return {std::move(model), std::move(modules), {.masses = Masses::scaled}};
  }

  [[nodiscard]] const State& state() const { return simulation.state(); }
  [[nodiscard]] double pull() const { return -state().particle_contacts.normal_force[0]; }
  [[nodiscard]] double extension() const { return state().particles.translation.displacement.back().x; }
  [[nodiscard]] double area() const { return state().particle_contacts.area[0]; }
  [[nodiscard]] double stiffness() const { return state().particle_contacts.normal_stiffness[0]; }
};

/// Force of the one-fourth curve at an opening, per area (Pa).
inline double softened_strength(double w) {
  const double kink = 0.75 * fracture_energy / strength;
  const double end = 5.0 * fracture_energy / strength;
  if (w <= kink) return strength * (1.0 - 0.75 * w / kink);
  return w >= end ? 0.0 : 0.25 * strength * (end - w) / (end - kink);
}

}  // namespace ligament::support
