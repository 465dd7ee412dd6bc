#include "run/crack_record.hpp"

#include <algorithm>
#include <string>

namespace ligament {
namespace {

const std::vector<std::string> crack_columns{"time_s",    "x_m",       "y_m",      "normal_x", "normal_y",
                                             "length_m",  "mode",      "energy_J", "kind",     "first_id",
                                             "second_id", "opening_m", "slip_m"};

constexpr const char* shear_word = "shear";

bool is_broken(BondState bond) { return bond == BondState::broken; }

std::vector<SetupPair> broken_pairs(const ContactTable& contacts) {
  std::vector<SetupPair> pairs;
  for (std::size_t row = 0; row < contacts.size(); ++row) {
    if (is_broken(contacts.bond[row])) pairs.push_back({contacts.first[row], contacts.second[row]});
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Index second_id(const Model& model, const ParticlePairing& /*kind*/, Index row) { return model.particles.id[row]; }
Index second_id(const Model& model, const CornerPairing& /*kind*/, Index row) { return model.nodes.id[row]; }
/// An edge has the number of its element; walls, which are no elements, have 0.
Index second_id(const Model& model, const FacetPairing& /*kind*/, Index row) {
  const Index element = model.facets.element[row];
  return element < 0 ? 0 : model.elements.id[element];
}

template <class Pairing>
void append_row(CsvTable& table, const Model& model, const State& state, const char* kind, std::size_t row,
                const CrackPlane& plane) {
  const ContactTable& contacts = Pairing::table(state);
  const std::string_view mode = plane.mode == FractureMode::shear ? shear_word : "tension";
  const std::array<CsvCell, 13> cells{state.clock.time,
                                      component(plane.centre, 0),
                                      component(plane.centre, 1),
                                      component(plane.normal, 0),
                                      component(plane.normal, 1),
                                      plane.length,
                                      mode,
                                      plane.spent_energy,
                                      std::string_view(kind),
                                      std::int64_t{model.particles.id[contacts.first[row]]},
                                      std::int64_t{second_id(model, Pairing{}, contacts.second[row])},
                                      contacts.opening[row],
                                      contacts.shear_displacement[row]};
  table.append(state.clock.step, cells);
}

}  // namespace

CrackRecord::CrackRecord(const std::filesystem::path& path, Simulation& simulation)
    : table_(CsvTable::create(path, crack_columns)) {
  observe(simulation);
}

CrackRecord::CrackRecord(const std::filesystem::path& path, const Simulation& simulation, std::int64_t resumed_step)
    : table_(CsvTable::resume(path, crack_columns, resumed_step)),
      known_{broken_pairs(simulation.state().particle_contacts), broken_pairs(simulation.state().facet_contacts),
             broken_pairs(simulation.state().corner_contacts)},
      n_updates_(simulation.state().search.n_updates) {}

void CrackRecord::observe(Simulation& simulation) {
  observe_table<ParticlePairing>(simulation, "particles", known_[0]);
  observe_table<FacetPairing>(simulation, "edge", known_[1]);
  observe_table<CornerPairing>(simulation, "corner", known_[2]);
  n_updates_ = simulation.state().search.n_updates;
}

template <class Pairing>
void CrackRecord::observe_table(Simulation& simulation, const char* kind, Pairs& known) {
  const State& state = simulation.state();
  const ContactTable& contacts = Pairing::table(state);
  const auto n_broken = static_cast<std::size_t>(std::count_if(contacts.bond.begin(), contacts.bond.end(), is_broken));
  // What is broken stays so: as long as the list has the same rows, as many are the same.
  if (n_broken == known.size() && n_updates_ == state.search.n_updates) return;

  for (std::size_t row = 0; row < contacts.size(); ++row) {
    if (!is_broken(contacts.bond[row])) continue;
    if (std::binary_search(known.begin(), known.end(), SetupPair{contacts.first[row], contacts.second[row]})) continue;
    const CrackPlane plane = crack_plane<Pairing>(simulation.model(), state, row);
    append_row<Pairing>(table_, simulation.model(), state, kind, row, plane);
    const bool is_shear = plane.mode == FractureMode::shear;
    simulation.count_breaks(is_shear ? 0 : 1, is_shear ? 1 : 0);
  }
  known = broken_pairs(contacts);
}

std::vector<CrackPlane> read_broken_planes(const std::filesystem::path& path, std::int64_t last_step) {
  const CsvContent table = read_csv(path);
  const auto vectors = [&](const char* first, const char* second) {
    const std::vector<double> a = table.numbers(first);
    const std::vector<double> b = table.numbers(second);
    Field<Vector> values;
    for (std::size_t i = 0; i < a.size(); ++i) values.push_back(to_vector({a[i], b[i]}));
    return values;
  };
  const std::vector<double> step = table.numbers("step");
  const Field<Vector> centre = vectors("x_m", "y_m");
  const Field<Vector> normal = vectors("normal_x", "normal_y");
  const std::vector<double> length = table.numbers("length_m");
  const std::vector<double> energy = table.numbers("energy_J");
  const std::size_t mode = table.column_index("mode");
  std::vector<CrackPlane> planes;
  for (std::size_t i = 0; i < step.size() && step[i] <= static_cast<double>(last_step); ++i) {
    const bool is_shear = table.rows[i][mode] == shear_word;
    planes.push_back(
        {centre[i], normal[i], length[i], 1.0, is_shear ? FractureMode::shear : FractureMode::tension, energy[i]});
  }
  return planes;
}

std::vector<CrackPlane> planes_so_far(const std::filesystem::path& path, const Simulation& simulation) {
  std::vector<CrackPlane> planes = read_broken_planes(path, simulation.state().clock.step);
  for (const CrackPlane& plane : softening_planes(simulation.model(), simulation.state())) planes.push_back(plane);
  return planes;
}

}  // namespace ligament
