#pragma once

#include <span>
#include <vector>

#include "core/banded_cholesky.hpp"
#include "core/model.hpp"
#include "core/rectangle.hpp"
#include "core/stiffness_sum.hpp"

namespace ligament {

/// The smallest rectangle that holds all centres and nodes.
Rectangle extent_of(const Model& model);

/// Motions of the structure as a whole: a grid of large cells over it, with a displacement at every corner, bilinear in
/// between. Bodies move with the grid, particles turn with it, θ = ½ (∂v/∂x - ∂u/∂y); prescribed freedoms do not move.
/// Nodes of beams, which are few and lie on the structure rather than in it, have their own freedoms among the coarse
/// ones.
class CoarseSpace {
 public:
  /// Cells are squares of about this size (m). `stiffness` is that of all freedoms.
  CoarseSpace(const Model& model, const StiffnessSum& stiffness, double cell_size);

  /// Z K_c⁻¹ Zᵀ r with K_c = Zᵀ K Z: the answer of the coarse motions to forces r, added to `motion` with a factor.
  void add_answer(const std::vector<double>& forces, double factor, std::vector<double>& motion);

  [[nodiscard]] std::size_t size() const { return stiffness_.size(); }

 private:
  /// Share of a coarse freedom in a freedom of a body.
  struct Share {
    Index coarse = 0;
    double weight = 0.0;
  };
  struct Grid {
    Vector origin;
    std::array<std::size_t, dimension> n_cells{};
    Vector cell;
    int long_axis = 0;

    Grid(const Model& model, double cell_size);
    [[nodiscard]] std::size_t n_corners() const;
    /// Corners are numbered along the short axis first, which keeps the band of K_c narrow.
    [[nodiscard]] Index corner(const std::array<std::size_t, dimension>& place) const;
    /// The cell that a place is in, or nearest to, and where it is in that cell, from 0 to 1 along each axis.
    [[nodiscard]] std::array<std::size_t, dimension> cell_of(const Vector& position,
                                                             std::array<double, dimension>& local) const;
  };

  /// Numbers of coarse freedoms: those of a beam node come after the corner that it is near, which keeps the band of
  /// K_c narrow.
  struct Numbers {
    std::vector<Index> corner;     ///< first freedom of every corner
    std::vector<Index> beam_node;  ///< first freedom of every beam node
    std::size_t count = 0;

    Numbers(const Model& model, const Grid& grid);
  };

  void place_bodies(const Model& model, const Grid& grid, const Numbers& numbers);
  void add_freedom(const std::vector<Share>& shares);
  [[nodiscard]] std::span<const Share> shares_of(Index freedom) const {
    return std::span(shares_).subspan(begin_[freedom], begin_[freedom + 1] - begin_[freedom]);
  }
  /// A spring between coarse freedoms, each named once.
  [[nodiscard]] std::vector<Share> coarse_spring(std::span<const SpringTerm> terms) const;
  /// Calls add(row, column, value) for the lower triangle of Zᵀ K Z.
  template <class Add>
  void visit_entries(const StiffnessSum& stiffness, Add&& add) const;
  void assemble(const StiffnessSum& stiffness, std::size_t n_coarse);
  void list_members(std::size_t n_coarse);

  std::vector<std::size_t> begin_{0};  ///< of the shares of every freedom
  std::vector<Share> shares_;
  // The same by coarse freedoms.
  struct Member {
    Index freedom = 0;
    double weight = 0.0;
  };
  std::vector<std::size_t> member_begin_;
  std::vector<Member> members_;
  BandedCholesky stiffness_;
  std::vector<double> scratch_;
};

}  // namespace ligament
