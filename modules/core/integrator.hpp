#pragma once

#include "core/force_provider.hpp"

namespace ligament {

/// How far bodies have gone in a step, at most; not a number if one of their numbers is none.
struct StepTravel {
  double particles = 0.0;  ///< (m)
  double turn = 0.0;       ///< of particles (rad)
  double nodes = 0.0;      ///< of elements, walls and beams (m)
};

/// The law of motion, Eqs (1)-(2).
class Integrator : public EnergySource {
 public:
  /// Its parameters, read from the table [solver].
  virtual void declare(class Parameters& parameters) = 0;

  /// Whether it makes masses of its own from the stiffness of the structure.
  [[nodiscard]] virtual bool needs_stiffness() const { return false; }
  /// Called once at set-up, after bodies have their masses, if it does.
  virtual void use_stiffness(const Model& /*model*/, const State& /*state*/, const StiffnessSum& /*stiffness*/) {}

  /// x(n) = x(n-1) + v(n-½) Δt.
  virtual StepTravel update_positions(const Model& model, State& state) const = 0;

  /// v(n+½) from the forces of time n, for every freedom that is not prescribed.
  virtual void update_velocities(const Model& model, State& state) = 0;
};

/// Damping of a step: viscous c (1/s), force -c m v; local α, force -α |F| sign(v).
struct DampingCoefficients {
  double viscous = 0.0;
  double local = 0.0;
};

/// Chooses the damping of each step.
class Damping {
 public:
  virtual ~Damping() = default;
  virtual void declare(class Parameters& parameters) = 0;
  virtual DampingCoefficients coefficients(const Model& model, State& state) = 0;
};

/// Prescribes motion where the integrator left it free: v(n+½) of the freedoms it owns.
class Constraint : public EnergySource {
 public:
  virtual void apply(const Model& model, State& state) = 0;
};

}  // namespace ligament
