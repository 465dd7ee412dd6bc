#pragma once

#include <array>

#include "core/force_provider.hpp"
#include "core/occurrences.hpp"
#include "mesh/quadrilateral.hpp"

namespace ligament {

/// Internal forces f = -K u of the elements. A node adds up those of its elements in their order, whether one thread
/// brings them to the nodes element by element, or many fetch them node by node.
class ElementForces : public ForceProvider {
 public:
  void add_forces(const Model& model, State& state) override;
  void add_stiffness(const Model& model, const State& state, StiffnessBounds& bounds) const override;
  void assemble(const Model& model, const State& state, StiffnessSum& stiffness) const override;
  [[nodiscard]] ForceMagnitudes internal_forces(const Model& model, const State& state) const override;
  [[nodiscard]] std::vector<EnergyTerm> energies(const Model& model, const State& state) const override;

 private:
  static void add_forces_by_element(const Model& model, State& state);
  void add_forces_by_node(const Model& model, State& state);
  void find_corners_at_nodes(const Model& model);

  // Scratch of threads that share the elements.
  Field<std::array<Index, 4>> nodes_;  ///< of the elements
  Occurrences corners_at_nodes_;       ///< corner a of element e has the number 4 e + a
  std::vector<ElementDisplacement> internal_forces_;
};

}  // namespace ligament
