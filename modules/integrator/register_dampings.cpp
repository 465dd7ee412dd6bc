#include "integrator/register_dampings.hpp"

#include "integrator/dynamic_relaxation.hpp"
#include "integrator/local_damping.hpp"
#include "integrator/no_damping.hpp"

namespace ligament {

Registry<Damping> dampings() {
  Registry<Damping> all("solver method");
  all.add("dynamic_relaxation", "viscous damping that adapts itself, after Underwood",
          [] { return std::make_unique<DynamicRelaxation>(); });
  all.add("local_damping", "Cundall's local damping", [] { return std::make_unique<LocalDamping>(); });
  all.add("undamped", "no damping: dynamics, energy tests", [] { return std::make_unique<NoDamping>(); });
  return all;
}

}  // namespace ligament
