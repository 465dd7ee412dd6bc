#pragma once

#include "simulation.hpp"

namespace ligament {

/// Two audits of every step that point at one module where the ledger as a whole only says that something is wrong.
/// *Motion*: the change of kinetic energy is the work of all forces on the bodies (integrator, damping, constraints).
/// *Transfer*: the work of contacts and elements on the bodies is what they have stored less, or spent (contacts, laws,
/// elements). Errors are over the ledger's running maximum.
class StepAudit {
 public:
  /// Starts from the present state.
  explicit StepAudit(const Simulation& simulation);

  /// Takes in one step. Throws DivergenceError, naming the body, if a number of the state is not finite.
  void observe(const Simulation& simulation);

  [[nodiscard]] double motion_error() const { return motion_.error(); }
  [[nodiscard]] double transfer_error() const { return transfer_.error(); }

 private:
  /// A sum of steps that should stay zero.
  struct Drift {
    double sum = 0.0;
    double largest = 0.0;
    double scale = 0.0;
    void add(double defect, double size);
    [[nodiscard]] double error() const { return scale > 0.0 ? largest / scale : 0.0; }
  };
  /// Energies on either side of the bodies at one time (J).
  struct Sides {
    double kinetic = 0.0;
    double of_motion = 0.0;  ///< work of damping, prescribed motions and changes of step
    double of_loads = 0.0;   ///< work of loads and gravity
    double taken = 0.0;      ///< stored or spent by contacts and elements
  };
  static Sides sides_of(const Simulation& simulation);
  double work_on_bodies(const State& state) const;
  void remember(const State& state);

  Sides before_;
  Field<Vector> particle_force_;
  Field<Moment> particle_moment_;
  Field<Vector> node_force_;
  Field<Vector> beam_force_;
  Field<Moment> beam_moment_;
  Drift motion_;
  Drift transfer_;
};

}  // namespace ligament
