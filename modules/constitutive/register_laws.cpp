#include "constitutive/register_laws.hpp"

#include "constitutive/batch_law.hpp"
#include "constitutive/frictional.hpp"
#include "constitutive/linear_elastic.hpp"
#include "constitutive/mohr_coulomb_bilinear.hpp"
#include "constitutive/mohr_coulomb_brittle.hpp"
#include "constitutive/mohr_coulomb_exponential.hpp"

namespace ligament {
namespace {

template <PointLaw Law>
void add(Registry<ConstitutiveLaw>& laws, const char* name, const char* description) {
  laws.add(name, description, [] { return std::make_unique<BatchLaw<Law>>(); });
}

}  // namespace

Registry<ConstitutiveLaw> contact_laws() {
  Registry<ConstitutiveLaw> laws("law");
  add<LinearElastic>(laws, "linear_elastic", "elastic bond that never breaks");
  add<Frictional>(laws, "frictional", "no tension, Coulomb friction");
  add<MohrCoulombBilinear>(laws, "mohr_coulomb_bilinear", "bond that softens along two straight lines");
  add<MohrCoulombBrittle>(laws, "mohr_coulomb_brittle", "bond that loses its strength at once");
  add<MohrCoulombExponential>(laws, "mohr_coulomb_exponential", "bond that softens exponentially");
  return laws;
}

}  // namespace ligament
