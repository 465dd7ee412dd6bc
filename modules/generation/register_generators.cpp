#include "generation/register_generators.hpp"

#include "generation/hexagonal.hpp"

namespace ligament {

Registry<Generator> generators() {
  Registry<Generator> all("generator");
  all.add("hexagonal", "equal discs in a hexagonal lattice fitted to the zone",
          [] { return std::make_unique<Hexagonal>(); });
  return all;
}

}  // namespace ligament
