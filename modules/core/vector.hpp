#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

/// The only header that knows how many dimensions there are.
namespace ligament {

inline constexpr int dimension = 2;

/// A point, displacement, velocity or force.
struct Vector {
  double x = 0.0;
  double y = 0.0;

  constexpr Vector& operator+=(const Vector& b) { return *this = {x + b.x, y + b.y}; }
  constexpr Vector& operator-=(const Vector& b) { return *this = {x - b.x, y - b.y}; }
  constexpr Vector& operator*=(double s) { return *this = {x * s, y * s}; }
  friend constexpr bool operator==(const Vector&, const Vector&) = default;
};

/// Rotation and everything that goes with it (spin, moment) has one component in the plane.
using Rotation = double;
using Spin = double;
using Moment = double;

/// Slip and shear force on a contact plane: one component along tangent(normal) in the plane. It turns with the plane,
/// so that the correction of Eq. (21) is exact and free.
using ShearVector = double;

/// One value per body or contact, contiguous.
template <class T>
using Field = std::vector<T>;

/// Position of a row in a table.
using Index = std::int32_t;

constexpr Vector operator+(Vector a, const Vector& b) { return a += b; }
constexpr Vector operator-(Vector a, const Vector& b) { return a -= b; }
constexpr Vector operator-(const Vector& a) { return {-a.x, -a.y}; }
constexpr Vector operator*(double s, Vector a) { return a *= s; }
constexpr Vector operator*(Vector a, double s) { return a *= s; }
constexpr Vector operator/(const Vector& a, double s) { return {a.x / s, a.y / s}; }

constexpr double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
inline double norm(const Vector& a) { return std::sqrt(dot(a, a)); }

/// a × b: a moment, or the sine of an angle times two lengths.
constexpr Moment cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }

/// ω × r: the velocity of a point at r of a body that spins with ω.
constexpr Vector cross(Spin w, const Vector& r) { return {-w * r.y, w * r.x}; }

/// The tangent (-n2, n1) of a contact plane with unit normal n.
constexpr Vector tangent(const Vector& n) { return {-n.y, n.x}; }

/// Product and absolute value component by component.
constexpr Vector componentwise(const Vector& a, const Vector& b) { return {a.x * b.x, a.y * b.y}; }
inline Vector absolute(const Vector& a) { return {std::abs(a.x), std::abs(a.y)}; }

/// Every component of a, kept within plus or minus that of the limit.
constexpr Vector clamped(const Vector& a, const Vector& limit) {
  return {std::clamp(a.x, -limit.x, limit.x), std::clamp(a.y, -limit.y, limit.y)};
}

/// All components equal to s.
constexpr Vector uniform_vector(double s) { return {s, s}; }

inline double largest_component(const Vector& a) { return std::max(std::abs(a.x), std::abs(a.y)); }
inline bool is_finite(const Vector& a) { return std::isfinite(a.x) && std::isfinite(a.y); }

/// One component by its number (0 = x, 1 = y).
constexpr double component(const Vector& a, int axis) { return axis == 0 ? a.x : a.y; }
constexpr void set_component(Vector& a, int axis, double value) { (axis == 0 ? a.x : a.y) = value; }

constexpr Vector to_vector(const std::array<double, dimension>& a) { return {a[0], a[1]}; }
constexpr std::array<double, 3> to_space(const Vector& a) { return {a.x, a.y, 0.0}; }

}  // namespace ligament
