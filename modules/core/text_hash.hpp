#pragma once

#include <string>
#include <string_view>

namespace ligament {

/// 128-bit XXH3 hash of a text (32 hex digits).
std::string text_hash(std::string_view text);

}  // namespace ligament
