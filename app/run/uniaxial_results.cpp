#include "run/uniaxial_results.hpp"

#include <algorithm>

namespace ligament {
namespace {

// choice: where tests of concrete take the secant, too (EN 12390-13).
constexpr double share_of_peak = 1.0 / 3.0;

}  // namespace

UniaxialResults uniaxial_results(const UniaxialTest& test, const std::vector<double>& loads,
                                 const std::vector<double>& elongations) {
  UniaxialResults results;
  const double peak = *std::max_element(loads.begin(), loads.end());
  results.strength = peak / test.area;
  for (std::size_t i = 1; i < loads.size(); ++i) {
    const double made = elongations[i] - elongations[i - 1];
    results.fracture_energy += 0.5 * (loads[i] + loads[i - 1]) * made / test.area;
    const double wanted = share_of_peak * peak;
    if (results.young_modulus != 0.0 || loads[i] < wanted) continue;
    const double elongation = elongations[i - 1] + made * (wanted - loads[i - 1]) / (loads[i] - loads[i - 1]);
    results.young_modulus = wanted / test.area * test.length / (elongation - elongations[0]);
  }
  return results;
}

}  // namespace ligament
