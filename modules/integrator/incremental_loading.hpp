#pragma once

#include <memory>
#include <optional>
#include <string>

#include "integrator/equilibrium_search.hpp"

namespace ligament {

/// Quasi-static loading in increments, each brought to equilibrium. Contacts remember the last equilibrium.
class IncrementalLoading : public EnergySource {
 public:
  explicit IncrementalLoading(std::unique_ptr<EquilibriumSearch> search)
      : criterion_(search->usual_criterion()), search_(std::move(search)) {}

  void declare(Parameters& parameters);
  /// The unbalanced force ratio of an equilibrium, unless the case says otherwise.
  [[nodiscard]] double usual_force_ratio() const { return criterion_.unbalanced_ratio; }
  /// Prescribed freedoms; of each stage of loading the times (s, ascending) at which motions or loads change their
  /// course, the end of the stage last; and the unbalanced force ratio of an equilibrium.
  void set_loading(std::vector<PrescribedFreedom> freedoms, std::vector<std::vector<double>> corners,
                   double unbalanced_ratio);
  /// The gauge that the case wants followed, if any.
  [[nodiscard]] const std::optional<std::string>& control() const { return control_; }
  /// In stages in which something moves, increments are those of this gauge, a weighted sum of displacements.
  void set_control(std::vector<SpringTerm> gauge) { gauge_ = std::move(gauge); }
  void use_stiffness(const Model& model, const State& state, const StiffnessSum& stiffness) {
    search_->use_stiffness(model, state, stiffness);
  }

  /// Opens its lines of the ledger.
  static void open_lines(EnergyLedger& ledger);

  /// Forgets what belongs to the stage, or the segment of it, before.
  static void begin_segment(State& state);

  /// Goes to the next state of equilibrium of the present stage: clock, displacements, contacts, ledger. False if there
  /// is none within its limits, or if it is interrupted; the state is then the last equilibrium.
  bool advance(const Model& model, State& state, const ForceEvaluation& evaluation);

  [[nodiscard]] std::vector<EnergyTerm> energies(const Model& model, const State& state) const override;

 private:
  /// The motion of a stage that begins, from a small increment that is taken back.
  void find_direction(Increment& increment, double wanted);
  /// The part of a stage between two corners of its loading that an increment belongs to (s).
  struct Segment {
    double begin = 0.0;
    double end = 0.0;
  };
  [[nodiscard]] Segment segment_at(const State& state) const;
  bool find(Increment& increment, const IncrementTarget& target);
  [[nodiscard]] IncrementTarget wanted_target(const State& state) const;
  /// Up to the end of the segment (s).
  [[nodiscard]] double time_left(const State& state) const;
  void accept(Increment& increment);

  // Parameters.
  double increment_ = 0.0;        ///< of the fastest prescribed motion (m)
  std::int64_t load_steps_ = 50;  ///< increments of a segment in which nothing is moved
  std::optional<std::string> control_;
  EquilibriumCriterion criterion_;
  double smallest_share_ = 1e-3;  ///< of an increment that is cut, over the wanted one

  std::unique_ptr<EquilibriumSearch> search_;
  std::vector<PrescribedFreedom> freedoms_;
  std::vector<std::vector<double>> corners_;
  std::vector<SpringTerm> gauge_;
};

}  // namespace ligament
