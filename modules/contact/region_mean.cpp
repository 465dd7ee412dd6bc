#include "contact/region_mean.hpp"

#include <algorithm>

#include "core/block_sum.hpp"

namespace ligament {
namespace {

bool is_inside(const Rectangle& region, const Vector& place) {
  return place.x >= region.from.x && place.x <= region.to.x && place.y >= region.from.y && place.y <= region.to.y;
}

/// Force on the second particle of a contact, times the branch.
SymmetricTensor contribution(const Model& model, const State& state, const Rectangle& region, std::size_t row) {
  const ContactTable& contacts = state.particle_contacts;
  const Index a = contacts.first[row];
  const Index b = contacts.second[row];
  const auto place = [&](Index i) { return model.particles.position[i] + state.particles.translation.displacement[i]; };
  const Vector branch = place(b) - place(a);
  const Vector normal = branch / norm(branch);
  const Vector force = contacts.normal_force[row] * normal + contacts.shear_force[row] * tangent(normal);
  return share_inside(region, place(a), place(b)) * symmetric_product(force, branch);
}

/// Sums over the particles inside, from which the fit follows.
struct FitSums {
  double count = 0.0;
  Vector place;
  Vector displacement;
  SymmetricTensor second_moment;  ///< Σ x ⊗ x
  Vector with_x;                  ///< Σ u x
  Vector with_y;                  ///< Σ u y

  FitSums& operator+=(const FitSums& b) {
    count += b.count;
    place += b.place;
    displacement += b.displacement;
    second_moment += b.second_moment;
    with_x += b.with_x;
    with_y += b.with_y;
    return *this;
  }
};

FitSums fit_sums(const Model& model, const State& state, const Rectangle& region) {
  // From the middle of the region, so that the sums lose no digits.
  const Vector middle = 0.5 * (region.from + region.to);
  return block_sum(model.particles.size(), [&](std::size_t i) {
    const Vector& centre = model.particles.position[i];
    if (!is_inside(region, centre)) return FitSums{};
    const Vector x = centre - middle;
    const Vector& u = state.particles.translation.displacement[i];
    return FitSums{1.0, x, u, symmetric_product(x, x), x.x * u, x.y * u};
  });
}

}  // namespace

SymmetricTensor mean_stress(const Model& model, const State& state, const Rectangle& region) {
  const SymmetricTensor sum = block_sum(state.particle_contacts.size(),
                                        [&](std::size_t row) { return contribution(model, state, region, row); });
  const Vector size = region.size();
  return (-1.0 / (size.x * size.y * model.thickness)) * sum;
}

SymmetricTensor mean_strain(const Model& model, const State& state, const Rectangle& region) {
  const FitSums sums = fit_sums(model, state, region);
  const Vector x = sums.place / sums.count;
  const Vector u = sums.displacement / sums.count;
  const SymmetricTensor moment{sums.second_moment.xx - sums.count * x.x * x.x,
                               sums.second_moment.yy - sums.count * x.y * x.y,
                               sums.second_moment.xy - sums.count * x.x * x.y};
  const Vector with_x = sums.with_x - (sums.count * x.x) * u;
  const Vector with_y = sums.with_y - (sums.count * x.y) * u;
  const double determinant = moment.xx * moment.yy - moment.xy * moment.xy;
  const Vector along_x = (moment.yy * with_x - moment.xy * with_y) / determinant;  // ∂u/∂x
  const Vector along_y = (moment.xx * with_y - moment.xy * with_x) / determinant;  // ∂u/∂y
  return {along_x.x, along_y.y, 0.5 * (along_x.y + along_y.x)};
}

std::size_t count_particles(const Model& model, const Rectangle& region) {
  return static_cast<std::size_t>(std::count_if(model.particles.position.begin(), model.particles.position.end(),
                                                [&](const Vector& centre) { return is_inside(region, centre); }));
}

}  // namespace ligament
