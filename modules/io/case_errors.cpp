#include "io/case_errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>

namespace ligament {

void CaseErrors::add(SourcePosition position, std::string message) {
  const bool is_known = std::any_of(errors_.begin(), errors_.end(), [&](const Item& item) {
    return item.message == message && item.position.line == position.line && item.position.column == position.column &&
           item.position.override_text == position.override_text;
  });
  if (!is_known) errors_.push_back({std::move(position), std::move(message)});
}

std::string CaseErrors::text(std::string_view file_name) const {
  std::vector<Item> sorted = errors_;
  const auto rank = [](const Item& item) {
    const SourcePosition& position = item.position;
    return std::make_tuple(!position.override_text.empty(), position.line, position.column);
  };
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Item& a, const Item& b) { return rank(a) < rank(b); });
  std::vector<std::string> lines;
  for (const Item& item : sorted) lines.push_back(fmt::format("{}: {}", item.position.text(file_name), item.message));
  return fmt::format("{}", fmt::join(lines, "\n"));
}

}  // namespace ligament
