#include "counters.hpp"
#include "lattice.hpp"

/// Forces of all contacts of a lattice in motion: kinematics, law, forces on the bodies.
namespace {

using namespace ligament;
using namespace ligament::benchmarks;

void contact_step(benchmark::State& run) {
  const auto n_contacts = static_cast<std::size_t>(run.range(0));
  Simulation simulation = settling_lattice(n_contacts / 3);
  for (int i = 0; i < 20; ++i) simulation.step();
  State state = simulation.state();
  ContactForces<ParticlePairing> forces;
  for ([[maybe_unused]] auto _ : run) {
    forces.add_forces(simulation.model(), state);
    benchmark::ClobberMemory();
  }
  count_items(run, "contacts", state.particle_contacts.size());
}
BENCHMARK(contact_step)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMicrosecond);

}  // namespace
