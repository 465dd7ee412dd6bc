#include "integrator/body_loops.hpp"

#include <algorithm>
#include <cmath>

namespace ligament {
namespace {

/// Component by component: compilers do not take apart vectors that are copied whole.
Vector at(const Vector* vectors, std::size_t i) {
  Vector vector;
  for (int axis = 0; axis < dimension; ++axis) set_component(vector, axis, component(vectors[i], axis));
  return vector;
}
void put(Vector* vectors, std::size_t i, const Vector& value) {
  for (int axis = 0; axis < dimension; ++axis) set_component(vectors[i], axis, component(value, axis));
}

/// The numbers of a law of motion as the loops use them.
struct MotionFactors {
  explicit MotionFactors(const MotionLaw& law)
      : viscous(law.damping.viscous),
        local(law.damping.local),
        time(law.acceleration_time),
        factor(time / (1.0 + 0.5 * viscous * time)),
        time_step_before(law.time_step_before),
        half_step(0.5 * law.time_step) {}
  double viscous;
  double local;
  double time;
  double factor;
  double time_step_before;
  double half_step;
};

/// std::clamp between minus and plus a limit, by values.
double kept_within(double value, double limit) { return std::max(-limit, std::min(limit, value)); }

/// One freedom. Both dampings act on the mean of v(n-½) and v(n+½), as their work does: they never give energy, and the
/// step stays stable up to 2/ω. Local damping at most stops that mean.
double velocity_after(double before, double acceleration, double free, const MotionFactors& law) {
  const double undragged = before + law.factor * (free * (acceleration - law.viscous * before));
  const double drag = law.factor * law.local * (free * std::abs(acceleration));
  return undragged - kept_within(before + undragged, drag);
}

[[gnu::target_clones("avx512f", "avx2", "default")]] void accelerate_translations(
    std::size_t count, const MotionFactors& law, const Vector* __restrict force, const double* __restrict mass,
    const Vector* __restrict free, const Vector* __restrict velocity_before, Vector* __restrict velocity,
    double* __restrict work_behind, double* __restrict work_ahead) {
  for (std::size_t i = 0; i < count; ++i) {
    const Vector before = at(velocity_before, i);
    const Vector resultant = at(force, i);
    const Vector is_free = at(free, i);
    const Vector acceleration = resultant / mass[i];
    Vector after;
    for (int axis = 0; axis < dimension; ++axis) {
      set_component(
          after, axis,
          velocity_after(component(before, axis), component(acceleration, axis), component(is_free, axis), law));
    }
    put(velocity, i, after);
    const Vector damping = componentwise(is_free, (mass[i] / law.time) * (after - before) - resultant);
    work_behind[i] = 0.5 * dot(damping, law.time_step_before * before);
    work_ahead[i] = law.half_step * dot(damping, after);
  }
}

[[gnu::target_clones("avx512f", "avx2", "default")]] void accelerate_rotations(
    std::size_t count, const MotionFactors& law, const double* __restrict moment, const double* __restrict inertia,
    const double* __restrict free, const double* __restrict spin_before, double* __restrict spin,
    double* __restrict work_behind, double* __restrict work_ahead) {
  for (std::size_t i = 0; i < count; ++i) {
    const Spin before = spin_before[i];
    const Spin after = velocity_after(before, moment[i] / inertia[i], free[i], law);
    spin[i] = after;
    const Moment damping = free[i] * ((inertia[i] / law.time) * (after - before) - moment[i]);
    work_behind[i] += 0.5 * damping * (law.time_step_before * before);
    work_ahead[i] += law.half_step * damping * after;
  }
}

[[gnu::target_clones("avx512f", "avx2", "default")]] void add_translation_terms(
    std::size_t count, const Vector* __restrict force, const double* __restrict mass, const Vector* __restrict free,
    const Vector* __restrict increment, Vector* __restrict force_before, double* __restrict stiffness,
    double* __restrict inertia) {
  for (std::size_t i = 0; i < count; ++i) {
    const Vector motion = componentwise(at(free, i), at(increment, i));
    const Vector now = at(force, i);
    stiffness[i] = -dot(motion, now - at(force_before, i));
    inertia[i] = mass[i] * dot(motion, motion);
    put(force_before, i, now);
  }
}

[[gnu::target_clones("avx512f", "avx2", "default")]] void add_rotation_terms(
    std::size_t count, const double* __restrict moment, const double* __restrict mass, const double* __restrict free,
    const double* __restrict increment, double* __restrict moment_before, double* __restrict stiffness,
    double* __restrict inertia) {
  for (std::size_t i = 0; i < count; ++i) {
    const Rotation motion = free[i] * increment[i];
    stiffness[i] -= motion * (moment[i] - moment_before[i]);
    inertia[i] += mass[i] * motion * motion;
    moment_before[i] = moment[i];
  }
}

/// Sum by lanes, then over lanes.
[[gnu::target_clones("avx512f", "avx2", "default")]] double lane_sum(const double* __restrict terms,
                                                                     std::size_t count) {
  constexpr std::size_t n_lanes = BlockTerms::n_lanes;
  std::array<double, n_lanes> lanes{};
  const std::size_t n_whole = count - count % n_lanes;
  for (std::size_t i = 0; i < n_whole; i += n_lanes) {
    for (std::size_t lane = 0; lane < n_lanes; ++lane) lanes[lane] += terms[i + lane];
  }
  for (std::size_t i = n_whole; i < count; ++i) lanes[i - n_whole] += terms[i];
  double sum = 0.0;
  for (const double lane : lanes) sum += lane;
  return sum;
}

}  // namespace

TwoSums BlockTerms::sum(std::size_t count) const {
  TwoSums sum;
  sum.first = lane_sum(first.data(), count);
  sum.second = lane_sum(second.data(), count);
  return sum;
}

void accelerate(TranslationState& bodies, const Field<Vector>& free, const MotionLaw& law, const BodyRows& rows,
                BlockTerms& work) {
  const std::size_t begin = rows.begin;
  accelerate_translations(rows.size(), MotionFactors(law), bodies.force.data() + begin, bodies.mass.data() + begin,
                          free.data() + begin, bodies.velocity_before.data() + begin, bodies.velocity.data() + begin,
                          work.first.data(), work.second.data());
}

void accelerate(RotationState& bodies, const Field<double>& free, const MotionLaw& law, const BodyRows& rows,
                BlockTerms& work) {
  const std::size_t begin = rows.begin;
  accelerate_rotations(rows.size(), MotionFactors(law), bodies.moment.data() + begin, bodies.inertia.data() + begin,
                       free.data() + begin, bodies.spin_before.data() + begin, bodies.spin.data() + begin,
                       work.first.data(), work.second.data());
}

void add_rayleigh_terms(const TranslationState& bodies, const Field<Vector>& free, Field<Vector>& force_before,
                        const BodyRows& rows, BlockTerms& terms) {
  const std::size_t begin = rows.begin;
  add_translation_terms(rows.size(), bodies.force.data() + begin, bodies.mass.data() + begin, free.data() + begin,
                        bodies.increment.data() + begin, force_before.data() + begin, terms.first.data(),
                        terms.second.data());
}

void add_rayleigh_terms(const RotationState& bodies, const Field<double>& free, Field<Moment>& moment_before,
                        const BodyRows& rows, BlockTerms& terms) {
  const std::size_t begin = rows.begin;
  add_rotation_terms(rows.size(), bodies.moment.data() + begin, bodies.inertia.data() + begin, free.data() + begin,
                     bodies.increment.data() + begin, moment_before.data() + begin, terms.first.data(),
                     terms.second.data());
}

}  // namespace ligament
