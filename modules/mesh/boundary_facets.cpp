#include "mesh/boundary_facets.hpp"

#include <algorithm>
#include <map>

namespace ligament {
namespace {

using Edge = std::array<Index, 2>;

template <class Visit>
void visit_edges(const ElementData& elements, Visit&& visit) {
  for (std::size_t element = 0; element < elements.size(); ++element) {
    const auto& nodes = elements.nodes[element];
    for (std::size_t side = 0; side < 4; ++side) visit(element, Edge{nodes[side], nodes[(side + 1) % 4]});
  }
}

Edge without_direction(const Edge& edge) { return {std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}; }

}  // namespace

FacetData find_boundary_facets(const ElementData& elements) {
  std::map<Edge, int> n_elements_at;
  visit_edges(elements, [&](std::size_t, const Edge& edge) { ++n_elements_at[without_direction(edge)]; });
  FacetData facets;
  visit_edges(elements, [&](std::size_t element, const Edge& edge) {
    if (n_elements_at[without_direction(edge)] != 1) return;
    facets.nodes.push_back(edge);
    facets.element.push_back(static_cast<Index>(element));
  });
  return facets;
}

}  // namespace ligament
