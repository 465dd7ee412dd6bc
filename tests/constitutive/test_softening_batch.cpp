#include <doctest/doctest.h>

#include "constitutive/register_laws.hpp"
#include "core/parameters.hpp"
#include "support/contact_batch_arrays.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// A registered law with the paper's Table 4, its strengths scaled to the bonds of the batch.
std::unique_ptr<ConstitutiveLaw> law_by_name(const char* name) {
  auto law = contact_laws().create(name);
  Parameters parameters;
  law->declare(parameters);
  for (Parameter& parameter : parameters.list()) {
    if (parameter.name == "tensile_strength") parameter.assign(1.8e5);
    if (parameter.name == "cohesion") parameter.assign(6.5e5);
    if (parameter.name == "friction_coefficient") parameter.assign(0.2);
    if (parameter.name == "fracture_energy_tension") parameter.assign(1.0);
    if (parameter.name == "fracture_energy_shear") parameter.assign(50.0);
  }
  return law;
}

struct Motion {
  double opening = 0.0;
  double slip = 0.0;
};

/// One contact by itself through all steps.
ContactBatchArrays alone(const ConstitutiveLaw& law, const std::vector<std::vector<Motion>>& steps, std::size_t i) {
  ContactBatchArrays batch(law, 1);
  for (const auto& step : steps) {
    batch.opening[0] = step[i].opening;
    batch.slip_increment[0] = step[i].slip;
    batch.evaluate(law);
  }
  return batch;
}

}  // namespace

TEST_CASE("a softening contact has the same bits alone as at any place of any batch") {
  constexpr std::size_t count = 1100;
  for (const char* name : {"mohr_coulomb_bilinear", "mohr_coulomb_brittle", "mohr_coulomb_exponential"}) {
    CAPTURE(std::string(name));
    const auto law = law_by_name(name);
    RandomNumbers random(61);
    std::vector<std::vector<Motion>> steps(12, std::vector<Motion>(count));
    for (auto& step : steps) {
      for (Motion& motion : step) motion = {random.uniform(-4e-6, 4e-6), random.uniform(-1e-5, 1e-5)};
    }
    ContactBatchArrays batch(*law, count);
    for (const auto& step : steps) {
      for (std::size_t i = 0; i < count; ++i) {
        batch.opening[i] = step[i].opening;
        batch.slip_increment[i] = step[i].slip;
      }
      batch.evaluate(*law);
    }
    std::array<int, 4> n_of_bond{};
    for (std::size_t i = 0; i < count; ++i) {
      const ContactBatchArrays one = alone(*law, steps, i);
      REQUIRE(one.normal_force[0] == batch.normal_force[i]);
      REQUIRE(one.shear_force[0] == batch.shear_force[i]);
      REQUIRE(one.bond[0] == batch.bond[i]);
      for (std::size_t k = 0; k < one.history.size(); ++k) REQUIRE(one.history[k][0] == batch.history[k][i]);
      ++n_of_bond[static_cast<std::size_t>(batch.bond[i])];
    }
    CHECK(n_of_bond[static_cast<std::size_t>(BondState::broken)] > 0);
    if (std::string(name) != "mohr_coulomb_brittle") {
      CHECK(n_of_bond[static_cast<std::size_t>(BondState::softening)] > 0);
    }
  }
}

TEST_CASE("contacts between the same bodies that form later take friction from a softening law") {
  const auto contact = law_by_name("mohr_coulomb_bilinear")->contact_law();
  ContactBatchArrays batch(*contact, 1);
  batch.opening[0] = -1e-6;
  batch.slip_increment[0] = 1.0;
  batch.evaluate(*contact);
  CHECK(batch.shear_force[0] == doctest::Approx(-0.2 * 2e3).epsilon(1e-14));
}

TEST_CASE("only a law that can snap has something against a contact") {
  const ContactSample stiff{1e3, 1e3, 1.0};
  CHECK(law_by_name("mohr_coulomb_bilinear")->complaint(stiff).has_value());
  CHECK(law_by_name("mohr_coulomb_exponential")->complaint(stiff).has_value());
  CHECK_FALSE(law_by_name("mohr_coulomb_brittle")->complaint(stiff).has_value());
  CHECK_FALSE(law_by_name("linear_elastic")->complaint(stiff).has_value());
}
