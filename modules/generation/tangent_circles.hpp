#pragma once

#include <array>
#include <variant>
#include <vector>

#include "core/vector.hpp"

namespace ligament {

/// A circle or disc (m).
struct Circle {
  Vector centre;
  double radius = 0.0;
};

/// What a circle of centre c and radius ρ must obey: normal · c + of_radius ρ = value (m).
struct LinearCondition {
  Vector normal;
  double of_radius = 0.0;
  double value = 0.0;
};

/// A circle touches a disc from outside, or obeys a linear condition.
using CircleCondition = std::variant<Circle, LinearCondition>;

/// A circle touches a wall, from the side that its unit normal points to: normal · x = offset on the wall.
inline LinearCondition touches_wall(const Vector& normal, double offset) { return {normal, -1.0, offset}; }
inline LinearCondition has_radius(double radius) { return {{}, 1.0, radius}; }

/// The circles of positive radius that obey three conditions (the problem of Apollonius): two at most.
std::vector<Circle> tangent_circles(const std::array<CircleCondition, 3>& conditions);

}  // namespace ligament
