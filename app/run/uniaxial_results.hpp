#pragma once

#include <vector>

#include "build/uniaxial_test.hpp"

namespace ligament {

/// What a uniaxial test measures.
struct UniaxialResults {
  double strength = 0.0;         ///< peak of the load over the cross-section (Pa)
  double young_modulus = 0.0;    ///< secant at a third of the peak (Pa)
  double fracture_energy = 0.0;  ///< area below load over elongation up to the end, over the cross-section (J/m2)
};

/// From successive loads (N) and elongations (m), the first at rest. The load is positive as the elongation is.
UniaxialResults uniaxial_results(const UniaxialTest& test, const std::vector<double>& loads,
                                 const std::vector<double>& elongations);

}  // namespace ligament
