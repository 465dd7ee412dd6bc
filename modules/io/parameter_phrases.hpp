#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/parameters.hpp"
#include "io/parameter_docs.hpp"

namespace ligament {

/// "quantity in Pa", "list of integers", "point in m".
[[nodiscard]] std::string kind_phrase(const Parameter& parameter);

/// The default in TOML; empty if there is none.
[[nodiscard]] std::string default_phrase(const Parameter& parameter);

/// Bounds, length and allowed texts; empty if anything goes.
[[nodiscard]] std::string range_phrase(const Parameter& parameter);

/// "[problem]", "[material.*]", "[[zone]]", "top level".
[[nodiscard]] std::string table_phrase(const TableDescription& table);

/// The name of the table without ".*".
[[nodiscard]] std::string table_name(const TableDescription& table);

/// The parameters with those of inner tables after them, as "at", "at.x", "at.y".
[[nodiscard]] std::vector<std::pair<std::string, const Parameter*>> flattened(const Parameters& parameters);

/// The parameters every variant has, with the selector (a text, one of the variants) and the name of an array's
/// elements where they are not declared already.
[[nodiscard]] Parameters common_parameters(const TableDescription& table);

}  // namespace ligament
