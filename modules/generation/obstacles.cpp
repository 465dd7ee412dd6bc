#include "generation/obstacles.hpp"

#include <algorithm>

namespace ligament {

Obstacles::Obstacles(const Field<Vector>& centres, const Field<double>& radii, const Vector& size, double usual_circle)
    : n_discs_(centres.size()),
      largest_disc_(radii.empty() ? 0.0 : *std::max_element(radii.begin(), radii.end())),
      grid_(centres, largest_disc_ + 2.0 * usual_circle) {
  for (std::size_t i = 0; i < n_discs_; ++i) conditions_.emplace_back(Circle{centres[i], radii[i]});
  for (int axis = 0; axis < dimension; ++axis) {
    Vector normal;
    set_component(normal, axis, 1.0);
    conditions_.emplace_back(touches_wall(normal, 0.0));
    conditions_.emplace_back(touches_wall(-normal, -component(size, axis)));
  }
}

double Obstacles::gap(std::size_t i, const Circle& circle) const {
  if (const Circle* other = disc(i)) return norm(circle.centre - other->centre) - other->radius - circle.radius;
  const auto& wall = std::get<LinearCondition>(conditions_[i]);
  return dot(wall.normal, circle.centre) - wall.value - circle.radius;
}

std::vector<std::size_t> Obstacles::within(const Circle& circle, double reach) const {
  std::vector<std::size_t> found;
  const Vector range = uniform_vector(circle.radius + largest_disc_ + reach);
  grid_.visit_box(circle.centre - range, circle.centre + range, [&](Index i) {
    if (gap(static_cast<std::size_t>(i), circle) < reach) found.push_back(static_cast<std::size_t>(i));
  });
  for (std::size_t wall = n_discs_; wall < conditions_.size(); ++wall) {
    if (gap(wall, circle) < reach) found.push_back(wall);
  }
  return found;
}

}  // namespace ligament
