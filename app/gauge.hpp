#pragma once

#include <functional>
#include <string>

#include "core/model.hpp"
#include "core/state.hpp"

namespace ligament {

/// A quantity of the state with a column of history.csv.
struct Gauge {
  std::string name;
  std::string column;  ///< "<name>_<unit>"
  std::function<double(const Model&, const State&)> value;
};

}  // namespace ligament
