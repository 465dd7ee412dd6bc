#include "mesh/quadrilateral.hpp"

#include <cmath>

#include "core/error.hpp"

namespace ligament {
namespace {

/// Shape functions at one Gauss point, weight 1.
struct GaussPoint {
  std::array<double, 4> shape;
  std::array<Vector, 4> gradient;  ///< ∂N/∂x (1/m)
  double area;                     ///< determinant of the map from the parent square (m2)
};

GaussPoint gauss_point(const QuadrilateralCorners& corners, double xi, double eta) {
  constexpr std::array<double, 4> sign_xi{-1.0, 1.0, 1.0, -1.0};
  constexpr std::array<double, 4> sign_eta{-1.0, -1.0, 1.0, 1.0};
  GaussPoint point{};
  std::array<double, 4> by_xi{};
  std::array<double, 4> by_eta{};
  Vector x_xi;
  Vector x_eta;
  for (std::size_t a = 0; a < 4; ++a) {
    point.shape[a] = 0.25 * (1.0 + sign_xi[a] * xi) * (1.0 + sign_eta[a] * eta);
    by_xi[a] = 0.25 * sign_xi[a] * (1.0 + sign_eta[a] * eta);
    by_eta[a] = 0.25 * sign_eta[a] * (1.0 + sign_xi[a] * xi);
    x_xi += by_xi[a] * corners[a];
    x_eta += by_eta[a] * corners[a];
  }
  point.area = cross(x_xi, x_eta);
  if (!(point.area > 0.0)) throw InputError("an element is not convex with its nodes counter-clockwise");
  for (std::size_t a = 0; a < 4; ++a) {
    point.gradient[a] = {(x_eta.y * by_xi[a] - x_xi.y * by_eta[a]) / point.area,
                         (x_xi.x * by_eta[a] - x_eta.x * by_xi[a]) / point.area};
  }
  return point;
}

std::array<GaussPoint, 4> gauss_points(const QuadrilateralCorners& corners) {
  const double g = 1.0 / std::sqrt(3.0);
  return {gauss_point(corners, -g, -g), gauss_point(corners, g, -g), gauss_point(corners, g, g),
          gauss_point(corners, -g, g)};
}

/// Column of B for one freedom: the strain that its unit displacement makes.
PlaneTensor strain_of_freedom(const GaussPoint& point, std::size_t freedom) {
  const Vector& gradient = point.gradient[freedom / 2];
  return freedom % 2 == 0 ? PlaneTensor{gradient.x, 0.0, gradient.y} : PlaneTensor{0.0, gradient.y, gradient.x};
}

}  // namespace

std::array<PlaneTensor, 3> elasticity_matrix(double young_modulus, double poisson_ratio, PlaneState plane) {
  const double nu = poisson_ratio;
  const double shear = young_modulus / (2.0 * (1.0 + nu));
  if (plane == PlaneState::stress) {
    const double d = young_modulus / (1.0 - nu * nu);
    return {PlaneTensor{d, nu * d, 0.0}, PlaneTensor{nu * d, d, 0.0}, PlaneTensor{0.0, 0.0, shear}};
  }
  const double d = young_modulus / ((1.0 + nu) * (1.0 - 2.0 * nu));
  return {PlaneTensor{(1.0 - nu) * d, nu * d, 0.0}, PlaneTensor{nu * d, (1.0 - nu) * d, 0.0},
          PlaneTensor{0.0, 0.0, shear}};
}

PlaneTensor stress_of(const std::array<PlaneTensor, 3>& elasticity, const PlaneTensor& strain) {
  PlaneTensor stress{};
  for (std::size_t i = 0; i < 3; ++i) {
    stress[i] = elasticity[i][0] * strain[0] + elasticity[i][1] * strain[1] + elasticity[i][2] * strain[2];
  }
  return stress;
}

ElementStiffness quadrilateral_stiffness(const QuadrilateralCorners& corners,
                                         const std::array<PlaneTensor, 3>& elasticity, double thickness) {
  ElementStiffness stiffness{};
  for (const GaussPoint& point : gauss_points(corners)) {
    for (std::size_t j = 0; j < 8; ++j) {
      const PlaneTensor stress = stress_of(elasticity, strain_of_freedom(point, j));
      for (std::size_t i = 0; i < 8; ++i) {
        const PlaneTensor strain = strain_of_freedom(point, i);
        stiffness[8 * i + j] +=
            (strain[0] * stress[0] + strain[1] * stress[1] + strain[2] * stress[2]) * point.area * thickness;
      }
    }
  }
  return stiffness;
}

double quadrilateral_area(const QuadrilateralCorners& corners) {
  double area = 0.0;
  for (const GaussPoint& point : gauss_points(corners)) area += point.area;
  return area;
}

std::array<double, 4> quadrilateral_lumped_areas(const QuadrilateralCorners& corners) {
  std::array<double, 4> areas{};
  for (const GaussPoint& point : gauss_points(corners)) {
    for (std::size_t a = 0; a < 4; ++a) areas[a] += point.shape[a] * point.area;
  }
  return areas;
}

PlaneTensor quadrilateral_mean_strain(const QuadrilateralCorners& corners, const ElementDisplacement& displacement) {
  PlaneTensor mean{};
  double area = 0.0;
  for (const GaussPoint& point : gauss_points(corners)) {
    area += point.area;
    for (std::size_t freedom = 0; freedom < 8; ++freedom) {
      const PlaneTensor strain = strain_of_freedom(point, freedom);
      for (std::size_t i = 0; i < 3; ++i) mean[i] += strain[i] * displacement[freedom] * point.area;
    }
  }
  for (double& strain : mean) strain /= area;
  return mean;
}

}  // namespace ligament
