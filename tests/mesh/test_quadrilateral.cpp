#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/error.hpp"
#include "mesh/quadrilateral.hpp"

using namespace ligament;

namespace {

constexpr QuadrilateralCorners unit_square{Vector{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
constexpr QuadrilateralCorners distorted{Vector{0.1, -0.2}, {1.3, 0.1}, {1.0, 0.9}, {-0.3, 0.7}};

using Matrix = Eigen::Matrix<double, 8, 8, Eigen::RowMajor>;

Matrix stiffness_of(const QuadrilateralCorners& corners, double e, double nu, PlaneState plane, double thickness) {
  const ElementStiffness stiffness = quadrilateral_stiffness(corners, elasticity_matrix(e, nu, plane), thickness);
  return Eigen::Map<const Matrix>(stiffness.data());
}

/// The stiffness of a square in plane stress, integrated by hand.
Matrix stiffness_of_square(double e, double nu, double thickness) {
  const std::array<double, 8> k{0.5 - nu / 6.0,    0.125 + nu / 8.0,  -0.25 - nu / 12.0, -0.125 + 3.0 * nu / 8.0,
                                -0.25 + nu / 12.0, -0.125 - nu / 8.0, nu / 6.0,          0.125 - 3.0 * nu / 8.0};
  constexpr int place[8][8] = {{0, 1, 2, 3, 4, 5, 6, 7}, {1, 0, 7, 6, 5, 4, 3, 2}, {2, 7, 0, 5, 6, 3, 4, 1},
                               {3, 6, 5, 0, 7, 2, 1, 4}, {4, 5, 6, 7, 0, 1, 2, 3}, {5, 4, 3, 2, 1, 0, 7, 6},
                               {6, 3, 4, 1, 2, 7, 0, 5}, {7, 2, 1, 4, 3, 6, 5, 0}};
  Matrix stiffness;
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) stiffness(i, j) = e * thickness / (1.0 - nu * nu) * k[place[i][j]];
  }
  return stiffness;
}

using Column = Eigen::Matrix<double, 8, 1>;

/// The displacements that a linear field a + G x gives to the corners.
Column linear_field(const QuadrilateralCorners& corners, const Vector& a, const Vector& row_x, const Vector& row_y) {
  Column u;
  for (int corner = 0; corner < 4; ++corner) {
    u[2 * corner] = a.x + dot(row_x, corners[corner]);
    u[2 * corner + 1] = a.y + dot(row_y, corners[corner]);
  }
  return u;
}

ElementDisplacement to_array(const Column& u) {
  ElementDisplacement displacement{};
  for (std::size_t i = 0; i < 8; ++i) displacement[i] = u[static_cast<Eigen::Index>(i)];
  return displacement;
}

}  // namespace

TEST_CASE("stiffness of a square in closed form") {
  for (const double nu : {0.0, 0.2, 0.45}) {
    const Matrix difference =
        stiffness_of(unit_square, 3.0, nu, PlaneState::stress, 0.5) - stiffness_of_square(3.0, nu, 0.5);
    CHECK(difference.cwiseAbs().maxCoeff() < 1e-15);
  }
}

TEST_CASE("the stiffness does not depend on the size of an element, but on its thickness") {
  QuadrilateralCorners large = distorted;
  for (Vector& corner : large) corner *= 1000.0;
  const Matrix reference = stiffness_of(distorted, 1.0, 0.3, PlaneState::stress, 1.0);
  CHECK((stiffness_of(large, 1.0, 0.3, PlaneState::stress, 1.0) - reference).norm() < 1e-13);
  CHECK((stiffness_of(distorted, 1.0, 0.3, PlaneState::stress, 0.1) - 0.1 * reference).norm() < 1e-15);
}

TEST_CASE("rigid motion makes no force, nothing else does without energy") {
  const Matrix stiffness = stiffness_of(distorted, 2.0e10, 0.2, PlaneState::stress, 1.0);
  CHECK((stiffness - stiffness.transpose()).cwiseAbs().maxCoeff() < 1e-5);
  const double scale = stiffness.norm();
  CHECK((stiffness * linear_field(distorted, {1.0, 0.0}, {}, {})).norm() < 1e-15 * scale);
  CHECK((stiffness * linear_field(distorted, {0.0, 1.0}, {}, {})).norm() < 1e-15 * scale);
  CHECK((stiffness * linear_field(distorted, {0.0, 0.0}, {0.0, -1.0}, {1.0, 0.0})).norm() < 1e-15 * scale);

  const Eigen::SelfAdjointEigenSolver<Matrix> modes(stiffness);
  CHECK(std::abs(modes.eigenvalues()[2]) < 1e-14 * scale);
  CHECK(modes.eigenvalues()[3] > 1e-2 * scale);
}

TEST_CASE("the stiffness turns with the element") {
  const double angle = 0.7;
  const Eigen::Rotation2Dd rotation(angle);
  QuadrilateralCorners turned = distorted;
  for (Vector& corner : turned) {
    corner = {std::cos(angle) * corner.x - std::sin(angle) * corner.y,
              std::sin(angle) * corner.x + std::cos(angle) * corner.y};
  }
  Matrix turn = Matrix::Zero();
  for (int corner = 0; corner < 4; ++corner) turn.block<2, 2>(2 * corner, 2 * corner) = rotation.toRotationMatrix();
  const Matrix expected = turn * stiffness_of(distorted, 1.0, 0.3, PlaneState::stress, 1.0) * turn.transpose();
  CHECK((stiffness_of(turned, 1.0, 0.3, PlaneState::stress, 1.0) - expected).norm() < 1e-14);
}

TEST_CASE("a linear field stores the energy ½ σ ε of the area") {
  const auto elasticity = elasticity_matrix(2.0, 0.3, PlaneState::stress);
  const Column u = linear_field(distorted, {0.3, -0.1}, {1e-3, 2e-3}, {-5e-4, 3e-3});
  const PlaneTensor strain{1e-3, 3e-3, 1.5e-3};
  const PlaneTensor stress = stress_of(elasticity, strain);
  const double density = 0.5 * (stress[0] * strain[0] + stress[1] * strain[1] + stress[2] * strain[2]);
  const double energy = 0.5 * u.dot(stiffness_of(distorted, 2.0, 0.3, PlaneState::stress, 0.7) * u);
  CHECK(energy == doctest::Approx(density * quadrilateral_area(distorted) * 0.7).epsilon(1e-12));

  const PlaneTensor mean = quadrilateral_mean_strain(distorted, to_array(u));
  for (std::size_t i = 0; i < 3; ++i) CHECK(mean[i] == doctest::Approx(strain[i]).epsilon(1e-12));
}

TEST_CASE("plane strain is plane stress with E/(1-ν²) and ν/(1-ν)") {
  const double e = 3.0;
  const double nu = 0.3;
  const auto strain = elasticity_matrix(e, nu, PlaneState::strain);
  const auto stress = elasticity_matrix(e / (1.0 - nu * nu), nu / (1.0 - nu), PlaneState::stress);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) CHECK(strain[i][j] == doctest::Approx(stress[i][j]).epsilon(1e-14));
  }
  CHECK(strain[2][2] == doctest::Approx(e / (2.0 * (1.0 + nu))));
}

TEST_CASE("uniaxial stress stretches by σ/E and narrows by ν σ/E") {
  const double e = 3.0;
  const double nu = 0.3;
  const PlaneTensor stress = stress_of(elasticity_matrix(e, nu, PlaneState::stress), {1.0 / e, -nu / e, 0.0});
  CHECK(stress[0] == doctest::Approx(1.0).epsilon(1e-15));
  CHECK(std::abs(stress[1]) < 1e-15);
  CHECK(stress[2] == 0.0);
}

TEST_CASE("areas") {
  // Half the cross product of the diagonals.
  const double area = 0.5 * cross(distorted[2] - distorted[0], distorted[3] - distorted[1]);
  CHECK(quadrilateral_area(distorted) == doctest::Approx(area).epsilon(1e-14));
  const auto areas = quadrilateral_lumped_areas(distorted);
  CHECK(areas[0] + areas[1] + areas[2] + areas[3] == doctest::Approx(area).epsilon(1e-14));
  for (const double share : quadrilateral_lumped_areas(unit_square))
    CHECK(share == doctest::Approx(0.25).epsilon(1e-14));

  // The lumped areas balance at the centroid, here of a trapezoid 2 and 1 wide and 1 high, 4/9 up.
  const auto trapezoid = quadrilateral_lumped_areas({Vector{0.0, 0.0}, {2.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}});
  CHECK(trapezoid[2] + trapezoid[3] == doctest::Approx(1.5 * 4.0 / 9.0).epsilon(1e-14));
}

TEST_CASE("elements that are not convex and counter-clockwise are refused") {
  const auto elasticity = elasticity_matrix(1.0, 0.0, PlaneState::stress);
  const QuadrilateralCorners clockwise{Vector{0.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, {1.0, 0.0}};
  const QuadrilateralCorners arrow{Vector{0.0, 0.0}, {1.0, 0.0}, {0.1, 0.1}, {0.0, 1.0}};
  const QuadrilateralCorners line{Vector{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {0.0, 0.0}};
  for (const auto& corners : {clockwise, arrow, line}) {
    CHECK_THROWS_AS(quadrilateral_stiffness(corners, elasticity, 1.0), InputError);
  }
}
