#include "build/build_simulation.hpp"

#include <algorithm>

#include "build/build_control.hpp"
#include "build/build_gauges.hpp"
#include "build/build_notches.hpp"
#include "build/build_walls.hpp"
#include "build/check_contacts.hpp"
#include "build/unsupported_bodies.hpp"
#include "contact/contact_forces.hpp"
#include "contact/grid_contact_detector.hpp"
#include "integrator/gravity.hpp"
#include "mesh/beam_forces.hpp"
#include "mesh/element_forces.hpp"

namespace ligament {
namespace {

double skin_of(const Case& input, const Model& model) {
  if (input.contact.skin) return *input.contact.skin;
  const auto& radii = model.particles.radius;
  // Without particles there is no contact whose list could be stale.
  return radii.empty() ? 1.0 : 0.25 * *std::min_element(radii.begin(), radii.end());
}

std::vector<std::unique_ptr<ForceProvider>> force_providers(const Case& input, std::vector<PointLoad> loads) {
  std::vector<std::unique_ptr<ForceProvider>> providers;
  providers.push_back(std::make_unique<ContactForces<ParticlePairing>>());
  providers.push_back(std::make_unique<ContactForces<FacetPairing>>());
  providers.push_back(std::make_unique<ContactForces<CornerPairing>>());
  providers.push_back(std::make_unique<ContactForces<SeatPairing>>());
  providers.push_back(std::make_unique<ElementForces>());
  if (!input.beams.empty()) providers.push_back(std::make_unique<BeamForces>());
  providers.push_back(std::make_unique<AppliedLoads>(std::move(loads)));
  if (const Vector gravity = to_vector(input.problem.gravity); gravity != Vector{}) {
    providers.push_back(std::make_unique<Gravity>(gravity));
  }
  return providers;
}

void check_supports(Case& input, const Simulation& simulation) {
  if (input.solver.method == "undamped") return;
  for (const std::string& body : find_unsupported_bodies(simulation.model(), simulation.state())) {
    input.file.add_error({}, body);
  }
}

}  // namespace

BuiltSimulation build_simulation(Case& input) {
  BuiltModel built = build_model(input);
  Conditions conditions = build_conditions(input, built.model);
  auto motion = std::make_unique<PrescribedMotion>(conditions.freedoms);
  motion->fix(built.model);

  Modules modules;
  modules.integrator = std::move(input.solver.integrator);
  modules.loading = std::move(input.solver.loading);
  if (modules.loading) {
    modules.loading->set_loading(conditions.freedoms, conditions.corners, *input.solver.unbalanced_force_ratio);
  }
  modules.contact_detector = std::make_unique<GridContactDetector>(skin_of(input, built.model));
  modules.force_providers = force_providers(input, std::move(conditions.loads));
  modules.constraints.push_back(std::move(motion));
  std::vector<Gauge> gauges = build_gauges(input, built.model);
  std::vector<StopCriterion> stops = build_stop_criteria(input, gauges);
  const std::optional<UniaxialTest> uniaxial = build_uniaxial_test(input, gauges);
  if (modules.loading) set_control(input, gauges, *modules.loading);
  input.file.throw_collected_errors();

  BuiltSimulation result{
      .simulation = Simulation(std::move(built.model), std::move(modules), input.solver.time_step),
      .gauges = std::move(gauges),
      .reports = std::move(built.reports),
      .freedoms = std::move(conditions.freedoms),
      .end_of_loading = ends_of_loading(conditions.corners),
      .stops = std::move(stops),
      .pieces = {},
      .uniaxial = uniaxial,
      .warnings = std::move(conditions.warnings),
  };
  if (input.stop && input.stop->table.cut_off_share) {
    result.pieces.emplace(result.simulation.model(), result.simulation.state());
  }
  result.simulation.open_stages(result.end_of_loading.size(), result.gauges.size());
  check_contacts(input, result.simulation.model(), result.simulation.state());
  refuse_idle_notches(input, result.simulation.model());
  refuse_idle_walls(input, result.simulation.model(), result.simulation.state());
  check_supports(input, result.simulation);
  input.file.throw_collected_errors();
  return result;
}

}  // namespace ligament
