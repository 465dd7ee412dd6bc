#include <doctest/doctest.h>

#include "integrator/freedom_columns.hpp"
#include "integrator/stiffness_mass.hpp"
#include "support/hand_made_model.hpp"

using namespace ligament;
using namespace ligament::support;

TEST_CASE("with the stiffness as mass all motions have one frequency, at half of the stability bound") {
  Model model = empty_model();
  for (int i = 0; i < 3; ++i) add_particle(model, {0.1 * i, 0.0}, 0.05);
  model.particles.free[1] = {0.0, 1.0};
  StiffnessSum stiffness(model);
  const auto count = static_cast<Index>(stiffness.numbers().count());
  for (Index i = 0; i < count; ++i) stiffness.add_spring(std::vector<SpringTerm>{{i, 1.0}}, 1.0 + i);
  for (Index i = 0; i + 3 < count; ++i) stiffness.add_spring(std::vector<SpringTerm>{{i, -1.0}, {i + 3, 0.5}}, 10.0);

  const std::vector<double> free = free_mask(model);
  StiffnessMass mass(stiffness, free);
  for (std::size_t at = 0; at < free.size(); ++at) {
    std::vector<double> momenta(free.size(), 0.0);
    momenta[at] = free[at];
    const std::vector<double> velocities = mass.velocities(momenta);
    // ω² M v = K v with M v = p, and a step of 1 s is stable up to ω² = 4.
    const std::vector<double> forces = stiffness.times(velocities);
    for (std::size_t i = 0; i < free.size(); ++i) {
      if (free[i] == 0.0) {
        CHECK(velocities[i] == 0.0);
      } else {
        CHECK(forces[i] == doctest::Approx(2.0 * momenta[i]).epsilon(1e-7));
      }
    }
  }
}
