#include <doctest/doctest.h>

#include "contact/contact_forces.hpp"
#include "contact/grid_contact_detector.hpp"
#include "contact/region_mean.hpp"
#include "support/hand_made_model.hpp"
#include "support/resting_state.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr double radius = 0.1;
constexpr int n_columns = 20;
constexpr int n_rows = 24;
const double row_pitch = std::sqrt(3.0) * radius;

/// A hexagonal lattice whose springs stand for E and ν, every disc displaced by a uniform strain.
struct StrainedLattice {
  Model model = empty_model({.young_modulus = 20e9,
                             .poisson_ratio = 0.2,
                             .thickness = 0.5,
                             .detection_gap = 1e-6,
                             .stiffness = StiffnessFormula::hexagonal});
  State state;

  explicit StrainedLattice(const SymmetricTensor& strain) {
    for (int row = 0; row < n_rows; ++row) {
      for (int column = 0; column < n_columns; ++column) {
        add_particle(model, {2.0 * radius * (column + 0.5 * (row % 2)), row_pitch * row}, radius);
      }
    }
    state = resting_state(model);
    GridContactDetector(1e-6).bond(model, state);
    for (std::size_t i = 0; i < model.particles.size(); ++i) {
      const Vector& x = model.particles.position[i];
      const Vector u{strain.xx * x.x + strain.xy * x.y, strain.xy * x.x + strain.yy * x.y};
      state.particles.translation.displacement[i] = state.particles.translation.increment[i] = u;
    }
    ContactForces<ParticlePairing>().add_forces(model, state);
  }

  /// A rectangle inside that holds whole cells of the lattice.
  [[nodiscard]] static Rectangle whole_cells() {
    const Vector corner{3.3 * radius, 2.6 * row_pitch};
    return {corner, corner + Vector{2.0 * radius * 14, row_pitch * 18}};
  }
};

constexpr double modulus = 20e9 / (1.0 - 0.2 * 0.2);

}  // namespace

TEST_CASE("the mean strain of a uniform strain is that strain, wherever the region lies") {
  const SymmetricTensor strain{3e-6, -1e-6, 2e-6};
  const StrainedLattice lattice(strain);
  for (const Rectangle& region : {StrainedLattice::whole_cells(), Rectangle{{0.5, 0.7}, {1.3, 1.9}}}) {
    const SymmetricTensor mean = mean_strain(lattice.model, lattice.state, region);
    CHECK(mean.xx == doctest::Approx(strain.xx).epsilon(1e-12));
    CHECK(mean.yy == doctest::Approx(strain.yy).epsilon(1e-12));
    CHECK(mean.xy == doctest::Approx(strain.xy).epsilon(1e-12));
  }
}

TEST_CASE("a rigid turn is no strain") {
  StrainedLattice lattice({});
  for (std::size_t i = 0; i < lattice.model.particles.size(); ++i) {
    lattice.state.particles.translation.displacement[i] = cross(Spin{1e-3}, lattice.model.particles.position[i]);
  }
  const SymmetricTensor mean = mean_strain(lattice.model, lattice.state, StrainedLattice::whole_cells());
  CHECK(std::abs(mean.xx) + std::abs(mean.yy) + std::abs(mean.xy) < 1e-16);
}

TEST_CASE("the mean stress over whole cells is that of the continuum, tension positive") {
  for (const SymmetricTensor& strain : {SymmetricTensor{1e-9, 0.0, 0.0}, {0.0, 1e-9, 0.0}, {0.0, 0.0, 1e-9}}) {
    const StrainedLattice lattice(strain);
    const SymmetricTensor mean = mean_stress(lattice.model, lattice.state, StrainedLattice::whole_cells());
    const SymmetricTensor wanted{modulus * (strain.xx + 0.2 * strain.yy), modulus * (strain.yy + 0.2 * strain.xx),
                                 modulus * (1.0 - 0.2) * strain.xy};
    const double scale = modulus * 1e-9;
    CHECK(std::abs(mean.xx - wanted.xx) < 1e-7 * scale);
    CHECK(std::abs(mean.yy - wanted.yy) < 1e-7 * scale);
    CHECK(std::abs(mean.xy - wanted.xy) < 1e-7 * scale);
  }
}

TEST_CASE("particles are counted by their centres") {
  const StrainedLattice lattice({});
  CHECK(count_particles(lattice.model, {{-0.01, -0.01}, {0.21, 0.01}}) == 2);
  CHECK(count_particles(lattice.model, {{0.05, 0.01}, {0.06, 0.02}}) == 0);
}
