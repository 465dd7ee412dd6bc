#pragma once

#include <string>
#include <string_view>

#include "io/case_errors.hpp"
#include "io/case_node.hpp"

namespace ligament {

/// One --set of the command line.
struct Override {
  /// "generation.seed"; an element of an array of tables is addressed by its name: "zone.middle.radius".
  std::string key;
  std::string value;
};

/// Takes "key=value" apart. Throws InputError if there is no '=' or a part of the key is empty.
[[nodiscard]] Override parse_override(std::string_view text);

/// Puts the value into the document, making tables on the way that the file does not have. The value is what TOML makes
/// of it, or the text itself if it is no TOML. A path that cannot exist is added to the errors.
void apply_override(CaseNode& root, const Override& override, CaseErrors& errors);

}  // namespace ligament
