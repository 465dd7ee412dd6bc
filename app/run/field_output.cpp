#include "run/field_output.hpp"

#include "contact/facet_search.hpp"
#include "integrator/platens.hpp"
#include "mesh/element_properties.hpp"
#include "run/crack_planes.hpp"

namespace ligament {
namespace {

constexpr int n_space = 3;

FieldArray vectors(std::string name, std::string unit, const Field<Vector>& values) {
  std::vector<double> flat;
  flat.reserve(n_space * values.size());
  for (const Vector& value : values) {
    for (const double c : to_space(value)) flat.push_back(c);
  }
  return {std::move(name), std::move(unit), n_space, std::move(flat)};
}

FieldArray numbers(std::string name, std::string unit, std::vector<double> values) {
  return {std::move(name), std::move(unit), 1, std::move(values)};
}

template <class T>
FieldArray integers(std::string name, const Field<T>& values) {
  std::vector<std::int64_t> wide;
  wide.reserve(values.size());
  for (const T value : values) wide.push_back(static_cast<std::int64_t>(value));
  return {std::move(name), "1", 1, std::move(wide)};
}

std::vector<double> points_of(const Field<Vector>& positions) {
  return std::get<std::vector<double>>(vectors("points", "m", positions).values);
}

/// v(n), between v(n-½) and v(n+½).
Field<Vector> velocities(const TranslationState& bodies) {
  Field<Vector> mean(bodies.velocity.size());
  for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = 0.5 * (bodies.velocity_before[i] + bodies.velocity[i]);
  return mean;
}

/// Both ends of the lines that stand for contacts, and what is known of each contact.
struct ContactLines {
  Field<Vector> position;
  Field<Vector> displacement;
  std::vector<double> normal_force, shear_force, opening, slip;
  Field<Index> kind;
  Field<BondState> bond;
  std::vector<double> damage, spent_energy, plane_length;
  Field<FractureMode> mode;
  Field<Vector> contact_point;

  void add(const ContactTable& contacts, std::size_t row, Index kind_of_row, const CrackPlane& plane) {
    normal_force.push_back(contacts.normal_force[row]);
    shear_force.push_back(contacts.shear_force[row]);
    opening.push_back(contacts.opening[row]);
    slip.push_back(contacts.shear_displacement[row]);
    kind.push_back(kind_of_row);
    bond.push_back(contacts.bond[row]);
    damage.push_back(plane.damage);
    spent_energy.push_back(plane.spent_energy);
    plane_length.push_back(plane.length);
    mode.push_back(plane.mode);
    contact_point.push_back(plane.centre);
  }
  void add_end(const Vector& rest, const Vector& moved) {
    position.push_back(rest);
    displacement.push_back(moved);
  }
};

ContactLines contact_lines(const Model& model, const State& state) {
  ContactLines lines;
  const auto add_all = [&]<class Pairing>(Pairing, Index kind, auto&& add_second) {
    const ContactTable& contacts = Pairing::table(state);
    for (std::size_t row = 0; row < contacts.size(); ++row) {
      lines.add(contacts, row, kind, crack_plane<Pairing>(model, state, row));
      const Index a = contacts.first[row];
      lines.add_end(model.particles.position[a], state.particles.translation.displacement[a]);
      add_second(a, contacts.second[row]);
    }
  };
  const auto& nodes = state.nodes.translation.displacement;
  add_all(ParticlePairing{}, 0, [&](Index, Index b) {
    lines.add_end(model.particles.position[b], state.particles.translation.displacement[b]);
  });
  add_all(FacetPairing{}, 1, [&](Index a, Index facet) {
    const auto& [i, j] = model.facets.nodes[facet];
    const Vector& from = model.nodes.position[i];
    const Vector& to = model.nodes.position[j];
    const FacetPlace place = place_at_facet(from, to, model.particles.position[a]);
    const double share = place.position / place.length;
    lines.add_end(from + share * (to - from), nodes[i] + share * (nodes[j] - nodes[i]));
  });
  add_all(CornerPairing{}, 2, [&](Index, Index node) { lines.add_end(model.nodes.position[node], nodes[node]); });
  return lines;
}

}  // namespace

FieldGroup particle_fields(const Model& model, const State& state) {
  FieldGroup group{.name = "particles", .cell_type = CellType::vertex, .points = points_of(model.particles.position)};
  for (std::size_t i = 0; i < model.particles.size(); ++i) group.connectivity.push_back(static_cast<std::int64_t>(i));
  group.point_data = {numbers("radius", "m", model.particles.radius),
                      vectors("displacement", "m", state.particles.translation.displacement),
                      numbers("rotation", "rad", state.particles.rotation.rotation),
                      vectors("velocity", "m/s", velocities(state.particles.translation)),
                      numbers("damage", "1", particle_damage(model, state)),
                      integers("material", model.particles.material),
                      integers("id", model.particles.id)};
  return group;
}

/// The rows of nodes of the mesh, or of the ends of walls, which come after them.
template <class T>
Field<T> part_of(const Field<T>& rows, std::size_t begin, std::size_t end) {
  return {rows.begin() + static_cast<std::ptrdiff_t>(begin), rows.begin() + static_cast<std::ptrdiff_t>(end)};
}

FieldGroup element_fields(const Model& model, const State& state) {
  const auto of_mesh = [n_mesh = model.n_mesh_nodes()](const auto& rows) { return part_of(rows, 0, n_mesh); };
  FieldGroup group{.name = "elements", .cell_type = CellType::quad, .points = points_of(of_mesh(model.nodes.position))};
  std::vector<double> strains;
  std::vector<double> stresses;
  for (std::size_t element = 0; element < model.elements.size(); ++element) {
    for (const Index node : model.elements.nodes[element]) group.connectivity.push_back(node);
    const auto [strain, stress] = element_stress(model, state.nodes.translation.displacement, element);
    strains.insert(strains.end(), strain.begin(), strain.end());
    stresses.insert(stresses.end(), stress.begin(), stress.end());
  }
  group.point_data = {vectors("displacement", "m", of_mesh(state.nodes.translation.displacement)),
                      vectors("velocity", "m/s", of_mesh(velocities(state.nodes.translation))),
                      integers("id", of_mesh(model.nodes.id))};
  group.cell_data = {{"strain", "1", n_space, std::move(strains)},
                     {"stress", "Pa", n_space, std::move(stresses)},
                     integers("material", model.elements.material),
                     integers("id", model.elements.id)};
  return group;
}

FieldGroup wall_fields(const Model& model, const State& state) {
  const auto of_walls = [&](const auto& rows) { return part_of(rows, model.n_mesh_nodes(), model.nodes.size()); };
  FieldGroup group{.name = "walls", .cell_type = CellType::line, .points = points_of(of_walls(model.nodes.position))};
  Field<Vector> reactions;
  for (std::size_t i = 0; i < group.points.size() / n_space; ++i) {
    group.connectivity.push_back(static_cast<std::int64_t>(i));
    const auto row = static_cast<Index>(model.n_mesh_nodes() + i);
    reactions.push_back(holding_force(model, state, row));
  }
  group.point_data = {vectors("displacement", "m", of_walls(state.nodes.translation.displacement)),
                      vectors("reaction", "N", reactions)};
  return group;
}

FieldGroup beam_fields(const Model& model, const State& state) {
  // The middles of platens come after the nodes of beams.
  std::size_t n_nodes = 0;
  for (const Beam& beam : model.beams) n_nodes += static_cast<std::size_t>(beam.n_nodes);
  const auto of_beams = [&](const auto& rows) { return part_of(rows, 0, n_nodes); };
  const BeamNodeState& nodes = state.beam_nodes;
  FieldGroup group{
      .name = "beams", .cell_type = CellType::line, .points = points_of(of_beams(model.beam_nodes.position))};
  for (const auto& ends : model.beam_elements.nodes) {
    for (const Index node : ends) group.connectivity.push_back(node);
  }
  group.point_data = {vectors("displacement", "m", of_beams(nodes.translation.displacement)),
                      numbers("rotation", "rad", of_beams(nodes.rotation.rotation)),
                      vectors("velocity", "m/s", of_beams(velocities(nodes.translation))),
                      integers("id", of_beams(model.beam_nodes.id))};
  return group;
}

FieldGroup contact_fields(const Model& model, const State& state) {
  ContactLines lines = contact_lines(model, state);
  FieldGroup group{.name = "contacts", .cell_type = CellType::line, .points = points_of(lines.position)};
  for (std::size_t i = 0; i < lines.position.size(); ++i) group.connectivity.push_back(static_cast<std::int64_t>(i));
  group.point_data = {vectors("displacement", "m", lines.displacement)};
  group.cell_data = {numbers("normal_force", "N", std::move(lines.normal_force)),
                     numbers("shear_force", "N", std::move(lines.shear_force)),
                     numbers("opening", "m", std::move(lines.opening)),
                     numbers("slip", "m", std::move(lines.slip)),
                     integers("kind", lines.kind),
                     integers("bond", lines.bond),
                     numbers("damage", "1", std::move(lines.damage)),
                     integers("mode", lines.mode),
                     numbers("spent_energy", "J", std::move(lines.spent_energy)),
                     vectors("contact_point", "m", lines.contact_point),
                     numbers("plane_length", "m", std::move(lines.plane_length))};
  return group;
}

FieldOutput::FieldOutput(const std::filesystem::path& folder)
    : particles_(folder, "particles"),
      elements_(folder, "elements"),
      contacts_(folder, "contacts"),
      walls_(folder, "walls"),
      beams_(folder, "beams") {}

void FieldOutput::resume(std::int64_t last_step) {
  for (FieldSeries* series : {&particles_, &elements_, &contacts_, &walls_, &beams_}) series->resume(last_step);
}

void FieldOutput::add(const Model& model, const State& state) {
  const std::int64_t step = state.clock.step;
  const double time = state.clock.time;
  const auto add_group = [&](FieldSeries& series, const FieldGroup& group) {
    series.add(step, time, vtkhdf_image(series.file_of(step), group, step, time));
  };
  if (model.particles.size() > 0) {
    add_group(particles_, particle_fields(model, state));
    add_group(contacts_, contact_fields(model, state));
  }
  if (model.elements.size() > 0) add_group(elements_, element_fields(model, state));
  if (!model.walls.empty()) add_group(walls_, wall_fields(model, state));
  if (!model.beams.empty()) add_group(beams_, beam_fields(model, state));
}

void FieldOutput::flush() {
  for (FieldSeries* series : {&particles_, &elements_, &contacts_, &walls_, &beams_}) series->flush();
}

std::size_t FieldOutput::n_waiting() const {
  return particles_.n_waiting() + elements_.n_waiting() + contacts_.n_waiting() + walls_.n_waiting() +
         beams_.n_waiting();
}

}  // namespace ligament
