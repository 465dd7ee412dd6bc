#include "generation/particle_limit.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace ligament {

void check_particle_count(double count) {
  // choice: at some 700 bytes per particle and its contacts this is 14 GB.
  constexpr double most = 2e7;
  if (count <= most) return;
  throw InputError(
      fmt::format("this would make {:.3g} particles, the limit is {:.0g}: larger particles or a smaller zone would do",
                  count, most));
}

}  // namespace ligament
