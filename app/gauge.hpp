#pragma once

#include <functional>
#include <string>

#include "core/model.hpp"
#include "core/state.hpp"
#include "core/stiffness_sum.hpp"

namespace ligament {

/// A quantity of the state with a column of history.csv.
struct Gauge {
  std::string name;
  std::string column;  ///< "<name>_<unit>"
  std::function<double(const Model&, const State&)> value;
  /// Displacements whose weighted sum it is, if it is one.
  std::vector<SpringTerm> displacements = {};
};

}  // namespace ligament
