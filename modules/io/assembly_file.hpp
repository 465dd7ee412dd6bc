#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/generator.hpp"

namespace ligament {

/// The discs of one zone.
struct ZoneAssembly {
  std::string zone;
  std::string generator;
  Rectangle region;
  Packing packing;
};

/// Assemblies, and where they come from.
struct Assemblies {
  std::string program_version;
  std::string case_text;      ///< the case file, byte for byte
  std::string case_resolved;  ///< with defaults and overrides in
  std::int64_t seed = 0;
  std::vector<ZoneAssembly> zones;
};

/// Writes HDF5, whole or not at all: a group per zone, with the datasets `position` (n x 2) and `radius` (n), both with
/// the attribute `unit`, and what the assembly is as attributes and texts. FileError if it cannot be written.
void write_assemblies_hdf5(const std::filesystem::path& path, const Assemblies& assemblies);

/// Writes the discs alone, whole or not at all: the header x_m,y_m,radius_m and a line per disc, with the fewest digits
/// that read back to the same bits. FileError if it cannot be written.
void write_discs_csv(const std::filesystem::path& path, const Packing& packing);

/// The discs in the content of such a file, which may come from elsewhere: of HDF5 the group called `zone`, or the only
/// one; of anything else the lines of a CSV. InputError, naming the file, and the row of a CSV, for what is no such
/// file; whether the numbers make sense is not asked.
[[nodiscard]] Packing read_discs(const std::string& content, const std::filesystem::path& path,
                                 const std::string& zone);

}  // namespace ligament
