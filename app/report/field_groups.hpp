#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/vector.hpp"

namespace ligament {

/// The cells of a field file as the pictures of a report need them.
struct FieldCells {
  std::filesystem::path path;
  Field<Vector> rest;   ///< points at rest (m)
  Field<Vector> drawn;  ///< the same, displaced by the scaled displacement (m)
  std::vector<std::size_t> connectivity;

  [[nodiscard]] std::vector<double> numbers(const char* name) const;
  [[nodiscard]] Field<Vector> vectors(const char* name) const;
};

/// The file of a group at a step; nothing if the model has no such group. FileError if it cannot be read.
std::optional<FieldCells> read_cells(const std::filesystem::path& run, const char* group, std::int64_t step,
                                     double scale);

}  // namespace ligament
