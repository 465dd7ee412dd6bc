#pragma once

#include <array>
#include <map>
#include <span>
#include <vector>

#include "core/model.hpp"

namespace ligament {

/// Numbers the freedoms of a model in one column: translation and rotation of every particle, then the translation of
/// every node, then translation and rotation of every node of beams.
struct FreedomNumbers {
  std::size_t n_particles = 0;
  std::size_t n_nodes = 0;
  std::size_t n_beam_nodes = 0;

  explicit FreedomNumbers(const Model& model)
      : n_particles(model.particles.size()), n_nodes(model.nodes.size()), n_beam_nodes(model.beam_nodes.size()) {}

  static constexpr std::size_t per_particle = dimension + 1;
  [[nodiscard]] std::size_t count() const { return per_particle * (n_particles + n_beam_nodes) + dimension * n_nodes; }
  [[nodiscard]] Index particle(Index row, int axis) const { return static_cast<Index>(per_particle * row + axis); }
  [[nodiscard]] Index rotation(Index row) const { return particle(row, dimension); }
  [[nodiscard]] Index node(Index row, int axis) const {
    return static_cast<Index>(per_particle * n_particles + dimension * row + axis);
  }
  [[nodiscard]] Index beam_node(Index row, int axis) const {
    return static_cast<Index>(per_particle * n_particles + dimension * n_nodes + per_particle * row + axis);
  }
  [[nodiscard]] Index beam_rotation(Index row) const { return beam_node(row, dimension); }
};

/// How much a unit of one freedom stretches a spring.
struct SpringTerm {
  Index freedom = 0;
  double factor = 0.0;
};

/// A stiffness matrix as the sum it comes from: springs between freedoms, k b bᵀ, and the matrices of elements. For
/// what needs the matrix at set-up; stepping never does.
class StiffnessSum {
 public:
  explicit StiffnessSum(const Model& model);

  struct Spring {
    std::span<const SpringTerm> terms;  ///< b
    double stiffness = 0.0;             ///< k (N/m)
  };
  struct ElementBlock {
    std::array<Index, 8> freedoms;
    const ElementStiffness* matrix = nullptr;
  };

  [[nodiscard]] const FreedomNumbers& numbers() const { return numbers_; }

  /// Freedoms of the ends of platens stand for those of their middles.
  void add_spring(std::span<const SpringTerm> terms, double stiffness);
  /// Gives all springs other stiffness, in the order in which they were added.
  void set_stiffness(std::vector<double> stiffness) { stiffness_ = std::move(stiffness); }
  /// The matrix must outlive the sum.
  void add_element(const std::array<Index, 8>& freedoms, const ElementStiffness& matrix);

  [[nodiscard]] std::size_t n_springs() const { return stiffness_.size(); }
  [[nodiscard]] Spring spring(std::size_t i) const {
    return {std::span(terms_).subspan(begin_[i], begin_[i + 1] - begin_[i]), stiffness_[i]};
  }
  [[nodiscard]] const std::vector<ElementBlock>& elements() const { return elements_; }

  /// K x.
  [[nodiscard]] std::vector<double> times(const std::vector<double>& x) const;

 private:
  FreedomNumbers numbers_;
  std::map<Index, std::vector<SpringTerm>> followers_;  ///< of every freedom of an end of a platen, what moves it
  std::vector<std::size_t> begin_{0};
  std::vector<SpringTerm> terms_;
  std::vector<double> stiffness_;
  std::vector<ElementBlock> elements_;
};

}  // namespace ligament
