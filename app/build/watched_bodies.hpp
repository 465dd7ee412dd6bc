#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "core/body_table.hpp"
#include "core/model.hpp"
#include "core/state.hpp"

namespace ligament {

/// A node, particle or node of a beam that a gauge watches along an axis, and its weight in a mean.
struct WatchedBody {
  BodyTable body = BodyTable::node;
  Index row = -1;
  int axis = 0;
  double weight = 1.0;

  /// Along the axis (m).
  [[nodiscard]] double displacement(const State& state) const;

  /// What holds or moves the body, along the axis (N).
  [[nodiscard]] double holding(const Model& model, const State& state) const;

  /// The number of its freedom along the axis.
  [[nodiscard]] Index freedom(const Model& model) const;
};

/// 0 along x, 1 along y.
int axis_of(const std::string& direction);

/// The bodies that supports hold. A support that is not in the case is added to its errors.
std::vector<WatchedBody> bodies_of_supports(Case& input, const Model& model, const std::vector<std::string>& names,
                                            int axis, const TableView& view, const char* key);

/// What a gauge of one place watches: a body, the bodies of supports, both ends of a wall, or what moves with a place;
/// none if the case is wrong, and why is added to its errors.
std::vector<WatchedBody> find_bodies(Case& input, const Model& model, const GaugePoint& point, const TableView& view,
                                     const char* key);

/// One end of an opening: the nearest body, or what is under its foot; none, with an error of the case, if the foot
/// stands on nothing.
std::vector<WatchedBody> bodies_of_end(Case& input, const Model& model, const GaugePair& pair, const Vector& place,
                                       const Vector& other, const TableView& view);

}  // namespace ligament
