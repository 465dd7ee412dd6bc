#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ligament {

/// Number of single-letter insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known name that `word` is most likely a misspelling of; nothing if none is near.
[[nodiscard]] std::optional<std::string> closest_name(std::string_view word, const std::vector<std::string>& known);

/// `; did you mean 'closest'?`, or an empty string if no known name is near.
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

/// `'a', 'b', 'c'`.
[[nodiscard]] std::string quoted_list(const std::vector<std::string>& names);

}  // namespace ligament
