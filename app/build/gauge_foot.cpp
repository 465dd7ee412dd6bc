#include "build/gauge_foot.hpp"

namespace ligament {
namespace {

std::vector<Index> particles_under_foot(const Model& model, const Vector& place, const Vector& other, double foot) {
  std::vector<Index> rows;
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    const double distance = norm(model.particles.position[i] - place);
    if (distance > 0.5 * foot || distance > norm(model.particles.position[i] - other)) continue;
    rows.push_back(static_cast<Index>(i));
  }
  return rows;
}

/// In units of π, which falls out.
double area_of(const Model& model, Index row) { return model.particles.radius[row] * model.particles.radius[row]; }

}  // namespace

std::vector<WatchedBody> bodies_under_foot(const Model& model, const Vector& place, const Vector& other, double foot,
                                           int axis) {
  const std::vector<Index> rows = particles_under_foot(model, place, other, foot);
  double area = 0.0;
  Vector centre{};
  for (const Index row : rows) {
    area += area_of(model, row);
    centre += area_of(model, row) * model.particles.position[row];
  }
  centre = centre / area;
  double polar_moment = 0.0;
  for (const Index row : rows) {
    const Vector arm = model.particles.position[row] - centre;
    polar_moment += area_of(model, row) * dot(arm, arm);
  }
  // What the place moves by along the axis when the body turns by 1.
  const double lever = component(cross(Spin{1.0}, place - centre), axis);
  const double turn = polar_moment > 0.0 ? lever / polar_moment : 0.0;
  std::vector<WatchedBody> bodies;
  for (const Index row : rows) {
    const Vector weight = turn * area_of(model, row) * cross(Spin{1.0}, model.particles.position[row] - centre);
    const double share = area_of(model, row) / area;
    bodies.push_back({BodyTable::particle, row, 0, weight.x + (axis == 0 ? share : 0.0)});
    bodies.push_back({BodyTable::particle, row, 1, weight.y + (axis == 1 ? share : 0.0)});
  }
  return bodies;
}

}  // namespace ligament
