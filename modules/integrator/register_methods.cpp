#include "integrator/register_methods.hpp"

#include "integrator/central_difference.hpp"
#include "integrator/dynamic_relaxation.hpp"
#include "integrator/local_damping.hpp"
#include "integrator/momentum_relaxation.hpp"
#include "integrator/no_damping.hpp"
#include "integrator/secant_relaxation.hpp"
#include "integrator/two_level_relaxation.hpp"

namespace ligament {
namespace {

/// Central differences with a way of damping.
template <class OwnDamping>
void add(Registry<Integrator>& methods, const char* name, const char* description) {
  methods.add(name, description, [] { return std::make_unique<CentralDifference>(std::make_unique<OwnDamping>()); });
}

}  // namespace

Registry<Integrator> solver_methods() {
  Registry<Integrator> all("solver method");
  add<DynamicRelaxation>(all, "dynamic_relaxation", "viscous damping that adapts itself, after Underwood");
  add<LocalDamping>(all, "local_damping", "Cundall's local damping");
  add<NoDamping>(all, "undamped", "no damping: dynamics, energy tests");
  all.add("two_level_relaxation", "adaptive relaxation with masses that fit slow motions of the structure as well",
          [] { return std::make_unique<TwoLevelRelaxation>(); });
  return all;
}

Registry<IncrementalLoading> loading_methods() {
  Registry<IncrementalLoading> all("solver method");
  all.add("quasi_static", "loading in increments, each relaxed to equilibrium: every row is one of equilibrium",
          [] { return std::make_unique<IncrementalLoading>(std::make_unique<MomentumRelaxation>()); });
  all.add("secant", "the same increments, each solved directly with secant stiffness; may follow a gauge",
          [] { return std::make_unique<IncrementalLoading>(std::make_unique<SecantRelaxation>()); });
  return all;
}

}  // namespace ligament
