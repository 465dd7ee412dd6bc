#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace ligament {

/// One array of a group. Values of a body stand together: n_components for the first, for the second, ...
struct FieldArray {
  std::string name;
  std::string unit;  ///< "1" if without dimension
  int n_components = 1;
  std::variant<std::vector<double>, std::vector<std::int64_t>> values;  ///< integers for ids, materials, modes
};

/// Shapes a group may consist of, with the numbers VTK gives them.
enum class CellType : std::uint8_t { vertex = 1, line = 3, quad = 9 };

/// Particles, elements or contacts as an unstructured grid with cells of one shape. It may be empty.
struct FieldGroup {
  std::string name;  ///< "particles", "elements", "contacts"
  CellType cell_type = CellType::vertex;
  std::vector<double> points;              ///< three coordinates of each, m
  std::vector<std::int64_t> connectivity;  ///< the points of each cell
  std::vector<FieldArray> point_data;
  std::vector<FieldArray> cell_data;
};

/// The output a field file belongs to.
struct FieldStamp {
  std::int64_t step = 0;
  double time_s = 0;
};

/// A group as the bytes of a file, VTKHDF UnstructuredGrid 1.0, that is meant for this path. They depend on group, step
/// and time alone. Units are attributes of the arrays, step and time attributes of /VTKHDF. FileError, which names the
/// path and the reason, if HDF5 cannot make them.
std::string vtkhdf_image(const std::filesystem::path& path, const FieldGroup& group, std::int64_t step, double time_s);

/// What vtkhdf_image wrote as step and time; FileError if the file cannot be read or has none.
[[nodiscard]] FieldStamp read_field_stamp(const std::filesystem::path& path);

/// The values of an array such as "Points", "Connectivity" or "CellData/damage", row by row, integers as numbers too;
/// FileError if the file cannot be read or has no such array.
[[nodiscard]] std::vector<double> read_field_array(const std::filesystem::path& path, const std::string& name);

}  // namespace ligament
