#pragma once

#include <functional>
#include <optional>

#include "core/body_memory.hpp"
#include "core/contact_memory.hpp"
#include "core/force_provider.hpp"
#include "integrator/adaptive_momenta.hpp"
#include "integrator/prescribed_motion.hpp"
#include "integrator/two_level_mass.hpp"

namespace ligament {

/// What the loading asks of the rest of the simulation, about the state as it is.
struct ForceEvaluation {
  std::function<void()> add_forces;           ///< resultants of all bodies, contacts from their memory
  std::function<void()> add_applied_loads;    ///< resultants of the applied loads alone, in place of the others
  std::function<ForceMagnitudes()> internal;  ///< see ForceProvider::internal_forces()
  std::function<bool()> is_interrupted;       ///< whether to give up
};

/// Quasi-static loading in increments, each relaxed to equilibrium with masses of two levels. Contacts remember the
/// last equilibrium: while an increment is relaxed, forces are functions of that memory and of the motion since, so
/// that transients leave no trace. Work of platens and loads is booked along states of equilibrium. The work of
/// resultants on free bodies along the line from one equilibrium to the next, above all the energy that is set free at
/// a jump, is a line of the ledger of its own, "released".
class IncrementalLoading : public EnergySource {
 public:
  void declare(Parameters& parameters);
  /// Prescribed freedoms, the length of each stage of loading (s), and the unbalanced force ratio of an equilibrium.
  void set_loading(std::vector<PrescribedFreedom> freedoms, std::vector<double> ends, double unbalanced_ratio);
  /// Makes the masses, from those of the state.
  void use_stiffness(const Model& model, const State& state, const StiffnessSum& stiffness);

  /// Opens its lines of the ledger.
  static void open_lines(EnergyLedger& ledger);

  /// Goes to the next state of equilibrium of the present stage: clock, displacements, contacts, ledger. False if there
  /// is none within its limits, or if it is interrupted; the state is then the last equilibrium.
  bool advance(const Model& model, State& state, const ForceEvaluation& evaluation);

  [[nodiscard]] std::vector<EnergyTerm> energies(const Model& model, const State& state) const override;

 private:
  /// The equilibrium that an increment starts from.
  struct Start {
    double time = 0.0;
    ContactMemory contacts;
    BodyMemory bodies;
    std::vector<double> forces;  ///< of all freedoms, prescribed ones included
    std::vector<double> loads;
  };
  /// Works from one equilibrium to the next (J), or their rates on the way.
  struct Work {
    double of_all = 0.0;    ///< of resultants on all freedoms
    double of_free = 0.0;   ///< on free ones
    double of_loads = 0.0;  ///< of applied loads

    Work& operator+=(const Work& b);
    friend Work operator+(Work a, const Work& b) { return a += b; }
    friend Work operator*(double s, const Work& a) { return {s * a.of_all, s * a.of_free, s * a.of_loads}; }
    friend Work operator-(const Work& a, const Work& b) { return a + (-1.0) * b; }
    /// Of what moves prescribed freedoms, against the resultants on them.
    [[nodiscard]] double of_prescribed() const { return of_free - of_all; }
  };

  void begin(const Model& model, State& state, const ForceEvaluation& evaluation);
  void restore(State& state) const;
  /// The motion of a stage that begins, from a small increment that is taken back.
  void find_direction(const Model& model, State& state, const ForceEvaluation& evaluation, double wanted);
  void remember_direction(const Model& model, State& state, double step) const;
  [[nodiscard]] double wanted_step(const State& state) const;
  bool relax(const Model& model, State& state, const ForceEvaluation& evaluation, double step);
  /// Moves all bodies and evaluates their forces.
  void move(const Model& model, State& state, const ForceEvaluation& evaluation, const std::vector<double>& motion);
  void accept(const Model& model, State& state, const ForceEvaluation& evaluation, double step);
  [[nodiscard]] Work rate(const std::vector<double>& motion, const std::vector<double>& forces,
                          const std::vector<double>& loads) const;
  /// The work along the straight line from the last equilibrium to this one, on which the contacts, too, take their
  /// history from one to the other.
  Work line_work(const Model& model, State& state, const ForceEvaluation& evaluation, const std::vector<double>& motion,
                 bool is_smooth);
  static void book(const Work& along_equilibria, const Work& along_line, EnergyLedger& ledger);
  static std::vector<double> applied_loads(const Model& model, State& state, const ForceEvaluation& evaluation);
  [[nodiscard]] std::vector<double> prescribed_motion(const Model& model, const State& state, double step) const;
  [[nodiscard]] bool is_settled(const Model& model, const State& state, const ForceEvaluation& evaluation);

  // Parameters.
  double increment_ = 0.0;        ///< of the fastest prescribed motion (m)
  std::int64_t load_steps_ = 50;  ///< increments of a stage without prescribed motion
  double force_mismatch_ = 1e-3;  ///< of external forces, over the running peak
  std::int64_t settled_evaluations_ = 3;
  std::int64_t most_evaluations_ = 3000;
  double smallest_share_ = 1e-3;  ///< of an increment that is cut, over the wanted one
  DampingBounds bounds_;
  std::optional<double> coarse_cell_;

  std::vector<PrescribedFreedom> freedoms_;
  std::vector<double> ends_;
  double unbalanced_ratio_ = 0.0;
  std::optional<TwoLevelMass> mass_;

  // Scratch of an increment.
  Start start_;
  std::vector<double> free_;    ///< 1 for free freedoms
  std::vector<double> forces_;  ///< of all freedoms at the last evaluation
  std::vector<double> loads_;   ///< at the end of the increment
  double through_force_ = 0.0;  ///< half the sum of the magnitudes of external forces (N)
  std::int64_t n_evaluations_ = 0;
};

}  // namespace ligament
