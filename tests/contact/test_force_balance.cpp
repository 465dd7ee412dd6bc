#include <doctest/doctest.h>

#include <cmath>

#include "support/random_numbers.hpp"
#include "support/three_kinds_of_contact.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// A displacement for every body, not small against the radius.
struct Deformation {
  Field<Vector> particles;
  Field<Rotation> rotations;
  Field<Vector> nodes;
};

Deformation random_deformation(const Model& model, RandomNumbers& random, double size) {
  Deformation deformation;
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    deformation.particles.push_back(random.vector(size));
    deformation.rotations.push_back(random.uniform(-size, size) / ThreeKindsOfContact::radius);
  }
  for (std::size_t i = 0; i < model.nodes.size(); ++i) deformation.nodes.push_back(random.vector(size));
  return deformation;
}

/// One step that adds `factor` times the deformation, forces with it.
void deform(ThreeKindsOfContact& bodies, const Deformation& deformation, double factor) {
  State& state = bodies.state;
  for (std::size_t i = 0; i < deformation.particles.size(); ++i) {
    displace(state.particles.translation, i,
             state.particles.translation.displacement[i] + factor * deformation.particles[i]);
    rotate(state.particles.rotation, i, state.particles.rotation.rotation[i] + factor * deformation.rotations[i]);
  }
  for (std::size_t i = 0; i < deformation.nodes.size(); ++i) {
    displace(state.nodes.translation, i, state.nodes.translation.displacement[i] + factor * deformation.nodes[i]);
  }
  bodies.add_forces();
}

template <class Pairing>
void check_balance(const ThreeKindsOfContact& bodies) {
  CAPTURE(Pairing::name);
  State state = bodies.state;
  clear_forces(state);
  ContactForces<Pairing>().add_forces(bodies.model, state);
  Vector force;
  Moment moment = 0.0;
  double force_scale = 0.0;
  const auto add = [&](const TranslationState& bodies_moved, const Field<Vector>& rest) {
    for (std::size_t i = 0; i < rest.size(); ++i) {
      force += bodies_moved.force[i];
      moment += cross(rest[i] + bodies_moved.displacement[i], bodies_moved.force[i]);
      force_scale = std::max(force_scale, norm(bodies_moved.force[i]));
    }
  };
  add(state.particles.translation, bodies.model.particles.position);
  add(state.nodes.translation, bodies.model.nodes.position);
  for (const Moment m : state.particles.rotation.moment) moment += m;
  REQUIRE(force_scale > 1.0);
  CHECK(norm(force) < 1e-14 * force_scale);
  CHECK(std::abs(moment) < 1e-14 * force_scale);
}

double stored_energy(const ThreeKindsOfContact& bodies) {
  double sum = 0.0;
  for (const ContactTable* contacts : bodies.tables()) sum += table_energies(bodies.model, *contacts).stored();
  return sum;
}

/// Σ F · du of a deformation, moments included.
double work(const ThreeKindsOfContact& bodies, const Deformation& deformation) {
  const State& state = bodies.state;
  double sum = 0.0;
  for (std::size_t i = 0; i < deformation.particles.size(); ++i) {
    sum += dot(state.particles.translation.force[i], deformation.particles[i]) +
           state.particles.rotation.moment[i] * deformation.rotations[i];
  }
  for (std::size_t i = 0; i < deformation.nodes.size(); ++i) {
    sum += dot(state.nodes.translation.force[i], deformation.nodes[i]);
  }
  return sum;
}

}  // namespace

TEST_CASE("contact forces of every kind have no resultant force and no resultant moment") {
  RandomNumbers random(7);
  for (int trial = 0; trial < 20; ++trial) {
    ThreeKindsOfContact bodies;
    for (int step = 0; step < 3; ++step) deform(bodies, random_deformation(bodies.model, random, 0.02), 1.0);
    check_balance<ParticlePairing>(bodies);
    check_balance<FacetPairing>(bodies);
    check_balance<CornerPairing>(bodies);
  }
}

TEST_CASE("the work of contact forces on the bodies is what the springs give, to second order") {
  RandomNumbers random(8);
  for (int trial = 0; trial < 20; ++trial) {
    const Deformation first = random_deformation(ThreeKindsOfContact().model, random, 5e-3);
    const Deformation second = random_deformation(ThreeKindsOfContact().model, random, 5e-3);
    const auto relative_defect = [&](double factor) {
      ThreeKindsOfContact bodies;
      deform(bodies, first, 1.0);
      const double energy = stored_energy(bodies);
      double done = 0.5 * factor * work(bodies, second);
      deform(bodies, second, factor);
      done += 0.5 * factor * work(bodies, second);
      return std::abs(done + stored_energy(bodies) - energy) / (factor * energy);
    };
    // A defect of third order in the step, a tenth of the step: a thousandth of it, over the step a hundredth.
    CHECK(relative_defect(0.1) < 0.02);
    CHECK(relative_defect(0.01) < 0.02 * relative_defect(0.1) + 1e-12);
  }
}

TEST_CASE("the energy of linear bonds is that of their springs, whatever the path") {
  RandomNumbers random(9);
  ThreeKindsOfContact bodies;
  for (int step = 0; step < 10; ++step) deform(bodies, random_deformation(bodies.model, random, 1e-3), 1.0);
  double energy = 0.0;
  for (const ContactTable* contacts : bodies.tables()) {
    for (std::size_t row = 0; row < contacts->size(); ++row) {
      CHECK(contacts->normal_force[row] ==
            doctest::Approx(-contacts->normal_stiffness[row] * contacts->opening[row]).epsilon(1e-14));
      CHECK(contacts->shear_force[row] ==
            doctest::Approx(-contacts->shear_stiffness[row] * contacts->shear_displacement[row]).epsilon(1e-12));
      energy +=
          0.5 * contacts->normal_stiffness[row] * contacts->opening[row] * contacts->opening[row] +
          0.5 * contacts->shear_stiffness[row] * contacts->shear_displacement[row] * contacts->shear_displacement[row];
    }
  }
  CHECK(stored_energy(bodies) == doctest::Approx(energy).epsilon(1e-12));
}
