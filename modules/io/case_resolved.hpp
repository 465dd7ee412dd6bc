#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/parameters.hpp"

namespace ligament {

/// Keys of a table with their values in TOML, in the order they were read.
using ResolvedKeys = std::vector<std::pair<std::string, std::string>>;

/// The parameter's value now, as TOML that reads back to the same bits; nothing for what was not given and has no
/// default a case could give.
[[nodiscard]] std::optional<std::string> resolved_value(const Parameter& parameter);

/// A value of the parameter as TOML that reads back to the same bits.
[[nodiscard]] std::string toml_text(const Parameter& parameter, const ParameterValue& value);

/// Whether a case may give the value: a default may lie outside to say "none" or "no limit".
[[nodiscard]] bool is_acceptable(const Parameter& parameter, const ParameterValue& value);

/// Sets the key's value, at the end if it is new.
void set_resolved(ResolvedKeys& keys, const std::string& key, std::string value);

/// A TOML basic string, quotes and escapes in.
[[nodiscard]] std::string toml_string(std::string_view text);

}  // namespace ligament
