#include "build/generate_packings.hpp"
#include "contact/particle_search.hpp"
#include "counters.hpp"
#include "lattice.hpp"

/// What happens before the first step and, now and then, between steps: packing and search.
namespace {

using namespace ligament;
using namespace ligament::benchmarks;

void hexagonal_packing(benchmark::State& run) {
  const Rectangle region = lattice_region(static_cast<std::size_t>(run.range(0)));
  std::size_t n_particles = 0;
  for ([[maybe_unused]] auto _ : run) {
    n_particles = support::hexagonal_packing(region, lattice_radius, "x").size();
  }
  count_items(run, "particles", n_particles);
}
BENCHMARK(hexagonal_packing)->Arg(10'000)->Unit(benchmark::kMicrosecond);

/// The random assembly R1, and the graded ones of three beams: 3000, 7000 and 30 000 particles.
void case_packing(benchmark::State& run, const std::string& path) {
  Case input = read_case(path, {});
  std::size_t n_particles = 0;
  for ([[maybe_unused]] auto _ : run) n_particles = generate_packings(input).front().size();
  count_items(run, "particles", n_particles);
}
BENCHMARK_CAPTURE(case_packing, column_random_r1, LIGAMENT_SOURCE_DIR "/config/column_random_r1.toml")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(case_packing, petersson_beam, LIGAMENT_SOURCE_DIR "/config/petersson_beam.toml")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(case_packing, arrea_beam, LIGAMENT_SOURCE_DIR "/config/arrea_beam.toml")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(case_packing, petersson_beam_particles, LIGAMENT_SOURCE_DIR "/config/petersson_beam_particles.toml")
    ->Unit(benchmark::kMillisecond);

void particle_search(benchmark::State& run) {
  const Model model = lattice_model(static_cast<std::size_t>(run.range(0)));
  std::size_t n_pairs = 0;
  for ([[maybe_unused]] auto _ : run) {
    n_pairs =
        find_particle_pairs(model.particles.position, model.particles.radius, [](Index, Index) { return lattice_skin; },
                            {.smallest = lattice_skin, .largest = lattice_skin})
            .size();
  }
  count_items(run, "pairs", n_pairs);
}
BENCHMARK(particle_search)->Arg(10'000)->Unit(benchmark::kMillisecond);

}  // namespace
