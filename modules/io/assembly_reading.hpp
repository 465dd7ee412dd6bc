#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/generator.hpp"

namespace ligament {

inline constexpr std::string_view discs_csv_header = "x_m,y_m,radius_m";

/// The two halves of read_discs().
[[nodiscard]] Packing read_discs_csv(std::string_view content, const std::filesystem::path& path);
[[nodiscard]] Packing read_discs_hdf5(const std::string& content, const std::filesystem::path& path,
                                      const std::string& zone);

}  // namespace ligament
