#include "generation/register_generators.hpp"

#include "generation/graded_assembly.hpp"
#include "generation/hexagonal.hpp"
#include "generation/random_assembly.hpp"

namespace ligament {

Registry<Generator> generators() {
  Registry<Generator> all("generator");
  all.add("hexagonal", "equal discs in a hexagonal lattice fitted to the zone",
          [] { return std::make_unique<Hexagonal>(); });
  all.add("random", "discs of random radii, grown and squeezed until their overlaps are even",
          [] { return std::make_unique<RandomAssembly>(); });
  all.add("graded", "concrete: grains by a grading curve, squeezed into the zone, and discs in the voids between them",
          [] { return std::make_unique<GradedAssembly>(); });
  return all;
}

}  // namespace ligament
