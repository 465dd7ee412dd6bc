#include "generation/grading.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "core/error.hpp"
#include "core/parameters.hpp"
#include "generation/particle_limit.hpp"

namespace ligament {

void Grading::declare(Parameters& parameters) {
  parameters.quantities("sieves", sieves_, "m", "openings of the sieves, ascending; 0 m is the pan")
      .required()
      .at_least(0.0)
      .length_at_least(2);
  parameters
      .numbers("mass_shares", mass_shares_,
               "share of the aggregate's mass that stays between each sieve and the next larger one; their sum is 1")
      .required()
      .at_least(0.0)
      .at_most(1.0)
      .length_at_least(1);
  parameters
      .quantity("threshold_diameter", threshold_diameter_, "m",
                "grains of this diameter and more become particles; one of the sieves")
      .required()
      .greater_than(0.0);
}

void Grading::check() const {
  check_sieves();
  const double sum = std::accumulate(mass_shares_.begin(), mass_shares_.end(), 0.0);
  constexpr double rounding = 1e-6;
  if (!(std::abs(sum - 1.0) <= rounding)) {
    throw InputError(fmt::format("the mass shares add up to {:.6g}, and should to 1", sum));
  }
  check_threshold();
}

void Grading::check_sieves() const {
  if (mass_shares_.size() + 1 != sieves_.size()) {
    throw InputError(fmt::format("{} sieves have {} classes between them, but there are {} mass shares", sieves_.size(),
                                 sieves_.size() - 1, mass_shares_.size()));
  }
  for (std::size_t i = 0; i + 1 < sieves_.size(); ++i) {
    if (sieves_[i] < sieves_[i + 1]) continue;
    throw InputError(fmt::format("the sieves must ascend, but {:g} m comes before {:g} m", sieves_[i], sieves_[i + 1]));
  }
}

void Grading::check_threshold() const {
  bool is_sieve = false;
  for (const double sieve : sieves_) is_sieve = is_sieve || sieve == threshold_diameter_;
  if (!is_sieve) {
    throw InputError(
        fmt::format("the threshold diameter, {:g} m, must be one of the sieves: a class is taken as a whole or not at "
                    "all",
                    threshold_diameter_));
  }
  double sum = 0.0;
  for (const SieveClass& sieve_class : classes()) sum += sieve_class.share;
  if (sum > 0.0) return;
  throw InputError(fmt::format("no grain is as large as the threshold diameter, {:g} m", threshold_diameter_));
}

std::vector<SieveClass> Grading::classes() const {
  std::vector<SieveClass> found;
  for (std::size_t i = 0; i < mass_shares_.size(); ++i) {
    if (sieves_[i] >= threshold_diameter_) found.push_back({sieves_[i], sieves_[i + 1], mass_shares_[i]});
  }
  return found;
}

double draw_diameter(const SieveClass& sieve_class, RandomNumbers& random) {
  const auto& [from, to, share] = sieve_class;
  return from * to / (to - random.unit() * (to - from));
}

Field<double> draw_grains(const SieveClass& sieve_class, double area, RandomNumbers& random) {
  check_particle_count(area / (0.25 * std::numbers::pi * sieve_class.from * sieve_class.to));
  Field<double> radii;
  for (double sum = 0.0;;) {
    const double radius = 0.5 * draw_diameter(sieve_class, random);
    const double disc = std::numbers::pi * radius * radius;
    // The last grain is left out if the sum is nearer to what is wanted without it.
    if (sum + 0.5 * disc > area) return radii;
    radii.push_back(radius);
    sum += disc;
  }
}

}  // namespace ligament
