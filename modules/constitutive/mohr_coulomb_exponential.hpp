#pragma once

#include "constitutive/mohr_coulomb.hpp"

namespace ligament {

/// Mohr-Coulomb bond whose strengths fall as e^(-w f/G), with a straight tail.
struct MohrCoulombExponential : MohrCoulomb<ExponentialCurve> {};

}  // namespace ligament
