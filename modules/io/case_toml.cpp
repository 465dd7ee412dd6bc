#include "io/case_toml.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <tuple>

#include "core/error.hpp"

namespace ligament {

namespace {

SourcePosition position_of(const toml::source_region& region) {
  return {.line = region.begin.line, .column = region.begin.column, .override_text = {}};
}

CaseNode converted(const toml::node& node);

CaseNode::Table converted_entries(const toml::table& table) {
  CaseNode::Table entries;
  for (const auto& [key, value] : table) {
    entries.push_back({std::string(key.str()), position_of(key.source()), converted(value)});
  }
  // The parser sorts by name; people number and group things in the order they write them.
  std::stable_sort(entries.begin(), entries.end(), [](const CaseEntry& a, const CaseEntry& b) {
    return std::tie(a.key_position.line, a.key_position.column) < std::tie(b.key_position.line, b.key_position.column);
  });
  return entries;
}

CaseNode::List converted_items(const toml::array& array) {
  CaseNode::List items;
  for (const toml::node& item : array) items.push_back(converted(item));
  return items;
}

bool has_headers(const toml::node& node) {
  if (const toml::table* table = node.as_table()) return !table->is_inline();
  const toml::array* array = node.as_array();
  return array != nullptr && !array->empty() && array->front().is_table() && !array->front().as_table()->is_inline();
}

CaseNode converted(const toml::node& node) {
  CaseNode result;
  result.position = position_of(node.source());
  result.has_header = has_headers(node);
  node.visit([&](const auto& typed) {
    using Type = std::decay_t<decltype(typed)>;
    if constexpr (toml::is_table<Type>) {
      result.value = converted_entries(typed);
    } else if constexpr (toml::is_array<Type>) {
      result.value = converted_items(typed);
    } else if constexpr (toml::is_date<Type> || toml::is_time<Type> || toml::is_date_time<Type>) {
      result.value = CaseDate{};
    } else {
      result.value = typed.get();
    }
  });
  return result;
}

std::string explained(const toml::parse_error& error) {
  std::string text(error.description());
  if (text.find("utf-8") != std::string::npos) return "the file is not UTF-8 text";
  if (text.find("control characters") != std::string::npos) {
    return "syntax error: a string holds a line break or another control character; is its closing quote missing?";
  }
  if (!text.empty()) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return "syntax error: " + text;
}

/// Throws InputError for keys of a great many parts, a.b.c…: the parser nests tables for them until the stack is full.
void check_dotted_keys(std::string_view text, std::string_view file_name) {
  constexpr int most_points = 1000;
  int n_points = 0;
  std::size_t line = 1;
  for (const char c : text) {
    if (c == '\n') ++line;
    n_points = c == '\n' || c == '=' ? 0 : n_points + (c == '.' ? 1 : 0);
    if (n_points <= most_points) continue;
    throw InputError(fmt::format("{}:{}:1: more than {} points without a '=' between them: no case file has such keys",
                                 file_name, line, most_points));
  }
}

}  // namespace

CaseNode parse_toml(std::string_view text, std::string_view file_name) {
  check_dotted_keys(text, file_name);
  try {
    CaseNode root = converted(toml::parse(text, file_name));
    if (std::get<CaseNode::Table>(root.value).empty()) {
      throw InputError(fmt::format("{}:1:1: the file is empty", file_name));
    }
    return root;
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}: {}", position_of(error.source()).text(file_name), explained(error)));
  }
}

std::optional<CaseNode> parse_toml_value(std::string_view text) {
  // A second line would be a second key.
  if (text.find_first_of("\r\n") != std::string_view::npos) return std::nullopt;
  try {
    const toml::table document = toml::parse("value = " + std::string(text));
    return converted(*document.get("value"));
  } catch (const toml::parse_error&) {
    return std::nullopt;
  }
}

}  // namespace ligament
