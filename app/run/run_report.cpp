#include "run/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/fields.hpp"

namespace ligament {
namespace {

std::string describe_motion(const Case& input, const Simulation& simulation) {
  if (simulation.is_quasi_static()) {
    return fmt::format("increments of loading, each brought to equilibrium: {}", input.solver.method);
  }
  const double time_step = simulation.state().clock.time_step;
  if (input.solver.time_step.masses == Masses::scaled) {
    return fmt::format("Δt = {:.6g} s of pseudo-time, masses scaled to it; damping: {}", time_step,
                       input.solver.method);
  }
  return fmt::format("Δt = {:.6g} s, real masses, limited by {}; damping: {}", time_step, simulation.limiting_body(),
                     input.solver.method);
}

}  // namespace

ModelSizes model_sizes(const Model& model) {
  const auto n_facets = static_cast<Index>(model.n_element_facets());
  const auto n_nodes = static_cast<Index>(model.n_mesh_nodes());
  const auto count_below = [](const std::vector<SetupPair>& pairs, Index limit) {
    return static_cast<std::size_t>(
        std::count_if(pairs.begin(), pairs.end(), [limit](const SetupPair& pair) { return pair.second < limit; }));
  };
  // Walls are not cut from what they touch.
  const std::size_t n_cut_from_edges = model.cut_facet_pairs.size() + model.cut_corner_pairs.size();
  const std::size_t n_edge_pairs = count_below(model.facet_pairs, n_facets) + count_below(model.corner_pairs, n_nodes);
  return {.n_particles = model.particles.size(),
          .n_contacts = model.particle_pairs.size() - model.cut_particle_pairs.size(),
          .n_edge_contacts = n_edge_pairs - n_cut_from_edges,
          .n_wall_contacts = model.facet_pairs.size() + model.corner_pairs.size() - n_edge_pairs,
          .n_cut_contacts = model.cut_particle_pairs.size() + n_cut_from_edges,
          .n_elements = model.elements.size(),
          .n_nodes = model.n_mesh_nodes()};
}

std::vector<std::string> describe(const Case& input, const BuiltSimulation& built) {
  const ModelSizes sizes = model_sizes(built.simulation.model());
  std::vector<std::string> lines;
  if (!input.title.empty()) lines.push_back(input.title);
  lines.push_back(fmt::format("{} particles, {} contacts, {} edge contacts, {} elements, {} nodes", sizes.n_particles,
                              sizes.n_contacts, sizes.n_edge_contacts, sizes.n_elements, sizes.n_nodes));
  if (sizes.n_cut_contacts > 0) {
    lines.push_back(fmt::format("{} contacts are cut by notches", sizes.n_cut_contacts));
  }
  if (const auto& walls = built.simulation.model().walls; !walls.empty()) {
    const std::size_t n_seats = built.simulation.state().seat_contacts.size();
    lines.push_back(fmt::format("walls: {}, touched by {} particles", walls.size(), sizes.n_wall_contacts) +
                    (n_seats > 0 ? fmt::format("; {} nodes of elements stand on them", n_seats) : ""));
  }
  const Model& model = built.simulation.model();
  if (!model.beams.empty() || !model.platens.empty()) {
    lines.push_back(fmt::format("beams: {}, of {} elements; {} of the walls are platens", model.beams.size(),
                                model.beam_elements.size(), model.platens.size()));
  }
  for (const auto& [zone, entries] : built.reports) {
    std::string line = fmt::format("zone {}:", zone);
    for (const ReportEntry& entry : entries) line += fmt::format(" {} = {:.6g}", entry.name, entry.value);
    lines.push_back(std::move(line));
  }
  lines.push_back(describe_motion(input, built.simulation));
  return lines;
}

std::size_t memory_of(const Model& model, const State& state) {
  std::size_t bytes = model.elements.size() * (sizeof(ElementStiffness) + sizeof(std::array<Index, 4>)) +
                      model.particles.size() * (3 * sizeof(Vector) + 2 * sizeof(double)) +
                      model.nodes.size() * (2 * sizeof(Vector) + sizeof(double));
  visit_fields(state, [&]<class T>(const std::string&, const T& field, FieldRole) {
    if constexpr (requires { field.data(); }) bytes += field.size() * sizeof(field[0]);
  });
  return bytes;
}

}  // namespace ligament
