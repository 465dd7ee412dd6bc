#include <doctest/doctest.h>

#include <algorithm>
#include <map>

#include "mesh/boundary_facets.hpp"
#include "mesh/structured_mesh.hpp"

using namespace ligament;

namespace {

StructuredMesh five_by_five(const std::vector<Rectangle>& holes) {
  const std::vector<double> lines{0.0, 1.0, 2.0, 3.0, 4.0, 5.0};
  return build_structured_mesh({lines, lines}, holes);
}

double total_length(const StructuredMesh& mesh, const FacetData& facets) {
  double length = 0.0;
  for (const auto& [i, j] : facets.nodes) length += norm(mesh.nodes.position[j] - mesh.nodes.position[i]);
  return length;
}

bool has_element_on_the_left(const StructuredMesh& mesh, const FacetData& facets, std::size_t facet) {
  const auto& [i, j] = facets.nodes[facet];
  const auto& nodes = mesh.elements.nodes[facets.element[facet]];
  const Vector centre = 0.5 * (mesh.nodes.position[nodes[0]] + mesh.nodes.position[nodes[2]]);
  return cross(mesh.nodes.position[j] - mesh.nodes.position[i], centre - mesh.nodes.position[i]) > 0.0;
}

}  // namespace

TEST_CASE("facets run around the outside of a mesh") {
  const StructuredMesh mesh = five_by_five({});
  const FacetData facets = find_boundary_facets(mesh.elements);
  CHECK(facets.size() == 20);
  CHECK(total_length(mesh, facets) == doctest::Approx(20.0));
}

TEST_CASE("facets run around holes too, with the element on their left") {
  const StructuredMesh mesh = five_by_five({{{1.0, 2.0}, {3.0, 3.0}}});
  const FacetData facets = find_boundary_facets(mesh.elements);
  CHECK(facets.size() == 26);
  CHECK(total_length(mesh, facets) == doctest::Approx(26.0));
  for (std::size_t facet = 0; facet < facets.size(); ++facet) CHECK(has_element_on_the_left(mesh, facets, facet));
  CHECK(std::is_sorted(facets.element.begin(), facets.element.end()));
}

TEST_CASE("facets are closed: each node is left as often as it is reached") {
  const StructuredMesh mesh = five_by_five({{{1.0, 2.0}, {3.0, 3.0}}, {{4.0, 0.0}, {5.0, 1.0}}});
  std::map<Index, int> balance;
  for (const auto& [i, j] : find_boundary_facets(mesh.elements).nodes) {
    ++balance[i];
    --balance[j];
  }
  for (const auto& [node, count] : balance) CHECK(count == 0);
}
