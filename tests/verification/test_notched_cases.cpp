#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>

#include "../io/scratch_folder.hpp"
#include "build/build_simulation.hpp"
#include "run/run_report.hpp"

using namespace ligament;

namespace {

const std::string no_notch = LIGAMENT_SOURCE_DIR "/tests/wrong_input/good.toml";

/// The model of a plate of 3 × 3 elements of 1 m with particles in place of two of them (x 1-2, y 0-2), set up.
Model built_with(const std::string& notches) {
  const auto path = test::scratch_folder("notched_cases") / "case.toml";
  const std::ifstream good(no_notch);
  std::ofstream(path) << good.rdbuf() << '\n' << notches;
  Case input = read_case(path, {});
  return build_simulation(input).simulation.model();
}

std::string notch(const std::string& from, const std::string& to, const std::string& width) {
  return "[[notch]]\nname = \"n\"\nfrom = " + from + "\nto = " + to + "\nwidth = \"" + width + "\"\n";
}

}  // namespace

TEST_CASE("a cut without width takes nothing away, and its contacts do not count as bonds") {
  const Model whole = built_with("");
  const Model cut = built_with(notch("[\"1.51 m\", \"0 m\"]", "[\"1.51 m\", \"1 m\"]", "0 m"));
  const ModelSizes before = model_sizes(whole);
  const ModelSizes after = model_sizes(cut);
  CHECK(after.n_particles == before.n_particles);
  CHECK(after.n_elements == before.n_elements);
  CHECK(cut.particle_pairs == whole.particle_pairs);
  // Rows of discs of radius 0.05 over a length of 1 m, one or two branches each.
  CHECK(after.n_cut_contacts >= 10);
  CHECK(after.n_cut_contacts <= 36);
  CHECK(after.n_contacts == before.n_contacts - after.n_cut_contacts);
  CHECK(after.n_edge_contacts == before.n_edge_contacts);
}

TEST_CASE("a cut along the border of the particles cuts them from the elements there") {
  const Model whole = built_with("");
  const Model cut = built_with(notch("[\"1 m\", \"0 m\"]", "[\"1 m\", \"2 m\"]", "0 m"));
  const auto n_at_border = std::count_if(whole.facet_pairs.begin(), whole.facet_pairs.end(), [&](const auto& pair) {
    const auto& [i, j] = whole.facets.nodes[pair.second];
    return whole.nodes.position[i].x == 1.0 && whole.nodes.position[j].x == 1.0;
  });
  REQUIRE(n_at_border > 10);
  CHECK(cut.cut_facet_pairs.size() == static_cast<std::size_t>(n_at_border));
  CHECK(cut.cut_particle_pairs.empty());
}

TEST_CASE("a slit takes exactly the particles whose centres are in it") {
  const Model whole = built_with("");
  const Model slit = built_with(notch("[\"1.5 m\", \"0 m\"]", "[\"1.5 m\", \"1 m\"]", "0.2 m"));
  Field<Vector> expected;
  for (const Vector& centre : whole.particles.position) {
    if (!(std::abs(centre.x - 1.5) < 0.1 && centre.y < 1.0)) expected.push_back(centre);
  }
  REQUIRE(expected.size() < whole.particles.size());
  CHECK(slit.particles.position == expected);
  CHECK(slit.notches[0].n_taken == whole.particles.size() - expected.size());
  CHECK(slit.elements.size() == whole.elements.size());
  for (std::size_t i = 0; i < slit.particles.size(); ++i) CHECK(slit.particles.id[i] == static_cast<Index>(i + 1));
}

TEST_CASE("a slit along lines of the mesh takes the elements inside") {
  const Model whole = built_with("");
  // Of the element above the particles, and of the upper row of those.
  const Model slit = built_with(notch("[\"1.5 m\", \"3 m\"]", "[\"1.5 m\", \"1.9 m\"]", "1 m"));
  CHECK(slit.elements.size() == whole.elements.size() - 1);
  CHECK(std::find(slit.elements.id.begin(), slit.elements.id.end(), 8) == slit.elements.id.end());
  CHECK(slit.particles.size() < whole.particles.size());
  CHECK(slit.notches[0].n_taken == 1 + whole.particles.size() - slit.particles.size());
}
