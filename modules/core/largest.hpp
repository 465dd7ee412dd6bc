#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

namespace ligament {

/// The largest of numbers that are not negative; not a number if one of them is none. Their bits as whole numbers have
/// that order, and compilers make vector instructions of loops over these.
class Largest {
 public:
  void see(double number) {
    constexpr std::int64_t all_but_sign = std::numeric_limits<std::int64_t>::max();
    bits_ = std::max(bits_, std::bit_cast<std::int64_t>(number) & all_but_sign);
  }
  Largest& operator+=(const Largest& other) {
    bits_ = std::max(bits_, other.bits_);
    return *this;
  }
  [[nodiscard]] double value() const { return std::bit_cast<double>(bits_); }

 private:
  std::int64_t bits_ = 0;
};

}  // namespace ligament
