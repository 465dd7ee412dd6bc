#pragma once

#include "core/body_table.hpp"
#include "core/integrator.hpp"
#include "integrator/piecewise_linear.hpp"

namespace ligament {

/// A motion within one stage of loading, by its velocity or by a schedule of displacements; times count from the
/// beginning of the stage.
struct StageVelocity {
  std::int64_t stage = 1;
  double velocity = 0.0;    ///< (m/s, rad/s)
  double rise_time = 0.0;   ///< within which the velocity rises linearly (s)
  double stop_time = -1.0;  ///< after which the body stands still (s); never if negative
  /// Displacements since the beginning of the stage (m, rad), in place of all of these where there are any.
  PiecewiseLinear schedule = {};
};

/// One freedom whose velocity is prescribed. It stands still in stages without a velocity: a support has none.
struct PrescribedFreedom {
  using Body = BodyTable;
  Body body = Body::node;
  Index row = 0;
  int axis = 0;  ///< component of the translation; `dimension` for the rotation of a particle or beam node
  std::vector<StageVelocity> motions = {};
};

/// Its velocity in a step that begins at a time and lasts so long (m/s, rad/s): on a schedule the mean, so that every
/// step ends where the schedule says; else that of the middle.
double prescribed_velocity(const PrescribedFreedom& freedom, const StageState& stage, double begin, double duration);

/// Supports and prescribed motions.
class PrescribedMotion : public Constraint {
 public:
  explicit PrescribedMotion(std::vector<PrescribedFreedom> freedoms) : freedoms_(std::move(freedoms)) {}

  /// Takes the freedoms away from the integrator.
  void fix(Model& model) const;

  void apply(const Model& model, State& state) override;
  [[nodiscard]] std::vector<EnergyTerm> energies(const Model& model, const State& state) const override;
  void book_work(const Model& model, State& state) override;

 private:
  std::vector<PrescribedFreedom> freedoms_;
};

/// Force (N) that holds a body's prescribed freedoms: what its motion shows beyond the resultant. 0 along free axes.
Vector reaction(const TranslationState& bodies, const Field<Vector>& free, const Clock& clock, Index row);

}  // namespace ligament
