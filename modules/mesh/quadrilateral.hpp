#pragma once

#include <array>

#include "core/model.hpp"

/// The 4-node isoparametric quadrilateral, small strain, 2×2 Gauss points.
namespace ligament {

using QuadrilateralCorners = std::array<Vector, 4>;  ///< counter-clockwise (m)
using ElementDisplacement = std::array<double, 8>;   ///< node 0: x, y; node 1: x, y; … (m)

/// Components xx, yy, xy; the shear strain is the engineering one.
using PlaneTensor = std::array<double, 3>;

/// σ = D ε of an isotropic material in plane stress or plane strain, row by row (Pa).
std::array<PlaneTensor, 3> elasticity_matrix(double young_modulus, double poisson_ratio, PlaneState plane);

/// K = ∫ Bᵀ D B t dA (N/m). Throws InputError if the corners are not convex and counter-clockwise.
ElementStiffness quadrilateral_stiffness(const QuadrilateralCorners& corners,
                                         const std::array<PlaneTensor, 3>& elasticity, double thickness);

/// ∫ dA (m2).
double quadrilateral_area(const QuadrilateralCorners& corners);

/// Row sums of the consistent mass matrix for unit ρ t: ∫ N_i dA per node (m2).
std::array<double, 4> quadrilateral_lumped_areas(const QuadrilateralCorners& corners);

/// Mean strain over the Gauss points.
PlaneTensor quadrilateral_mean_strain(const QuadrilateralCorners& corners, const ElementDisplacement& displacement);

/// σ = D ε (Pa).
PlaneTensor stress_of(const std::array<PlaneTensor, 3>& elasticity, const PlaneTensor& strain);

}  // namespace ligament
