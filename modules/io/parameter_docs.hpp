#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameters.hpp"

namespace ligament {

/// A choice among implementations that brings keys of its own into a table: a law, a generator.
struct Variant {
  std::string name;
  std::string description;
  Parameters parameters;
};

/// One table of the case file as it is documented. Only declarations are used, not the members they are bound to.
struct TableDescription {
  enum class Kind {
    single,  ///< [problem]
    named,   ///< [material.*]
    array,   ///< [[zone]], each element with a `name`
  };

  /// "problem", "material.*", "zone"; empty for the keys at the top of the file.
  std::string path;
  Kind kind = Kind::single;
  std::string description;
  Parameters parameters;
  /// The key that chooses the variant: "law"; empty if there are no variants.
  std::string selector;
  std::vector<Variant> variants;
  /// The variant taken where the selector is left out; nothing if it must be given.
  std::optional<std::string> default_variant;
  bool required = false;
};

/// What the keys called `key` mean, as text for a terminal: "zone.radius", "zone.middle.radius", "support.at.x", a
/// table
/// ("solver") or the last part of a key wherever it occurs ("radius"). Throws InputError if there is none.
[[nodiscard]] std::string explain(const std::vector<TableDescription>& tables, std::string_view key);

/// A JSON Schema (draft 2020-12) of case files, indented. Ranges of quantities are told in the descriptions only.
[[nodiscard]] std::string json_schema(const std::vector<TableDescription>& tables);

/// The reference of all keys in Markdown: one section a table.
[[nodiscard]] std::string markdown_reference(const std::vector<TableDescription>& tables);

}  // namespace ligament
