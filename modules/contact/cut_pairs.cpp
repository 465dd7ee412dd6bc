#include "contact/cut_pairs.hpp"

#include <algorithm>
#include <iterator>
#include <span>

#include "contact/facet_search.hpp"

namespace ligament {
namespace {

Vector nearest_point(const Model& model, Index facet, const Vector& centre) {
  const Vector& i = model.nodes.position[model.facets.nodes[facet][0]];
  const Vector& j = model.nodes.position[model.facets.nodes[facet][1]];
  const FacetPlace place = place_at_facet(i, j, centre);
  return i + place.position / place.length * (j - i);
}

/// Selects the pairs whose branch, from the centre to the end that `end_of` tells, one of the notches separates.
template <class EndOf>
std::vector<SetupPair> separated(const Model& model, std::span<const Notch> notches,
                                 const std::vector<SetupPair>& pairs, EndOf&& end_of) {
  std::vector<SetupPair> cut;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(cut), [&](const SetupPair& pair) {
    const Vector& centre = model.particles.position[pair.first];
    return std::any_of(notches.begin(), notches.end(),
                       [&](const Notch& notch) { return separates(notch, centre, end_of(pair)); });
  });
  return cut;
}

/// A place in the element, just behind what a particle touches of it: a notch along the edge lies before it.
Vector behind(const Vector& touched, const Vector& centre) {
  constexpr double part = 1e-6;
  return touched + part * (touched - centre);
}

/// The end of the branch of a particle to a facet or corner.
Vector facet_end(const Model& model, const SetupPair& pair) {
  const Vector& centre = model.particles.position[pair.first];
  return behind(nearest_point(model, pair.second, centre), centre);
}
Vector corner_end(const Model& model, const SetupPair& pair) {
  return behind(model.nodes.position[pair.second], model.particles.position[pair.first]);
}

/// The largest gap of the notches that separate two places.
double gap_between(const Model& model, const Vector& centre, const Vector& end) {
  double gap = 0.0;
  for (const Notch& notch : model.notches) {
    if (notch.gap > gap && separates(notch, centre, end)) gap = notch.gap;
  }
  return gap;
}

struct CutPairs {
  std::vector<SetupPair> particles;
  std::vector<SetupPair> facets;
  std::vector<SetupPair> corners;
};

std::vector<SetupPair> below(const std::vector<SetupPair>& pairs, std::size_t limit) {
  std::vector<SetupPair> found;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(found),
               [&](const SetupPair& pair) { return static_cast<std::size_t>(pair.second) < limit; });
  return found;
}

CutPairs cut_by(const Model& model, std::span<const Notch> notches) {
  const Field<Vector>& centres = model.particles.position;
  return {separated(model, notches, model.particle_pairs, [&](const SetupPair& pair) { return centres[pair.second]; }),
          separated(model, notches, below(model.facet_pairs, model.n_element_facets()),
                    [&](const SetupPair& pair) { return facet_end(model, pair); }),
          separated(model, notches, below(model.corner_pairs, model.n_mesh_nodes()),
                    [&](const SetupPair& pair) { return corner_end(model, pair); })};
}

}  // namespace

void find_cut_pairs(Model& model) {
  CutPairs cut = cut_by(model, model.notches);
  model.cut_particle_pairs = std::move(cut.particles);
  model.cut_facet_pairs = std::move(cut.facets);
  model.cut_corner_pairs = std::move(cut.corners);
}

double particle_gap(const Model& model, const SetupPair& pair) {
  return gap_between(model, model.particles.position[pair.first], model.particles.position[pair.second]);
}

double facet_gap(const Model& model, const SetupPair& pair) {
  if (static_cast<std::size_t>(pair.second) >= model.n_element_facets()) return 0.0;
  return gap_between(model, model.particles.position[pair.first], facet_end(model, pair));
}

double corner_gap(const Model& model, const SetupPair& pair) {
  if (static_cast<std::size_t>(pair.second) >= model.n_mesh_nodes()) return 0.0;
  return gap_between(model, model.particles.position[pair.first], corner_end(model, pair));
}

bool cuts_pairs(const Model& model, const Notch& notch) {
  const CutPairs cut = cut_by(model, {&notch, 1});
  return !cut.particles.empty() || !cut.facets.empty() || !cut.corners.empty();
}

}  // namespace ligament
