#include "build/build_simulation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "build/build_gauges.hpp"
#include "build/select_bodies.hpp"
#include "build/unsupported_bodies.hpp"
#include "contact/contact_forces.hpp"
#include "contact/grid_contact_detector.hpp"
#include "integrator/central_difference.hpp"
#include "integrator/gravity.hpp"
#include "integrator/loads.hpp"
#include "integrator/prescribed_motion.hpp"
#include "mesh/element_forces.hpp"

namespace ligament {
namespace {

/// Axis of a translation, or `dimension` for the rotation.
int axis_of(const std::string& name) { return name == "x" ? 0 : name == "y" ? 1 : dimension; }

void add_freedoms(const SelectedBodies& bodies, PrescribedFreedom freedom, std::vector<PrescribedFreedom>& freedoms) {
  if (freedom.axis < dimension) {
    freedom.body = PrescribedFreedom::Body::node;
    for (const Index row : bodies.nodes) {
      freedom.row = row;
      freedoms.push_back(freedom);
    }
  }
  freedom.body = PrescribedFreedom::Body::particle;
  for (const Index row : bodies.particles) {
    freedom.row = row;
    freedoms.push_back(freedom);
  }
}

/// Two tables that prescribe one freedom cannot both have their way; supports that repeat each other can.
void check_conflicts(Case& input, const TableView& view, const std::vector<PrescribedFreedom>& earlier,
                     const std::vector<PrescribedFreedom>& later) {
  for (const PrescribedFreedom& a : later) {
    const bool is_taken = std::any_of(earlier.begin(), earlier.end(), [&](const PrescribedFreedom& b) {
      return a.body == b.body && a.row == b.row && a.axis == b.axis;
    });
    if (!is_taken) continue;
    input.file.add_error(
        input.file.position(view),
        fmt::format("a freedom is prescribed twice: another table holds or moves it too {}", view.where()));
    return;
  }
}

std::vector<PrescribedFreedom> support_freedoms(Case& input, const Model& model) {
  std::vector<PrescribedFreedom> freedoms;
  for (const auto& [table, view] : input.supports) {
    const SelectedBodies bodies = select_bodies(model, table.bodies, input.file, view);
    for (const std::string& name : table.fix) add_freedoms(bodies, {.axis = axis_of(name)}, freedoms);
  }
  const auto key = [](const PrescribedFreedom& f) { return std::tuple(f.body, f.row, f.axis); };
  std::sort(freedoms.begin(), freedoms.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  freedoms.erase(
      std::unique(freedoms.begin(), freedoms.end(), [&](const auto& a, const auto& b) { return key(a) == key(b); }),
      freedoms.end());
  return freedoms;
}

std::vector<PrescribedFreedom> all_freedoms(Case& input, const Model& model) {
  std::vector<PrescribedFreedom> freedoms = support_freedoms(input, model);
  for (const auto& [table, view] : input.motions) {
    std::vector<PrescribedFreedom> moved;
    add_freedoms(select_bodies(model, table.bodies, input.file, view),
                 {.axis = axis_of(table.direction),
                  .velocity = table.velocity,
                  .rise_time = table.rise_time,
                  .stop_time = table.stop_time.value_or(-1.0)},
                 moved);
    check_conflicts(input, view, freedoms, moved);
    freedoms.insert(freedoms.end(), moved.begin(), moved.end());
  }
  return freedoms;
}

std::vector<PointLoad> point_loads(Case& input, const Model& model) {
  std::vector<PointLoad> loads;
  for (const auto& [table, view] : input.loads) {
    const SelectedBodies bodies = select_bodies(model, table.bodies, input.file, view);
    PointLoad load{.force = to_vector(table.force), .rise_time = table.rise_time};
    for (const Index row : bodies.nodes) {
      load.row = row;
      loads.push_back(load);
    }
    load.body = PointLoad::Body::particle;
    for (const Index row : bodies.particles) {
      load.row = row;
      loads.push_back(load);
    }
  }
  return loads;
}

double skin_of(const Case& input, const Model& model) {
  if (input.contact.skin) return *input.contact.skin;
  const auto& radii = model.particles.radius;
  // Without particles there is no contact whose list could be stale.
  return radii.empty() ? 1.0 : 0.25 * *std::min_element(radii.begin(), radii.end());
}

std::vector<std::unique_ptr<ForceProvider>> force_providers(Case& input, const Model& model) {
  std::vector<std::unique_ptr<ForceProvider>> providers;
  providers.push_back(std::make_unique<ContactForces<ParticlePairing>>());
  providers.push_back(std::make_unique<ContactForces<FacetPairing>>());
  providers.push_back(std::make_unique<ContactForces<CornerPairing>>());
  providers.push_back(std::make_unique<ElementForces>());
  providers.push_back(std::make_unique<AppliedLoads>(point_loads(input, model)));
  if (const Vector gravity = to_vector(input.problem.gravity); gravity != Vector{}) {
    providers.push_back(std::make_unique<Gravity>(gravity));
  }
  return providers;
}

void check_supports(Case& input, const Simulation& simulation) {
  if (input.solver.method == "undamped") return;
  for (const std::string& body : find_unsupported_bodies(simulation.model(), simulation.state())) {
    input.file.add_error({}, body + ": add a [[support]]");
  }
  input.file.throw_collected_errors();
}

}  // namespace

BuiltSimulation build_simulation(Case& input) {
  BuiltModel built = build_model(input);
  auto motion = std::make_unique<PrescribedMotion>(all_freedoms(input, built.model));
  motion->fix(built.model);

  Modules modules;
  modules.integrator = std::make_unique<CentralDifference>(std::move(input.solver.damping));
  modules.contact_detector = std::make_unique<GridContactDetector>(skin_of(input, built.model));
  modules.force_providers = force_providers(input, built.model);
  modules.constraints.push_back(std::move(motion));
  std::vector<Gauge> gauges = build_gauges(input, built.model);
  input.file.throw_collected_errors();

  BuiltSimulation result{Simulation(std::move(built.model), std::move(modules), input.solver.time_step),
                         std::move(gauges),
                         std::move(built.reports),
                         {}};
  check_supports(input, result.simulation);
  return result;
}

}  // namespace ligament
