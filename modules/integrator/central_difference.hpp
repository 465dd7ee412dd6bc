#pragma once

#include <memory>

#include "core/integrator.hpp"
#include "integrator/body_loops.hpp"

namespace ligament {

/// Central differences in leapfrog form, Eqs (1)-(2): v(n+½) = v(n-½) + a(n) Δt, x(n+1) = x(n) + v(n+½) Δt, the same
/// for rotations. At rest v(-½) = 0.
class CentralDifference : public Integrator {
 public:
  explicit CentralDifference(std::unique_ptr<Damping> damping) : damping_(std::move(damping)) {}

  void declare(Parameters& parameters) override { damping_->declare(parameters); }
  StepTravel update_positions(const Model& model, State& state) const override;
  void update_velocities(const Model& model, State& state) override;
  [[nodiscard]] std::vector<EnergyTerm> energies(const Model& model, const State& state) const override;
  void book_work(const Model& model, State& state) override;

 private:
  std::unique_ptr<Damping> damping_;
  TwoSums damping_work_;  ///< its halves, see PathSum, of the step under way (J)
};

}  // namespace ligament
