#pragma once

#include <algorithm>
#include <cmath>

namespace ligament {

/// What became of a stride.
enum class Stride {
  refused,  ///< it is to be shorter; never for a stride of one part
  even,     ///< taken, nothing changed its course on it
  uneven,   ///< taken as the one part that it is
};

/// Goes a way of so many parts in strides as long as they are let be: try_stride(from, to), in parts, says what became
/// of a stride. A stride that is refused is halved, and halved again on the way to what lies in it; parts of uneven
/// ground are taken one by one.
template <class TryStride>
void walk_in_strides(double n_parts, TryStride&& try_stride) {
  double stride = n_parts;
  bool is_near = false;  // to what a longer stride was refused for
  for (double done = 0.0; done < n_parts;) {
    stride = std::min(stride, n_parts - done);
    const Stride result = try_stride(done, done + stride);
    if (result == Stride::refused) {
      is_near = true;
      stride = std::floor(0.5 * stride);
      continue;
    }
    done += stride;
    if (result == Stride::uneven) is_near = false;
    if (result == Stride::even) stride = is_near ? std::max(1.0, std::floor(0.5 * stride)) : 2.0 * stride;
  }
}

}  // namespace ligament
