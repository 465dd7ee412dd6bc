#pragma once

#include "core/body_table.hpp"
#include "core/force_provider.hpp"
#include "integrator/piecewise_linear.hpp"

namespace ligament {

/// A force on one body, risen linearly within `rise_time` (s) from the beginning of its stage, at once if that is 0, or
/// as its schedule says; what it has come to stays on in all later stages.
struct PointLoad {
  using Body = BodyTable;
  Body body = Body::node;
  Index row = 0;
  Vector force{};          ///< (N)
  Moment moment = 0.0;     ///< particles and beam nodes only (N m)
  double rise_time = 0.0;  ///< (s)
  std::int64_t stage = 1;
  /// Shares of the force, in place of the rise where there are any; times count from the beginning of the stage.
  PiecewiseLinear schedule = {};
};

/// Forces that the case applies to nodes, particles and beam nodes.
class AppliedLoads : public ForceProvider {
 public:
  explicit AppliedLoads(std::vector<PointLoad> loads) : loads_(std::move(loads)) {}

  void add_forces(const Model& model, State& state) override;
  [[nodiscard]] bool is_applied_load() const override { return true; }
  [[nodiscard]] std::vector<EnergyTerm> energies(const Model& model, const State& state) const override;
  void book_work(const Model& model, State& state) override;

 private:
  std::vector<PointLoad> loads_;
};

}  // namespace ligament
