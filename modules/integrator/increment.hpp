#pragma once

#include <functional>
#include <optional>

#include "core/body_memory.hpp"
#include "core/contact_memory.hpp"
#include "core/force_provider.hpp"
#include "integrator/force_work.hpp"
#include "integrator/prescribed_motion.hpp"

namespace ligament {

/// Who looks on while an equilibrium is searched for.
struct IncrementObserver {
  std::int64_t every = 0;  ///< evaluations of the forces; never, if 0
  /// Told the number of evaluations so far and the kinetic energy (J); the state is that of the evaluation.
  std::function<void(std::int64_t, double)> look = {};
};

/// What the loading asks of the rest of the simulation, about the state as it is.
struct ForceEvaluation {
  std::function<void()> add_forces;           ///< resultants of all bodies, contacts from their memory
  std::function<void()> add_applied_loads;    ///< resultants of the applied loads alone, in place of the others
  std::function<ForceMagnitudes()> internal;  ///< see ForceProvider::internal_forces()
  std::function<void()> update_contacts;      ///< finds new contacts and drops old ones if bodies have moved far
  std::function<bool()> is_interrupted;       ///< whether to give up
  std::function<StiffnessSum()> stiffness;    ///< of elements and contacts
  /// See ForceProvider::add_secants().
  std::function<std::vector<double>(const ContactMemory& before)> secants;
  /// See ForceProvider::add_loose_contacts() and try_contact(); springs are numbered as in `stiffness`.
  std::function<std::vector<LooseContact>(const ContactMemory& before)> loose_contacts;
  std::function<SpringAnswer(const ContactMemory& before, std::size_t spring, const SpringPair& stretch)> try_contact;
  IncrementObserver observer = {};
};

/// When the bodies are in equilibrium, and how long it is searched for.
struct EquilibriumCriterion {
  double unbalanced_ratio = 5e-3;  ///< largest unbalanced force ratio
  double force_mismatch = 1e-3;    ///< of external forces, over the running peak
  std::int64_t settled_evaluations = 3;
  std::int64_t most_evaluations = 3000;
  std::int64_t most_live_evaluations = 100000;

  void declare(class Parameters& parameters);
};

/// An increment of loading under way. While its equilibrium is searched for, forces are functions of what contacts
/// remember of the last equilibrium and of the motion since then, so that the search leaves no trace. In a live
/// increment contacts take their history along with every motion instead, and are found and dropped on the way.
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
  /// Lets the increment live from here, the last equilibrium, on.
  void go_live();
  /// Moves all bodies and evaluates their forces.
  void move(const std::vector<double>& motion);
  /// Goes to a place on the straight line from the last equilibrium; `motion` is the whole way.
  void go_along(const std::vector<double>& motion, double end_time, double share);
  /// Whether the observer looks on; at first it does.
  void observe(bool is_observed) { is_observed_ = is_observed; }
  /// Lets it look, if it is time, at this kinetic energy (J).
  void show(double kinetic_energy) const;
  /// Whether the bodies are in equilibrium at this evaluation.
  [[nodiscard]] bool is_in_equilibrium();
  /// The largest resultant that equilibrium allows (N).
  [[nodiscard]] double force_tolerance() const;
  /// Whether the bodies have been in equilibrium in this and the evaluations before, as many as it takes.
  [[nodiscard]] bool has_settled();
  /// Whether the search is to be given up.
  [[nodiscard]] bool is_exhausted() const;
  [[nodiscard]] bool is_interrupted() const { return evaluation_.is_interrupted(); }

  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] State& state() { return state_; }
  [[nodiscard]] const State& state() const { return state_; }
  /// How far prescribed freedoms move in a step of pseudo-time; zero elsewhere.
  [[nodiscard]] std::vector<double> prescribed_motion(double step) const;
  /// From the last equilibrium to here, all freedoms.
  [[nodiscard]] std::vector<double> motion() const;
  [[nodiscard]] bool is_live() const { return before_.has_value(); }
  /// From the last equilibrium to here along the way of a live increment.
  [[nodiscard]] const ForceWork& work_on_the_way() const { return work_on_the_way_; }
  /// 1 for free freedoms.
  [[nodiscard]] const std::vector<double>& free() const { return free_; }
  /// At the last evaluation, of all freedoms.
  [[nodiscard]] const std::vector<double>& forces() const { return forces_; }
  [[nodiscard]] const std::vector<double>& loads() const { return loads_; }
  /// Forces, zero where freedoms are prescribed.
  [[nodiscard]] std::vector<double> free_forces() const;
  /// Stiffness of elements and of springs of contacts, and the secants of the latter; see ForceProvider.
  [[nodiscard]] StiffnessSum stiffness() const { return evaluation_.stiffness(); }
  [[nodiscard]] std::vector<double> secants() const { return evaluation_.secants(start_.contacts); }
  [[nodiscard]] std::vector<LooseContact> loose_contacts() const { return evaluation_.loose_contacts(start_.contacts); }
  [[nodiscard]] SpringAnswer try_contact(std::size_t spring, const SpringPair& stretch) const {
    return evaluation_.try_contact(start_.contacts, spring, stretch);
  }
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
    BodyMemory bodies;
    std::vector<double> forces;
    std::vector<double> loads;
  };

  void clear_increments();
  void move_live(const std::vector<double>& motion);
  [[nodiscard]] std::vector<double> applied_loads();
  [[nodiscard]] double mean_force() const;

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
  bool is_observed_ = true;
  // Of a live increment.
  std::optional<State> before_;  ///< the last equilibrium, with the contacts that it has
  std::vector<double> way_;      ///< from there to here
  ForceWork work_on_the_way_;
  double mean_force_before_ = 0.0;  ///< of contacts at the last equilibrium (N)
};

}  // namespace ligament
