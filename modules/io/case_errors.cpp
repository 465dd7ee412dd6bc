#include "io/case_errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>

namespace ligament {
namespace {

/// A message as a terminal can take it, whatever it quotes: control characters as '?', the middle of long ones left
/// out.
std::string printable(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, '?');
  constexpr std::size_t longest = 1000;
  if (text.size() <= longest) return text;
  const auto is_inside_character = [&](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80; };
  std::size_t head = longest / 2;
  while (is_inside_character(head)) --head;
  std::size_t tail = text.size() - longest / 2;
  while (tail < text.size() && is_inside_character(tail)) ++tail;
  return text.substr(0, head) + " … " + text.substr(tail);
}

}  // namespace

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
  for (const Item& item : sorted) {
    lines.push_back(printable(fmt::format("{}: {}", item.position.text(file_name), item.message)));
  }
  return fmt::format("{}", fmt::join(lines, "\n"));
}

}  // namespace ligament
