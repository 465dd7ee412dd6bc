#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "audit/lost_body.hpp"
#include "core/contact_detector.hpp"
#include "core/integrator.hpp"
#include "integrator/convergence.hpp"
#include "integrator/incremental_loading.hpp"

namespace ligament {

/// Whether masses are the bodies' own or scaled so that a given time step is stable.
enum class Masses { real, scaled };

/// How masses and time step are chosen.
struct TimeStepChoice {
  Masses masses = Masses::scaled;
  double safety = 1.1;     ///< scaled masses over those that the bound asks for
  double factor = 0.9;     ///< time step over the critical one, real masses
  double time_step = 1.0;  ///< of scaled masses; of real masses the largest allowed, if positive (s)
};

/// What a simulation is made of; build_simulation fills it.
struct Modules {
  /// How it moves: by steps of an integrator, or by increments of loading that are relaxed to equilibrium.
  std::unique_ptr<Integrator> integrator;
  std::unique_ptr<IncrementalLoading> loading;
  std::unique_ptr<ContactDetector> contact_detector;
  std::vector<std::unique_ptr<ForceProvider>> force_providers;
  std::vector<std::unique_ptr<Constraint>> constraints;
};

/// A model in motion: owns model, state and modules.
class Simulation {
 public:
  /// Bonds the contacts, sets masses and time step, and brings the state at rest to step 0.
  Simulation(Model model, Modules modules, TimeStepChoice time_step);

  /// From n to n+1: a step, or an increment of loading. False if the increment finds no equilibrium; n then stays.
  bool advance();
  /// The paper's cycle (Fig. 1). Throws DivergenceError, which names the body, if one is not finite or moves too far.
  void step();

  /// Makes room for the readings of gauges at the ends of so many stages of loading.
  void open_stages(std::size_t n_stages, std::size_t n_gauges);
  /// Takes note of readings of all gauges at time n, for their peaks, and of what external forces lack to balance (N).
  void note_readings(const std::vector<double>& readings, double force_mismatch = 0.0);
  /// Ends the stage of loading under way at time n with these readings; the next one begins.
  void finish_stage(const std::vector<double>& readings);

  /// Takes the balance of time n into the ledger; returns its relative error.
  double audit();

  /// Adds bonds that broke to the count.
  void count_breaks(std::int64_t n_tension, std::int64_t n_shear);

  /// All lines of the ledger at time n; lines of one name are summed.
  [[nodiscard]] std::vector<EnergyTerm> energies() const;
  [[nodiscard]] Unbalance unbalance() const;
  /// Bound of the stiffness that each body feels.
  [[nodiscard]] StiffnessBounds stiffness_bounds() const;
  /// Stiffness of elements and contacts.
  [[nodiscard]] StiffnessSum stiffness() const;

  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] const State& state() const { return state_; }
  /// Replaces the state by one read from a checkpoint of the same case.
  void restore(State state) {
    state_ = std::move(state);
    spare_travel_ = 0.0;
  }
  /// Increments of loading end without equilibrium as soon as this says so.
  void interrupt_increments_by(std::function<bool()> is_interrupted) { is_interrupted_ = std::move(is_interrupted); }
  /// Who looks on while increments of loading search for their equilibrium.
  void observe_increments_by(IncrementObserver observer) { observer_ = std::move(observer); }
  /// Whether every state is one of equilibrium.
  [[nodiscard]] bool is_quasi_static() const { return modules_.loading != nullptr; }
  [[nodiscard]] const std::string& limiting_body() const { return limiting_body_; }

 private:
  bool increment();
  void prepare_state();
  void choose_time_step();
  void check_time_step();
  void check_travel(const StepTravel& travel) const;
  bool update_contacts(const StepTravel& travel);
  void add_forces();
  void add_applied_loads();
  [[nodiscard]] ForceMagnitudes internal_forces() const;
  [[nodiscard]] std::vector<double> secants(const ContactMemory& before) const;
  [[nodiscard]] std::vector<LooseContact> loose_contacts(const ContactMemory& before) const;
  [[nodiscard]] SpringAnswer try_contact(const ContactMemory& before, std::size_t spring,
                                         const SpringPair& stretch) const;
  void book_work();

  Model model_;
  State state_;
  Modules modules_;
  TimeStepChoice choice_;
  StepLimits step_limits_;
  double spare_travel_ = 0.0;  ///< how far every body can go before the search has to look at them (m)
  std::function<bool()> is_interrupted_ = [] { return false; };
  IncrementObserver observer_;
  std::string limiting_body_;
};

}  // namespace ligament
