#pragma once

#include <string>
#include <vector>

#include "ensemble/plan.hpp"

namespace ligament {

/// A swept value as tables show it: a quantity as a number, with its unit in the name of the column.
struct SweptValue {
  std::string column;  ///< "solver.increment_m"
  std::string cell;    ///< "1e-06"; other values as they are, without what a table cannot hold
};

/// The values of a member, read from its case with defaults and overrides in (its resolved text).
std::vector<SweptValue> swept_values(const std::vector<Sweep>& sweeps, const EnsembleMember& member,
                                     const std::string& resolved_text);

}  // namespace ligament
