#include "core/stiffness_sum.hpp"

namespace ligament {

StiffnessSum::StiffnessSum(const Model& model) : numbers_(model) {
  for (const Platen& platen : model.platens) {
    for (const Index node : model.wall_nodes(platen.wall)) {
      // The motion of a place at r of a body that turns.
      const Vector turning =
          cross(Rotation{1.0}, model.nodes.position[node] - model.beam_nodes.position[platen.translation]);
      for (int axis = 0; axis < dimension; ++axis) {
        followers_[numbers_.node(node, axis)] = {{numbers_.beam_node(platen.translation, axis), 1.0},
                                                 {numbers_.beam_rotation(platen.rotation), component(turning, axis)}};
      }
    }
  }
}

void StiffnessSum::add_spring(std::span<const SpringTerm> terms, double stiffness) {
  for (const SpringTerm& term : terms) {
    const auto follower = followers_.find(term.freedom);
    if (follower == followers_.end()) {
      terms_.push_back(term);
      continue;
    }
    for (const SpringTerm& leader : follower->second) {
      terms_.push_back({leader.freedom, term.factor * leader.factor});
    }
  }
  begin_.push_back(terms_.size());
  stiffness_.push_back(stiffness);
}

void StiffnessSum::add_element(const std::array<Index, 8>& freedoms, const ElementStiffness& matrix) {
  elements_.push_back({freedoms, &matrix});
}

std::vector<double> StiffnessSum::times(const std::vector<double>& x) const {
  std::vector<double> product(numbers_.count(), 0.0);
  for (std::size_t i = 0; i < n_springs(); ++i) {
    const auto [terms, stiffness] = spring(i);
    double stretch = 0.0;
    for (const SpringTerm& term : terms) stretch += term.factor * x[term.freedom];
    for (const SpringTerm& term : terms) product[term.freedom] += stiffness * stretch * term.factor;
  }
  for (const auto& [freedoms, matrix] : elements_) {
    for (std::size_t row = 0; row < 8; ++row) {
      for (std::size_t column = 0; column < 8; ++column) {
        product[freedoms[row]] += (*matrix)[8 * row + column] * x[freedoms[column]];
      }
    }
  }
  return product;
}

}  // namespace ligament
