#pragma once

#include <cstddef>

#include "generation/obstacles.hpp"

namespace ligament {

/// An empty circle in touch with two obstacles, grown in touch with both until it meets a third. If it meets none
/// larger than it is, it comes back as it was.
Circle grow_circle(const Obstacles& obstacles, const Circle& corner, std::size_t first, std::size_t second);

}  // namespace ligament
