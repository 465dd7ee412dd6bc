#include <doctest/doctest.h>

#include "constitutive/batch_law.hpp"
#include "constitutive/linear_elastic.hpp"
#include "constitutive/register_laws.hpp"
#include "core/error.hpp"
#include "core/parameters.hpp"
#include "reference/scalar_laws.hpp"
#include "support/contact_batch_arrays.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

void shake(ContactBatchArrays& batch, RandomNumbers& random) {
  for (std::size_t i = 0; i < batch.opening.size(); ++i) {
    batch.opening[i] = random.uniform(-2e-6, 1e-6);
    batch.slip_increment[i] = random.uniform(-1e-6, 1e-6);
  }
}

ContactInput input_of(const ContactBatchArrays& batch, std::size_t i) {
  return {batch.opening[i], batch.slip_increment[i], batch.normal_stiffness[i], batch.shear_stiffness[i],
          batch.area[i]};
}

}  // namespace

TEST_CASE("a batch of elastic bonds gives what the scalar loop gives, to the bit") {
  const BatchLaw<LinearElastic> law;
  ContactBatchArrays batch(law, 700);
  std::vector<ContactForce> twin(700, {0.0, 0.0, BondState::bonded});
  RandomNumbers random(25);
  for (int step = 0; step < 20; ++step) {
    shake(batch, random);
    batch.evaluate(law);
    for (std::size_t i = 0; i < twin.size(); ++i) {
      twin[i] = reference::elastic_force(input_of(batch, i), twin[i]);
      REQUIRE(batch.normal_force[i] == twin[i].normal);
      REQUIRE(batch.shear_force[i] == twin[i].shear);
      REQUIRE(batch.bond[i] == BondState::bonded);
    }
  }
}

TEST_CASE("a batch of frictional contacts gives what the scalar loop gives") {
  const BatchLaw<Frictional> law(Frictional{0.4});
  ContactBatchArrays batch(law, 700);
  std::vector<reference::SlidingForce> twin(700);
  RandomNumbers random(26);
  for (int step = 0; step < 50; ++step) {
    shake(batch, random);
    batch.evaluate(law);
    for (std::size_t i = 0; i < twin.size(); ++i) {
      const auto next = reference::sliding_force(0.4, input_of(batch, i), twin[i].force);
      twin[i] = {next.force, twin[i].friction_work + next.friction_work};
      REQUIRE(batch.normal_force[i] == twin[i].force.normal);
      REQUIRE(batch.shear_force[i] == doctest::Approx(twin[i].force.shear).epsilon(1e-12));
      REQUIRE(batch.history[0][i] == doctest::Approx(twin[i].friction_work).epsilon(1e-9).scale(1e-3));
    }
  }
}

TEST_CASE("energies of a batch are the sums over its contacts") {
  const BatchLaw<Frictional> law(Frictional{0.4});
  ContactBatchArrays batch(law, 1300);
  RandomNumbers random(27);
  for (int step = 0; step < 10; ++step) {
    shake(batch, random);
    batch.evaluate(law);
  }
  double normal = 0.0;
  double shear = 0.0;
  double friction = 0.0;
  for (std::size_t i = 0; i < batch.opening.size(); ++i) {
    normal += 0.5 * batch.normal_force[i] * batch.normal_force[i] / 2e9;
    shear += 0.5 * batch.shear_force[i] * batch.shear_force[i] / 1e9;
    friction += batch.history[0][i];
  }
  const ContactEnergies energies = batch.energies(law);
  CHECK(energies.elastic_normal == doctest::Approx(normal).epsilon(1e-13));
  CHECK(energies.elastic_shear == doctest::Approx(shear).epsilon(1e-13));
  CHECK(energies.friction == doctest::Approx(friction).epsilon(1e-13));
  CHECK(energies.fracture_tension == 0.0);
  CHECK(energies.fracture_shear == 0.0);
}

TEST_CASE("an elastic bond stores ½ k u² in tension as in compression") {
  const BatchLaw<LinearElastic> law;
  for (const double opening : {1e-6, -1e-6}) {
    ContactBatchArrays batch(law, 1);
    batch.opening[0] = opening;
    batch.slip_increment[0] = 2e-6;
    batch.evaluate(law);
    CHECK(batch.normal_force[0] == doctest::Approx(-2e9 * opening).epsilon(1e-15));
    CHECK(batch.shear_force[0] == doctest::Approx(-2e3).epsilon(1e-15));
    const ContactEnergies energies = batch.energies(law);
    CHECK(energies.elastic_normal == doctest::Approx(0.5 * 2e9 * 1e-12).epsilon(1e-14));
    CHECK(energies.elastic_shear == doctest::Approx(0.5 * 1e9 * 4e-12).epsilon(1e-14));
    CHECK(energies.spent() == 0.0);
  }
}

TEST_CASE("an empty batch is no trouble") {
  const BatchLaw<Frictional> law;
  ContactBatchArrays batch(law, 0);
  batch.evaluate(law);
  CHECK(batch.energies(law).stored() == 0.0);
}

TEST_CASE("laws are found by name, parameters set through their declaration, friction passed on") {
  const auto laws = contact_laws();
  CHECK(laws.contains("linear_elastic"));
  CHECK(laws.contains("frictional"));
  CHECK_THROWS_WITH_AS(laws.create("linear_elastik"), doctest::Contains("did you mean 'linear_elastic'"), InputError);
  for (const char* name : {"linear_elastic", "frictional"}) {
    const auto law = laws.create(name);
    Parameters parameters;
    law->declare(parameters);
    for (Parameter& parameter : parameters.list()) {
      if (parameter.name == "friction_coefficient") parameter.assign(0.25);
    }
    const auto contact = law->contact_law();
    ContactBatchArrays batch(*contact, 1);
    batch.opening[0] = -1e-6;
    batch.slip_increment[0] = 1.0;
    batch.evaluate(*contact);
    CHECK(batch.shear_force[0] == doctest::Approx(-0.25 * 2e3).epsilon(1e-14));
  }
}

TEST_CASE("friction is required of a frictional law and must not be negative") {
  const auto law = contact_laws().create("frictional");
  Parameters parameters;
  law->declare(parameters);
  const Parameter* friction = parameters.find("friction_coefficient");
  REQUIRE(friction != nullptr);
  CHECK(friction->required);
  CHECK(friction->complaint(-0.1).has_value());
  CHECK_FALSE(friction->complaint(0.0).has_value());
}
