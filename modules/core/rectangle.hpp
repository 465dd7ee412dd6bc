#pragma once

#include "core/vector.hpp"

namespace ligament {

/// An axis-parallel rectangle (m).
struct Rectangle {
  Vector from;
  Vector to;

  [[nodiscard]] Vector size() const { return to - from; }
};

}  // namespace ligament
