#include "generation/disc_growth.hpp"

#include "generation/disc_insertion.hpp"
#include "generation/soft_discs.hpp"
#include "generation/spatial_order.hpp"

namespace ligament {
namespace {

Field<double> scaled(const Field<double>& radii, double factor) {
  Field<double> result = radii;
  for (double& radius : result) radius *= factor;
  return result;
}

void relax_to_rest(SoftDiscs& discs, const Field<double>& radii) {
  constexpr double tolerance = 1e-4;
  constexpr int most_steps = 20000;
  discs.relax(radii, tolerance, most_steps);
}

/// Lets the discs grow from a part of their size and come to rest.
void grow(Packing& packing, double part, const Vector& size) {
  constexpr int n_growths = 12;
  constexpr double coarse_tolerance = 0.1;
  constexpr int coarse_steps = 50;
  SoftDiscs discs(std::move(packing.position), size);
  for (int growth = 1; growth < n_growths; ++growth) {
    const double grown = part + (1.0 - part) * growth / n_growths;
    discs.relax(scaled(packing.radius, grown), coarse_tolerance, coarse_steps);
  }
  relax_to_rest(discs, packing.radius);
  packing.position = discs.centres();
}

}  // namespace

Packing grow_discs(const Field<double>& radii, const Vector& size, RandomNumbers& random) {
  constexpr double inserted_part = 0.4;
  Packing packing{insert_discs(scaled(radii, inserted_part), size, random), radii, {}};
  sort_spatially(packing);
  grow(packing, inserted_part, size);
  return packing;
}

void settle(Packing& packing, const Vector& size) {
  SoftDiscs discs(std::move(packing.position), size);
  relax_to_rest(discs, packing.radius);
  packing.position = discs.centres();
}

}  // namespace ligament
