#include "integrator/coarse_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace ligament {
namespace {

/// A body in its cell: the corners around it, their shape functions and the gradients of these (1/m).
struct CellPlace {
  std::array<Index, 4> freedoms;  ///< the first of every corner
  std::array<double, 4> shape;
  std::array<Vector, 4> gradient;
};

double local_coordinate(double position, double origin, double cell, std::size_t n_cells, std::size_t& number) {
  const double scaled = (position - origin) / cell;
  number = std::min(static_cast<std::size_t>(std::max(0.0, std::floor(scaled))), n_cells - 1);
  return scaled - static_cast<double>(number);
}

}  // namespace

Rectangle extent_of(const Model& model) {
  const auto& bodies = model.nodes.size() > 0       ? model.nodes.position
                       : model.particles.size() > 0 ? model.particles.position
                                                    : model.beam_nodes.position;
  const Vector& any = bodies[0];
  Rectangle extent{any, any};
  const auto see = [&extent](const Vector& place) {
    for (int axis = 0; axis < dimension; ++axis) {
      set_component(extent.from, axis, std::min(component(extent.from, axis), component(place, axis)));
      set_component(extent.to, axis, std::max(component(extent.to, axis), component(place, axis)));
    }
  };
  for (const Vector& place : model.particles.position) see(place);
  for (const Vector& place : model.nodes.position) see(place);
  // Beams alone have no other.
  if (model.particles.size() + model.nodes.size() > 0) return extent;
  for (const Vector& place : model.beam_nodes.position) see(place);
  return extent;
}

CoarseSpace::Grid::Grid(const Model& model, double cell_size) {
  const Rectangle extent = extent_of(model);
  origin = extent.from;
  const Vector size = extent.size();
  for (int axis = 0; axis < dimension; ++axis) {
    const double length = component(size, axis);
    n_cells[axis] = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(length / cell_size)));
    set_component(cell, axis, length > 0.0 ? length / static_cast<double>(n_cells[axis]) : cell_size);
  }
  long_axis = n_cells[0] >= n_cells[1] ? 0 : 1;
  constexpr std::size_t most_corners = 100000;
  if (n_cells[0] <= most_corners && n_cells[1] <= most_corners && n_corners() <= most_corners) return;
  throw InputError(
      fmt::format("'coarse_cell' is too small: the coarse motions would have more than {} corners; leave it "
                  "out, or take a tenth of the structure",
                  most_corners));
}

std::size_t CoarseSpace::Grid::n_corners() const { return (n_cells[0] + 1) * (n_cells[1] + 1); }

Index CoarseSpace::Grid::corner(const std::array<std::size_t, dimension>& place) const {
  const int short_axis = 1 - long_axis;
  return static_cast<Index>(place[long_axis] * (n_cells[short_axis] + 1) + place[short_axis]);
}

std::array<std::size_t, dimension> CoarseSpace::Grid::cell_of(const Vector& position,
                                                              std::array<double, dimension>& local) const {
  std::array<std::size_t, dimension> number{};
  for (int axis = 0; axis < dimension; ++axis) {
    local[axis] = local_coordinate(component(position, axis), component(origin, axis), component(cell, axis),
                                   n_cells[axis], number[axis]);
  }
  return number;
}

CoarseSpace::Numbers::Numbers(const Model& model, const Grid& grid) : beam_node(model.beam_nodes.size()) {
  std::vector<std::vector<std::size_t>> nodes_at(grid.n_corners());
  for (std::size_t i = 0; i < beam_node.size(); ++i) {
    std::array<double, dimension> local{};
    nodes_at[grid.corner(grid.cell_of(model.beam_nodes.position[i], local))].push_back(i);
  }
  for (const std::vector<std::size_t>& nodes : nodes_at) {
    corner.push_back(static_cast<Index>(count));
    count += dimension;
    for (const std::size_t node : nodes) {
      beam_node[node] = static_cast<Index>(count);
      count += dimension + 1;
    }
  }
}

CoarseSpace::CoarseSpace(const Model& model, const StiffnessSum& stiffness, double cell_size) {
  const Grid grid(model, cell_size);
  const Numbers numbers(model, grid);
  place_bodies(model, grid, numbers);
  assemble(stiffness, numbers.count);
  list_members(numbers.count);
  scratch_.resize(size());
}

void CoarseSpace::place_bodies(const Model& model, const Grid& grid, const Numbers& numbers) {
  const auto place = [&grid, &numbers](const Vector& position) {
    std::array<double, dimension> local{};
    const auto number = grid.cell_of(position, local);
    CellPlace result{};
    for (std::size_t k = 0; k < 4; ++k) {
      const bool right = (k & 1U) != 0U;
      const bool upper = (k & 2U) != 0U;
      const double x = right ? local[0] : 1.0 - local[0];
      const double y = upper ? local[1] : 1.0 - local[1];
      result.freedoms[k] = numbers.corner[grid.corner({number[0] + (right ? 1 : 0), number[1] + (upper ? 1 : 0)})];
      result.shape[k] = x * y;
      result.gradient[k] = {(right ? y : -y) / component(grid.cell, 0), (upper ? x : -x) / component(grid.cell, 1)};
    }
    return result;
  };
  const auto add_translations = [&](const CellPlace& cell, const Vector& free) {
    for (int axis = 0; axis < dimension; ++axis) {
      std::vector<Share> shares;
      for (std::size_t k = 0; k < 4 && component(free, axis) != 0.0; ++k) {
        shares.push_back({cell.freedoms[k] + axis, cell.shape[k]});
      }
      add_freedom(shares);
    }
  };
  const auto add_rotation = [&](const CellPlace& cell) {
    std::vector<Share> shares;
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector turning = cross(Spin{0.5}, cell.gradient[k]);  // (-½ ∂/∂y, ½ ∂/∂x)
      for (int axis = 0; axis < dimension; ++axis) {
        shares.push_back({cell.freedoms[k] + axis, component(turning, axis)});
      }
    }
    add_freedom(shares);
  };
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    const CellPlace cell = place(model.particles.position[i]);
    add_translations(cell, model.particles.free[i]);
    if (model.particles.rotation_free[i] != 0.0) {
      add_rotation(cell);
    } else {
      add_freedom({});
    }
  }
  for (std::size_t i = 0; i < model.nodes.size(); ++i)
    add_translations(place(model.nodes.position[i]), model.nodes.free[i]);
  for (std::size_t i = 0; i < model.beam_nodes.size(); ++i) {
    for (int axis = 0; axis <= dimension; ++axis) {
      const bool is_free = axis == dimension ? model.beam_nodes.rotation_free[i] != 0.0
                                             : component(model.beam_nodes.free[i], axis) != 0.0;
      add_freedom(is_free ? std::vector<Share>{{numbers.beam_node[i] + axis, 1.0}} : std::vector<Share>{});
    }
  }
}

void CoarseSpace::add_freedom(const std::vector<Share>& shares) {
  shares_.insert(shares_.end(), shares.begin(), shares.end());
  begin_.push_back(shares_.size());
}

std::vector<CoarseSpace::Share> CoarseSpace::coarse_spring(std::span<const SpringTerm> terms) const {
  std::vector<Share> spring;
  for (const SpringTerm& term : terms) {
    for (const Share& share : shares_of(term.freedom)) {
      const auto known =
          std::find_if(spring.begin(), spring.end(), [&](const Share& other) { return other.coarse == share.coarse; });
      if (known != spring.end()) {
        known->weight += term.factor * share.weight;
      } else {
        spring.push_back({share.coarse, term.factor * share.weight});
      }
    }
  }
  return spring;
}

template <class Add>
void CoarseSpace::visit_entries(const StiffnessSum& stiffness, Add&& add) const {
  for (std::size_t i = 0; i < stiffness.n_springs(); ++i) {
    const auto [terms, k] = stiffness.spring(i);
    const std::vector<Share> spring = coarse_spring(terms);
    for (const Share& p : spring) {
      for (const Share& q : spring) {
        if (p.coarse >= q.coarse) add(p.coarse, q.coarse, k * p.weight * q.weight);
      }
    }
  }
  for (const auto& [freedoms, matrix] : stiffness.elements()) {
    for (std::size_t a = 0; a < 8; ++a) {
      for (std::size_t b = 0; b < 8; ++b) {
        for (const Share& p : shares_of(freedoms[a])) {
          for (const Share& q : shares_of(freedoms[b])) {
            if (p.coarse >= q.coarse) add(p.coarse, q.coarse, (*matrix)[8 * a + b] * p.weight * q.weight);
          }
        }
      }
    }
  }
}

void CoarseSpace::assemble(const StiffnessSum& stiffness, std::size_t n_coarse) {
  Index bandwidth = 0;
  visit_entries(stiffness, [&](Index row, Index column, double) { bandwidth = std::max(bandwidth, row - column); });
  stiffness_ = BandedCholesky(n_coarse, static_cast<std::size_t>(bandwidth));
  visit_entries(stiffness, [&](Index row, Index column, double value) { stiffness_.at(row, column) += value; });
  // Corners without a body around them would leave the matrix singular.
  double largest = 0.0;
  for (std::size_t i = 0; i < size(); ++i) largest = std::max(largest, stiffness_.at(i, i));
  for (std::size_t i = 0; i < size(); ++i) stiffness_.at(i, i) += largest > 0.0 ? 1e-10 * largest : 1.0;
  stiffness_.factorize();
}

void CoarseSpace::list_members(std::size_t n_coarse) {
  std::vector<std::vector<Member>> of_coarse(n_coarse);
  for (std::size_t i = 0; i + 1 < begin_.size(); ++i) {
    for (const Share& share : shares_of(static_cast<Index>(i))) {
      if (share.weight != 0.0) of_coarse[share.coarse].push_back({static_cast<Index>(i), share.weight});
    }
  }
  member_begin_ = {0};
  for (const std::vector<Member>& members : of_coarse) {
    members_.insert(members_.end(), members.begin(), members.end());
    member_begin_.push_back(members_.size());
  }
}

void CoarseSpace::add_answer(const std::vector<double>& forces, double factor, std::vector<double>& motion) {
  // Sums of four: one alone would wait for itself at every term.
  for (std::size_t coarse = 0; coarse < scratch_.size(); ++coarse) {
    std::array<double, 4> sums{};
    std::size_t k = member_begin_[coarse];
    const auto add = [&](std::size_t place) {
      sums[place] += members_[k + place].weight * forces[members_[k + place].freedom];
    };
    for (; k + 4 <= member_begin_[coarse + 1]; k += 4) {
      for (std::size_t place = 0; place < 4; ++place) add(place);
    }
    for (; k < member_begin_[coarse + 1]; ++k) add(0);
    scratch_[coarse] = (sums[0] + sums[1]) + (sums[2] + sums[3]);
  }
  stiffness_.solve(scratch_);
  for (std::size_t i = 0; i < motion.size(); ++i) {
    for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k)
      motion[i] += factor * shares_[k].weight * scratch_[shares_[k].coarse];
  }
}

}  // namespace ligament
