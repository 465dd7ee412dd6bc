#pragma once

#include "core/generator.hpp"

namespace ligament {

/// Equal discs in lines of n and n-1 in turn. The lines run parallel to the shorter side; the ends of the long ones lie
/// half a radius from the border, and the pitches are squeezed so that the lattice fits and all neighbours touch.
class Hexagonal : public Generator {
 public:
  enum class Lines { shorter_side, x, y };

  void declare(Parameters& parameters) override;
  [[nodiscard]] bool depends_on_seed() const override { return false; }
  [[nodiscard]] Packing generate(const Rectangle& region, std::uint64_t seed) const override;
  [[nodiscard]] double default_detection_gap() const override { return 1e-6; }
  /// The ends of the short lines, half a pitch behind those of the long ones, are to be linked too.
  [[nodiscard]] double default_interface_gap() const override { return 0.5; }

 private:
  double radius_ = 0.0;
  Lines lines_ = Lines::shorter_side;
};

}  // namespace ligament
