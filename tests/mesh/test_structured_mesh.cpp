#include <doctest/doctest.h>

#include "core/error.hpp"
#include "mesh/structured_mesh.hpp"

using namespace ligament;

namespace {

const GridLines four_by_three{{0.0, 1.0, 2.0, 4.0, 5.0}, {0.0, 0.5, 1.5, 2.0}};

std::vector<Index> ids(const Field<Index>& field) { return {field.begin(), field.end()}; }

}  // namespace

TEST_CASE("nodes and elements are numbered row by row from the bottom left") {
  const StructuredMesh mesh = build_structured_mesh(four_by_three, {});
  CHECK(mesh.nodes.size() == 20);
  CHECK(mesh.elements.size() == 12);
  CHECK(mesh.nodes.position[0] == Vector{0.0, 0.0});
  CHECK(mesh.nodes.position[4] == Vector{5.0, 0.0});
  CHECK(mesh.nodes.position[5] == Vector{0.0, 0.5});
  CHECK(mesh.nodes.position[19] == Vector{5.0, 2.0});
  CHECK(mesh.nodes.id.front() == 1);
  CHECK(mesh.nodes.id.back() == 20);
  CHECK(mesh.elements.nodes[0] == std::array<Index, 4>{0, 1, 6, 5});
  CHECK(mesh.elements.nodes[4] == std::array<Index, 4>{5, 6, 11, 10});
  CHECK(mesh.elements.nodes[11] == std::array<Index, 4>{13, 14, 19, 18});
  for (const Vector& free : mesh.nodes.free) CHECK(free == uniform_vector(1.0));
}

TEST_CASE("a hole takes elements, and nodes that only they have and ids stay those of the full grid") {
  const StructuredMesh mesh = build_structured_mesh(four_by_three, {{{1.0, 0.0}, {4.0, 1.5}}});
  CHECK(ids(mesh.elements.id) == std::vector<Index>{1, 4, 5, 8, 9, 10, 11, 12});
  // Inside the hole and on its open lower end lies a node each: 3 and 8.
  CHECK(ids(mesh.nodes.id) == std::vector<Index>{1, 2, 4, 5, 6, 7, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20});
  for (std::size_t element = 0; element < mesh.elements.size(); ++element) {
    const auto& nodes = mesh.elements.nodes[element];
    const Vector diagonal = mesh.nodes.position[nodes[2]] - mesh.nodes.position[nodes[0]];
    CHECK(diagonal.x > 0.0);
    CHECK(diagonal.y > 0.0);
    CHECK(mesh.nodes.id[nodes[1]] == mesh.nodes.id[nodes[0]] + 1);
    CHECK(mesh.nodes.id[nodes[3]] == mesh.nodes.id[nodes[0]] + 5);
  }
}

TEST_CASE("several holes") {
  const StructuredMesh mesh =
      build_structured_mesh(four_by_three, {{{0.0, 0.0}, {1.0, 0.5}}, {{4.0, 1.5}, {5.0, 2.0}}});
  CHECK(ids(mesh.elements.id) == std::vector<Index>{2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
  CHECK(mesh.nodes.size() == 18);
  CHECK(mesh.nodes.id.front() == 2);
  CHECK(mesh.nodes.id.back() == 19);
}

TEST_CASE("a hole must follow lines of the grid") {
  CHECK(is_block_of_grid(four_by_three, {{1.0, 0.5}, {2.0, 1.5}}));
  CHECK(is_block_of_grid(four_by_three, {{1.0 + 1e-12, 0.5}, {2.0, 1.5 - 1e-12}}));
  CHECK_FALSE(is_block_of_grid(four_by_three, {{1.1, 0.5}, {2.0, 1.5}}));
  CHECK_FALSE(is_block_of_grid(four_by_three, {{1.0, 0.5}, {2.0, 1.6}}));
  CHECK_FALSE(is_block_of_grid(four_by_three, {{-1.0, 0.5}, {2.0, 1.5}}));
  CHECK_THROWS_AS(build_structured_mesh(four_by_three, {{{1.0, 0.5}, {3.0, 1.5}}}), InputError);
}
