#pragma once

#include <optional>
#include <string_view>

#include "io/case_node.hpp"

namespace ligament {

/// The document as a table. Throws InputError `file_name:line:column: ...` at the first thing that is not TOML or not
/// UTF-8, and if there is no key at all.
[[nodiscard]] CaseNode parse_toml(std::string_view text, std::string_view file_name);

/// A single TOML value such as `3`, `"x"` or `[1, 2]`; nothing if the text is not one.
[[nodiscard]] std::optional<CaseNode> parse_toml_value(std::string_view text);

}  // namespace ligament
