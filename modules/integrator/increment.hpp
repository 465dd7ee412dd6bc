#pragma once

#include <functional>

#include "core/contact_memory.hpp"
#include "core/force_provider.hpp"
#include "integrator/prescribed_motion.hpp"

namespace ligament {

/// What the loading asks of the rest of the simulation, about the state as it is.
struct ForceEvaluation {
  std::function<void()> add_forces;           ///< resultants of all bodies, contacts from their memory
  std::function<void()> add_applied_loads;    ///< resultants of the applied loads alone, in place of the others
  std::function<ForceMagnitudes()> internal;  ///< see ForceProvider::internal_forces()
  std::function<bool()> is_interrupted;       ///< whether to give up
  std::function<StiffnessSum()> stiffness;    ///< of elements and contacts
  /// See ForceProvider::add_secants().
  std::function<std::vector<double>(const ContactMemory& before)> secants;
};

/// When the bodies are in equilibrium, and how long it is searched for.
struct EquilibriumCriterion {
  double unbalanced_ratio = 0.0;  ///< largest unbalanced force ratio
  double force_mismatch = 1e-3;   ///< of external forces, over the running peak
  std::int64_t settled_evaluations = 3;
  std::int64_t most_evaluations = 3000;

  void declare(class Parameters& parameters);
};

/// An increment of loading under way. While its equilibrium is searched for, forces are functions of what contacts
/// remember of the last equilibrium and of the motion since then, so that the search leaves no trace.
class Increment {
 public:
  /// Begins at the state, which is an equilibrium.
  Increment(const Model& model, State& state, const ForceEvaluation& evaluation, const EquilibriumCriterion& criterion,
            const std::vector<PrescribedFreedom>& freedoms);

  /// Back to the last equilibrium.
  void restore();
  /// Evaluations are counted from here.
  void begin();
  /// Pseudo-time goes to a step (s) from the last equilibrium, and loads with it.
  void go_to(double step);
  /// Moves all bodies and evaluates their forces.
  void move(const std::vector<double>& motion);
  /// Goes to a place on the straight line from the last equilibrium; `motion` is the whole way.
  void go_along(const std::vector<double>& motion, double end_time, double share);
  /// Whether the bodies have been in equilibrium in this and the evaluations before, as many as it takes.
  [[nodiscard]] bool has_settled();
  /// Whether the search is to be given up.
  [[nodiscard]] bool is_exhausted() const;

  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] State& state() { return state_; }
  [[nodiscard]] const State& state() const { return state_; }
  /// How far prescribed freedoms move in a step of pseudo-time; zero elsewhere.
  [[nodiscard]] std::vector<double> prescribed_motion(double step) const;
  /// 1 for free freedoms.
  [[nodiscard]] const std::vector<double>& free() const { return free_; }
  /// At the last evaluation, of all freedoms.
  [[nodiscard]] const std::vector<double>& forces() const { return forces_; }
  [[nodiscard]] const std::vector<double>& loads() const { return loads_; }
  /// Stiffness of elements and of springs of contacts, and the secants of the latter; see ForceProvider.
  [[nodiscard]] StiffnessSum stiffness() const { return evaluation_.stiffness(); }
  [[nodiscard]] std::vector<double> secants() const { return evaluation_.secants(start_.contacts); }
  /// At the last equilibrium.
  [[nodiscard]] const std::vector<double>& start_forces() const { return start_.forces; }
  [[nodiscard]] const std::vector<double>& start_loads() const { return start_.loads; }
  [[nodiscard]] double start_time() const { return start_.time; }
  [[nodiscard]] std::int64_t n_evaluations() const { return n_evaluations_; }
  /// Half the sum of the magnitudes of external forces (N).
  [[nodiscard]] double through_force() const { return through_force_; }

 private:
  /// The last equilibrium.
  struct Start {
    double time = 0.0;
    ContactMemory contacts;
    ParticleState particles;
    NodeState nodes;
    std::vector<double> forces;
    std::vector<double> loads;
  };

  [[nodiscard]] std::vector<double> applied_loads();
  [[nodiscard]] bool is_in_equilibrium();

  const Model& model_;
  State& state_;
  const ForceEvaluation& evaluation_;
  const EquilibriumCriterion& criterion_;
  const std::vector<PrescribedFreedom>& freedoms_;
  Start start_;
  std::vector<double> free_;
  std::vector<double> forces_;
  std::vector<double> loads_;
  double through_force_ = 0.0;
  std::int64_t n_evaluations_ = 0;
  std::int64_t n_settled_ = 0;
};

}  // namespace ligament
