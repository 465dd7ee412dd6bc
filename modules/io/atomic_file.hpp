#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace ligament {

/// Where a file is written before it takes its name: `<name>.part` in the same folder.
[[nodiscard]] std::filesystem::path part_path(const std::filesystem::path& final_path);

/// Replaces `final_path` by `content` so that readers, and a machine that stops at any moment, find either the whole
/// old file or the whole new one. FileError names the path and the reason; the old file is then untouched and no
/// `.part` stays behind.
void write_atomically(const std::filesystem::path& final_path, std::string_view content);
/// The same for content that lies in several places.
void write_atomically(const std::filesystem::path& final_path, std::initializer_list<std::string_view> pieces);

/// Second half of write_atomically for a `part` written by someone else: flushes it, renames it, flushes the folder.
/// On failure the part is removed.
void publish(const std::filesystem::path& part, const std::filesystem::path& final_path);

/// The whole file; FileError names the path and the reason.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

}  // namespace ligament
