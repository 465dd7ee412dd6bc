#include "generation/particle_limit.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace ligament {

void check_particle_count(double count) {
  constexpr double most = 2e7;
  if (count <= most) return;
  constexpr double bytes_per_particle = 700.0;  // with its contacts
  throw InputError(
      fmt::format("this would make {:.3g} particles, which take some {:.3g} GB, and the limit is {:.0g} particles: "
                  "larger particles or a smaller zone would do",
                  count, 1e-9 * bytes_per_particle * count, most));
}

}  // namespace ligament
