#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "audit/step_audit.hpp"
#include "build/build_simulation.hpp"
#include "core/error.hpp"
#include "run/checkpoints.hpp"
#include "run/console.hpp"
#include "run/ending.hpp"
#include "run/live_table.hpp"
#include "run/results.hpp"

namespace ligament {

/// Takes a simulation through its steps: rows, fields, checkpoints and audits at step boundaries, until it has
/// converged, come to its last step or been stopped.
class Runner {
 public:
  Runner(const Case& input, BuiltSimulation& built, const RunDirectory& directory, Console& console);

  /// Where the run is to stop on request, besides its own end.
  void stop_at(std::optional<std::int64_t> step) { stop_step_ = step; }

  /// From step 0. Returns what goes to the shell.
  ExitCode start();
  /// From the newest good checkpoint, or from step 0 if there is none.
  ExitCode resume();

 private:
  ExitCode go_on();
  /// Throws FileError if starting anew would overwrite what a run has reached.
  void refuse_to_lose_results() const;
  /// Whether the case asks for convergence, and loads and motions of the stage come to an end.
  [[nodiscard]] bool can_converge() const;
  /// Values of all gauges at this boundary.
  [[nodiscard]] std::vector<double> readings() const;
  /// Takes note of the peaks of gauges and of the balance of forces.
  void watch_gauges();
  /// Which criterion of the case ends the run, in words; empty if none does.
  [[nodiscard]] std::string reached_criterion() const;
  /// Whether the stage of loading has come to its end: fully loaded and in equilibrium.
  bool is_stage_complete();
  [[nodiscard]] bool is_last_stage() const;
  /// Why the run ends at this boundary, if it does.
  std::optional<Ending> find_ending();
  /// What a signal asks for.
  std::optional<Ending> requested_ending();
  /// An increment of loading found no equilibrium, or was interrupted by a signal.
  Ending end_at_last_equilibrium();
  void handle_boundary(std::optional<Ending> ending);
  /// Writes the state of equilibrium that a stage ends in, and begins the next one.
  void finish_stage();
  /// Writes the results that wait; false if they wait on. Throws FileError if the case asks for an end then, or if too
  /// many wait.
  bool write_results();
  void go_on_without_write(const std::string& consequence, const std::string& reason);
  /// Writes a checkpoint, and first all results; throws FileError if one of them cannot be written.
  void save_state();
  /// The same, but a run goes on that cannot save its state.
  void save_checkpoint(bool is_asked_for);
  void check_finite();
  /// Writes summary.json and tells how the run ended; whether the audit is passed.
  bool summarize(Ending ending);
  [[noreturn]] void end_diverged();
  ExitCode finish(Ending ending);
  [[nodiscard]] bool is_due(std::int64_t every) const { return step() % every == 0; }
  [[nodiscard]] std::int64_t step() const { return built_.simulation.state().clock.step; }

  const Case& input_;
  BuiltSimulation& built_;
  const RunDirectory& directory_;
  Console& console_;
  Checkpoints checkpoints_;
  std::optional<Results> results_;
  std::optional<StepAudit> step_audit_;
  LiveTable table_;
  std::optional<std::int64_t> stop_step_;
  std::string last_checkpoint_ = "none";
  std::string failed_write_;           ///< of results, at the last try; empty if it went well
  std::int64_t checkpoint_step_ = -1;  ///< of the last one
  bool wants_checkpoint_ = false;      ///< asked for by a signal
  std::string reached_;                ///< criterion of the case that has ended the run
  bool stage_is_complete_ = false;     ///< at this boundary, with more stages to come
  std::string divergence_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace ligament
