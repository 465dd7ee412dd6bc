#include "core/stiffness_sum.hpp"

namespace ligament {

void StiffnessSum::add_spring(std::span<const SpringTerm> terms, double stiffness) {
  terms_.insert(terms_.end(), terms.begin(), terms.end());
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
