#pragma once

#include <array>

#include "core/block_sum.hpp"
#include "core/integrator.hpp"

/// The loops over bodies that every step of an integrator goes through, for the rows of one block. Compilers make
/// vector instructions of them, which are chosen when the program starts; every operation rounds as it does alone,
/// whatever the width.
namespace ligament {

/// Rows [begin, end) of a table of bodies, at most block_size.
struct BodyRows {
  std::size_t begin = 0;
  std::size_t end = 0;

  [[nodiscard]] std::size_t size() const { return end - begin; }
};

/// Two sums over bodies.
struct TwoSums {
  double first = 0.0;
  double second = 0.0;
  TwoSums& operator+=(const TwoSums& b) {
    first += b.first;
    second += b.second;
    return *this;
  }
};

/// What each body of a block adds to two sums.
struct BlockTerms {
  static constexpr std::size_t n_lanes = 8;
  std::array<double, block_size> first;
  std::array<double, block_size> second;

  /// By lanes, then over lanes: as many at a time as processors can take, in an order that is the same for all.
  [[nodiscard]] TwoSums sum(std::size_t count) const;
};

/// The law of motion of a step, Eqs (1)-(2), damped.
struct MotionLaw {
  DampingCoefficients damping;
  double acceleration_time = 1.0;  ///< from n-½ to n+½ (s)
  double time_step_before = 1.0;   ///< from n-1 to n (s)
  double time_step = 1.0;          ///< from n to n+1 (s)
};

/// v(n+½) from v(n-½), `velocity_before`, and the forces of time n, where bodies are free. Of translations the terms
/// are, to those of rotations are added, the two halves of the work of damping, see PathSum: what the motion shows
/// beyond the force.
void accelerate(TranslationState& bodies, const Field<Vector>& free, const MotionLaw& law, const BodyRows& rows,
                BlockTerms& work);
void accelerate(RotationState& bodies, const Field<double>& free, const MotionLaw& law, const BodyRows& rows,
                BlockTerms& work);

/// Likewise -x·Δf and m x·x, x being the motion of the last step where bodies are free and Δf the change of their
/// forces from those before, which are then those of now.
void add_rayleigh_terms(const TranslationState& bodies, const Field<Vector>& free, Field<Vector>& force_before,
                        const BodyRows& rows, BlockTerms& terms);
void add_rayleigh_terms(const RotationState& bodies, const Field<double>& free, Field<Moment>& moment_before,
                        const BodyRows& rows, BlockTerms& terms);

}  // namespace ligament
