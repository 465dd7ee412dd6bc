#include "rejected.hpp"

using namespace ligament::test;

namespace {

/// The good case with bonds that soften.
std::string softening_case(const std::string& tension_energy, const std::string& shear_energy) {
  return edited("law = \"linear_elastic\"",
                "law = \"mohr_coulomb_bilinear\"\ntensile_strength = \"1 MPa\"\ncohesion = \"4 MPa\"\n"
                "friction_coefficient = 0.5\nfracture_energy_tension = \"" +
                    tension_energy + "\"\nfracture_energy_shear = \"" + shear_energy + "\"");
}

void check_snap(const std::string& tension_energy, const std::string& shear_energy, const std::string& beginning,
                const std::string& place_in_case) {
  const std::string text = softening_case(tension_energy, shear_energy);
  const Workplace place;
  place.write("case.toml", text);
  const Finished finished = place.run({"check", "case.toml"});
  CHECK(finished.code == 2);
  CHECK(contains(finished.err,
                 "case.toml:" + place_of(place_in_case, text) + ": " + beginning + ", but a contact needs at least "));
  CHECK(contains(finished.err,
                 " J/m2, or it snaps back: raise it, take smaller particles or law = "
                 "\"mohr_coulomb_brittle\" (contact of particle "));
  CHECK(contains(finished.err, " in [material.rock])\n"));
  CHECK(std::count(finished.err.begin(), finished.err.end(), '\n') == 1);
}

}  // namespace

TEST_CASE("bonds that would snap back: the worst contact and the energy that it needs") {
  // k_n/A = E'/L with L = 0.1 m, squeezed: G_ft >= σ_t² L/E' = 4.8 J/m2 at most; k_s/A = E''/L: G_fc >= 192 J/m2.
  const Workplace place;
  place.write("case.toml", softening_case("6 J/m2", "200 J/m2"));
  CHECK(place.run({"check", "case.toml"}).code == 0);
  check_snap("4 J/m2", "200 J/m2", "'fracture_energy_tension' is 4 J/m2", "\"4 J/m2\"");
  check_snap("6 J/m2", "150 J/m2", "'fracture_energy_shear' is 150 J/m2", "\"150 J/m2\"");
}

TEST_CASE("a softening law wants all that it softens by") {
  check_edit("law = \"linear_elastic\"",
             "law = \"mohr_coulomb_exponential\"\ntensile_strength = \"1 MPa\"\ncohesion = \"4 MPa\"\n"
             "friction_coefficient = 0.5\nfracture_energy_tension = \"0 J/m2\"\nfracture_energy_shear = \"1 kJ/m2\"",
             "'fracture_energy_tension' is 0 J/m2, but must be greater than 0 J/m2", "\"0 J/m2\"");
}
