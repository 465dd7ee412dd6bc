#pragma once

#include <optional>

#include "core/vector.hpp"
#include "generation/near_discs.hpp"

namespace ligament {

/// Discs in the box [0, size] that push each other, and are pushed by the walls, with forces equal to their overlap (a
/// spring of stiffness 1; a wall pushes like the disc's mirror image). They move down the gradient of that energy until
/// every disc is pushed equally from all sides.
class SoftDiscs {
 public:
  SoftDiscs(Field<Vector> centres, const Vector& size);

  /// Gives the discs these radii (m), and moves them until no resultant exceeds `tolerance` times the force of an
  /// overlap by the mean radius, or for `most_steps` steps. Returns the number of steps.
  ///
  /// Fast inertial relaxation: Bitzek et al., Phys. Rev. Lett. 97 (2006) 170201, with their parameters.
  int relax(const Field<double>& radii, double tolerance, int most_steps);

  [[nodiscard]] const Field<Vector>& centres() const { return centres_; }

 private:
  /// What decides the next step, summed over all discs.
  struct Motion {
    double power = 0.0;     ///< Σ F·v
    double force = 0.0;     ///< Σ F·F
    double velocity = 0.0;  ///< Σ v·v
    double largest = 0.0;   ///< largest component of a force

    Motion& operator+=(const Motion& other);
  };

  void list_neighbours();
  void find_forces();
  [[nodiscard]] Motion motion() const;
  void move(double time_step, double keep, double steer);

  Field<Vector> centres_;
  Field<Vector> velocities_;
  Field<Vector> forces_;
  Field<double> radii_;
  Vector size_;
  std::optional<NearDiscs> near_;
  Field<Vector> centres_when_listed_;
};

}  // namespace ligament
