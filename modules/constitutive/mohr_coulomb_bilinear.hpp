#pragma once

#include "constitutive/mohr_coulomb.hpp"

namespace ligament {

/// Mohr-Coulomb bond that softens along two straight lines; the one-fourth law (Rokugo et al. 1989) by default.
struct MohrCoulombBilinear : MohrCoulomb<BilinearCurve> {
  void declare(Parameters& parameters) {
    MohrCoulomb::declare(parameters);
    parameters
        .number("kink_opening", curve.kink_opening,
                "w f/G where the two lines of the softening curve meet; the second ends where the area is G")
        .greater_than(0.0)
        .at_most(1.0);
    parameters.number("kink_strength", curve.kink_strength, "part of the strength that is left there")
        .greater_than(0.0)
        .less_than(1.0);
  }
};

}  // namespace ligament
