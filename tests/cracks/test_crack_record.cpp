#include <doctest/doctest.h>

#include <optional>
#include <utility>

#include "../io/scratch_folder.hpp"
#include "constitutive/mohr_coulomb_brittle.hpp"
#include "core/state_hash.hpp"
#include "io/atomic_file.hpp"
#include "run/crack_record.hpp"
#include "run/field_output.hpp"
#include "support/hand_made_model.hpp"
#include "support/hand_made_simulation.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr double radius = 0.1;

std::filesystem::path table_path(const std::string& name) {
  return test::scratch_folder("cracks_" + name) / "cracks.csv";
}

/// Four discs in a row along x that just touch, with brittle bonds; the thickness is 0.5 m.
Simulation row_of_discs() {
  Model model = empty_model({.thickness = 0.5});
  MohrCoulombBrittle law;
  law.tensile_strength = 1e6;
  law.cohesion = 2e6;
  law.friction_coefficient = 0.3;
  model.laws[bond_law] = {"rock.bond", std::make_shared<BatchLaw<MohrCoulombBrittle>>(law),
                          MohrCoulombBrittle::n_history};
  for (int i = 0; i < 4; ++i) add_particle(model, {2.0 * radius * i, 0.0}, radius);
  return make_simulation(std::move(model));
}

/// A step in which one disc moves by this much, and all others rest.
void move(Simulation& simulation, Index particle, const Vector& displacement) {
  State state = simulation.state();
  for (Vector& velocity : state.particles.translation.velocity) velocity = {};
  for (Spin& spin : state.particles.rotation.spin) spin = 0.0;
  state.particles.translation.velocity[particle] = displacement / state.clock.time_step;
  simulation.restore(std::move(state));
  simulation.step();
}

}  // namespace

TEST_CASE("a bond pulled apart is a row of the table, once") {
  Simulation simulation = row_of_discs();
  const auto path = table_path("pulled");
  CrackRecord record(path, simulation);
  move(simulation, 3, {1e-4, 0.0});
  record.observe(simulation);
  record.table().flush();
  CHECK(read_csv(path).rows.empty());

  // The last of the discs: one bond breaks.
  move(simulation, 3, {4e-4, 0.0});
  record.observe(simulation);
  record.observe(simulation);
  record.table().flush();
  const CsvContent table = read_csv(path);
  REQUIRE(table.rows.size() == 1);
  CHECK(table.numbers("step")[0] == 2);
  CHECK(table.numbers("time_s")[0] == simulation.state().clock.time);
  CHECK(table.numbers("x_m")[0] == doctest::Approx(5.0 * radius + 2.5e-4).epsilon(1e-6));
  CHECK(table.numbers("y_m")[0] == doctest::Approx(0.0));
  CHECK(table.numbers("normal_x")[0] == doctest::Approx(1.0));
  CHECK(table.numbers("length_m")[0] == doctest::Approx(2.0 * radius));
  CHECK(table.numbers("opening_m")[0] == doctest::Approx(5e-4).epsilon(1e-6));
  CHECK(table.numbers("slip_m")[0] == doctest::Approx(0.0));
  CHECK(table.rows[0][table.column_index("mode")] == "tension");
  CHECK(table.rows[0][table.column_index("kind")] == "particles");
  CHECK(table.numbers("first_id")[0] == 3);
  CHECK(table.numbers("second_id")[0] == 4);
  double fracture = 0.0;
  for (const EnergyTerm& term : simulation.energies()) {
    if (term.name == "fracture_tension") fracture = term.value;
  }
  CHECK(fracture > 0.0);
  CHECK(table.numbers("energy_J")[0] == doctest::Approx(fracture).epsilon(1e-14));
  CHECK(simulation.state().cracks.n_tension == 1);
  CHECK(simulation.state().cracks.n_shear == 0);
}

TEST_CASE("a disc pushed across breaks its bonds in shear") {
  Simulation simulation = row_of_discs();
  const auto path = table_path("sheared");
  CrackRecord record(path, simulation);
  move(simulation, 3, {0.0, 2e-3});
  record.observe(simulation);
  record.table().flush();
  const CsvContent table = read_csv(path);
  REQUIRE(table.rows.size() == 1);
  CHECK(table.rows[0][table.column_index("mode")] == "shear");
  CHECK(table.numbers("slip_m")[0] == doctest::Approx(2e-3).epsilon(1e-3));
  CHECK(simulation.state().cracks.n_shear == 1);
  const auto planes = read_broken_planes(path, 1);
  REQUIRE(planes.size() == 1);
  CHECK(planes[0].mode == FractureMode::shear);
  CHECK(planes[0].damage == 1.0);
  CHECK(read_broken_planes(path, 0).empty());
}

TEST_CASE("breaks stay counted when their contacts leave the list, and a resumed record goes on as if never stopped") {
  Simulation simulation = row_of_discs();
  const auto whole_path = table_path("whole");
  const auto path = table_path("resumed");
  CrackRecord whole(whole_path, simulation);
  // Watches the same run, but does not count: that is done once.
  std::optional<CrackRecord> record(std::in_place, path, simulation);
  const auto observe = [&] {
    const State before = simulation.state();
    record->observe(simulation);
    record->table().flush();
    simulation.restore(before);
    whole.observe(simulation);
    whole.table().flush();
  };
  move(simulation, 3, {5e-4, 0.0});
  observe();
  CHECK(simulation.state().particle_contacts.size() == 3);
  // So far away that the search drops the contact; another bond breaks in the same step.
  move(simulation, 3, {0.1, 0.0});
  move(simulation, 0, {-5e-4, 0.0});
  observe();
  CHECK(simulation.state().particle_contacts.size() == 2);
  CHECK(simulation.state().cracks.n_broken() == 2);

  record.emplace(path, std::as_const(simulation), simulation.state().clock.step);
  observe();
  CHECK(read_csv(whole_path).rows.size() == 2);
  move(simulation, 1, {-2e-3, 0.0});
  observe();
  CHECK(simulation.state().cracks.n_broken() == 3);
  CHECK(read_file(path) == read_file(whole_path));
}

TEST_CASE("counting breaks does not change the hash of the state") {
  Simulation simulation = row_of_discs();
  const std::string before = state_hash(simulation.state());
  simulation.count_breaks(3, 4);
  CHECK(simulation.state().cracks.n_broken() == 7);
  CHECK(state_hash(simulation.state()) == before);
}

TEST_CASE("fields show the damage of contacts and of the particles they hold") {
  Simulation simulation = row_of_discs();
  move(simulation, 3, {1e-4, 0.0});
  move(simulation, 3, {4e-4, 0.0});
  const auto values = [](const std::vector<FieldArray>& arrays, const std::string& name) {
    const auto found =
        std::find_if(arrays.begin(), arrays.end(), [&](const auto& array) { return array.name == name; });
    REQUIRE(found != arrays.end());
    return found->values;
  };
  const FieldGroup particles = particle_fields(simulation.model(), simulation.state());
  CHECK(std::get<0>(values(particles.point_data, "damage")) == std::vector<double>{0.0, 0.0, 1.0, 1.0});
  const FieldGroup contacts = contact_fields(simulation.model(), simulation.state());
  CHECK(std::get<0>(values(contacts.cell_data, "damage")) == std::vector<double>{0.0, 0.0, 1.0});
  CHECK(std::get<1>(values(contacts.cell_data, "mode")) == std::vector<std::int64_t>{0, 0, 1});
  const auto spent = std::get<0>(values(contacts.cell_data, "spent_energy"));
  CHECK(spent[0] == 0.0);
  CHECK(spent[2] > 0.0);
  const auto point = std::get<0>(values(contacts.cell_data, "contact_point"));
  CHECK(point[0] == doctest::Approx(radius));
  CHECK(std::get<0>(values(contacts.cell_data, "plane_length"))[0] == doctest::Approx(2.0 * radius));
}
