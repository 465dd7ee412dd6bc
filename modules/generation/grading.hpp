#pragma once

#include <string>
#include <vector>

#include "core/vector.hpp"
#include "generation/random_numbers.hpp"

namespace ligament {

class Parameters;

/// Grains that stay between two sieves.
struct SieveClass {
  double from = 0.0;   ///< least diameter (m)
  double to = 0.0;     ///< greatest diameter (m)
  double share = 0.0;  ///< of the mass of all grains
};

/// The grading of an aggregate: sieves, and what stays between them.
class Grading {
 public:
  void declare(Parameters& parameters);

  /// Throws InputError if sieves and shares do not fit each other, or if no grain is as large as the threshold.
  void check() const;

  /// The classes of grains of the threshold diameter and more, in ascending order.
  [[nodiscard]] std::vector<SieveClass> classes() const;
  [[nodiscard]] double threshold_diameter() const { return threshold_diameter_; }

 private:
  void check_sieves() const;
  void check_threshold() const;

  std::vector<double> sieves_;
  std::vector<double> mass_shares_;
  double threshold_diameter_ = 0.0;
};

/// The diameter (m) of a grain of a class whose mass is spread evenly over its diameters. A disc's mass goes with d²,
/// so the number of grains has the density ~ 1/d², and the distribution function (1/from - 1/d)/(1/from - 1/to).
double draw_diameter(const SieveClass& sieve_class, RandomNumbers& random);

/// Radii (m) of grains of a class whose areas add up to this (m²), as nearly as whole grains can.
Field<double> draw_grains(const SieveClass& sieve_class, double area, RandomNumbers& random);

}  // namespace ligament
