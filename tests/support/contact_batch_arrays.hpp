#pragma once

#include <vector>

#include "core/constitutive_law.hpp"

namespace ligament::support {

/// Arrays of a batch of contacts of one law.
struct ContactBatchArrays {
  std::vector<double> opening;
  std::vector<ShearVector> slip_increment;
  std::vector<double> normal_stiffness;
  std::vector<double> shear_stiffness;
  std::vector<double> area;
  std::vector<double> normal_force;
  std::vector<ShearVector> shear_force;
  std::vector<BondState> bond;
  std::vector<std::vector<double>> history;

  /// k_n = 2 GN/m, k_s = 1 GN/m, A = 0.01 m2, history at its initial values.
  ContactBatchArrays(const ConstitutiveLaw& law, std::size_t count)
      : opening(count, 0.0),
        slip_increment(count, 0.0),
        normal_stiffness(count, 2e9),
        shear_stiffness(count, 1e9),
        area(count, 0.01),
        normal_force(count, 0.0),
        shear_force(count, 0.0),
        bond(count, BondState::bonded) {
    for (const HistoryVariable& variable : law.history()) history.emplace_back(count, variable.initial_value);
  }

  void evaluate(const ConstitutiveLaw& law) {
    std::vector<double*> pointers;
    for (auto& column : history) pointers.push_back(column.data());
    law.evaluate(
        {opening, slip_increment, normal_stiffness, shear_stiffness, area, normal_force, shear_force, bond, pointers});
  }
  [[nodiscard]] ContactEnergies energies(const ConstitutiveLaw& law) const {
    std::vector<const double*> pointers;
    for (const auto& column : history) pointers.push_back(column.data());
    return law.energies({opening, normal_stiffness, shear_stiffness, area, normal_force, shear_force, bond, pointers});
  }
};

}  // namespace ligament::support
