#include "run/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "audit/lost_body.hpp"
#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "run/crack_record.hpp"
#include "run/external_forces.hpp"
#include "run/macro_crack.hpp"
#include "run/run_report.hpp"
#include "run/signals.hpp"
#include "run/summary.hpp"

namespace ligament {
namespace {

/// Every step is checked where the case asks for it, and always in audit builds.
bool audits_every_step(const Case& input) {
#ifdef LIGAMENT_AUDIT
  static_cast<void>(input);
  return true;
#else
  return input.audit.every_step;
#endif
}

ExitCode exit_code_of(Ending ending) {
  switch (ending) {
    case Ending::not_converged:
      return ExitCode::not_converged;
    case Ending::diverged:
      return ExitCode::diverged;
    case Ending::interrupted:
      return ExitCode::interrupted;
    case Ending::terminated:
      return ExitCode::terminated;
    default:
      return ExitCode::done;
  }
}

/// choice: results that wait for room may take this much memory; a run that stops then loses nothing, since it goes on
/// from its last checkpoint.
constexpr std::size_t most_waiting_bytes = std::size_t{256} << 20;

/// The run is at an end of its own; it was not merely stopped.
bool is_final(Ending ending) {
  return ending == Ending::converged || ending == Ending::completed || ending == Ending::not_converged;
}

}  // namespace

Runner::Runner(const Case& input, BuiltSimulation& built, const RunDirectory& directory, Console& console)
    : input_(input),
      built_(built),
      directory_(directory),
      console_(console),
      checkpoints_(directory, input),
      table_(input, built.gauges, console) {
  // The audits of every step are those of stepping.
  built.simulation.interrupt_increments_by(&is_stop_requested);
  if (input.output.transient_every) {
    const auto write_row = [this](std::int64_t evaluation, double kinetic_energy) {
      results_->add_transient_row(built_, evaluation, kinetic_energy);
    };
    built.simulation.observe_increments_by({*input.output.transient_every, write_row});
  }
  if (audits_every_step(input) && !built.simulation.is_quasi_static()) step_audit_.emplace(built.simulation);
}

ExitCode Runner::start() {
  results_.emplace(directory_, built_, input_.output.transient_every.has_value());
  table_.show_header();
  table_.show(results_->add_row(built_));
  results_->add_fields(built_.simulation);
  try {
    // A run that cannot save its start is not begun: whoever started it is still there.
    save_state();
  } catch (const DivergenceError& error) {
    divergence_ = error.what();
    return finish(Ending::diverged);
  }
  return go_on();
}

ExitCode Runner::resume() {
  const auto step = checkpoints_.restore(built_.simulation, [&](const auto& path, const std::string& reason) {
    console_.warning(fmt::format("{}: {}; taking an earlier one", path.string(), reason));
  });
  if (!step) {
    refuse_to_lose_results();
    console_.line("no checkpoint yet: starting from step 0");
    return start();
  }
  console_.line(fmt::format("resuming from step {}", *step));
  last_checkpoint_ = fmt::format("the one of step {}", *step);
  checkpoint_step_ = *step;
  results_.emplace(directory_, built_, input_.output.transient_every.has_value(), *step);
  if (step_audit_) step_audit_.emplace(built_.simulation);
  table_.show_header();
  return go_on();
}

void Runner::refuse_to_lose_results() const {
  const auto history = directory_.file("history.csv");
  if (!std::filesystem::exists(history)) return;
  // A run saves a checkpoint before its first step: lines beyond the header and step 0 say that checkpoints were lost.
  const std::string text = read_file(history);
  if (std::count(text.begin(), text.end(), '\n') <= 2) return;
  throw FileError(fmt::format(
      "{}: there is no good checkpoint of this run, though it has results; put its checkpoints back, or start "
      "anew with 'ligament run … --overwrite'",
      directory_.checkpoint_folder().string()));
}

ExitCode Runner::go_on() {
  // A run that had already ended ends again, at the same step, and writes nothing anew but its summary.
  std::optional<Ending> ending = find_ending();
  try {
    while (!ending) {
      if (!built_.simulation.advance()) {
        ending = end_at_last_equilibrium();
        break;
      }
      results_->record_breaks(built_.simulation);
      if (step_audit_) step_audit_->observe(built_.simulation);
      ending = find_ending();
      handle_boundary(ending);
    }
  } catch (const DivergenceError& error) {
    divergence_ = error.what();
    ending = Ending::diverged;
  }
  return finish(*ending);
}

bool Runner::can_converge() const {
  const StageState& stage = built_.simulation.state().stage;
  return input_.solver.unbalanced_force_ratio && std::isfinite(built_.end_of_loading[stage.number - 1]);
}

bool Runner::is_last_stage() const {
  return built_.simulation.state().stage.number == static_cast<std::int64_t>(built_.end_of_loading.size());
}

bool Runner::is_stage_complete() {
  const State& state = built_.simulation.state();
  // What is in equilibrium while it is still being loaded has not come to its end.
  const double end = built_.end_of_loading[state.stage.number - 1];
  // Increments end at it up to rounding.
  const bool is_loaded = state.clock.time - state.stage.begin_time >= (1.0 - 1e-12) * end;
  if (built_.simulation.is_quasi_static()) return is_loaded;
  const bool has_moved = state.stage.number == 1 || step() > state.stage.begin_step;
  if (!can_converge() || !is_loaded || !has_moved || !is_due(input_.solver.check_every)) return false;
  const Unbalance unbalance = built_.simulation.unbalance();
  if (!std::isfinite(unbalance.largest_resultant)) check_finite();
  return unbalance.ratio() <= *input_.solver.unbalanced_force_ratio;
}

std::vector<double> Runner::readings() const {
  std::vector<double> values;
  const Simulation& simulation = built_.simulation;
  for (const Gauge& gauge : built_.gauges) values.push_back(gauge.value(simulation.model(), simulation.state()));
  return values;
}

void Runner::watch_gauges() {
  const bool is_quasi_static = built_.simulation.is_quasi_static();
  built_.simulation.note_readings(
      readings(), is_quasi_static ? external_forces(built_.simulation, built_.freedoms).lacking() : 0.0);
}

std::string Runner::reached_criterion() const {
  const std::vector<double> values = readings();
  for (const StopCriterion& stop : built_.stops) {
    std::string reached = stop.reached(values, built_.simulation.state().stage.peaks);
    if (!reached.empty()) return reached;
  }
  if (built_.pieces) {
    const double share = built_.pieces->largest_cut_off(built_.simulation.model(), built_.simulation.state());
    if (share > *input_.stop->table.cut_off_share) return fmt::format("{:.3g} of the structure is cut off", share);
  }
  if (input_.stop && input_.stop->table.crack_span) {
    const auto crack = find_macro_crack(planes_so_far(directory_.file("cracks.csv"), built_.simulation));
    if (crack && crack->span > *input_.stop->table.crack_span) {
      return fmt::format("the macro-crack spans {:.3g} m", crack->span);
    }
  }
  return {};
}

std::optional<Ending> Runner::find_ending() {
  if (built_.simulation.is_quasi_static() || is_due(input_.solver.check_every)) {
    watch_gauges();
    // The macro-crack is found from the breaks in cracks.csv.
    if (input_.stop && input_.stop->table.crack_span) write_results();
    reached_ = reached_criterion();
    if (!reached_.empty()) return Ending::completed;
  }
  const bool is_complete = is_stage_complete();
  if (is_complete && is_last_stage()) return Ending::converged;
  stage_is_complete_ = is_complete;
  if (step() >= input_.solver.max_steps) {
    return can_converge() ? Ending::not_converged : Ending::completed;
  }
  if (const auto requested = requested_ending()) return requested;
  if (stop_step_ && step() >= *stop_step_) return Ending::stopped;
  return std::nullopt;
}

std::optional<Ending> Runner::requested_ending() {
  switch (take_request()) {
    case Request::stop_by_interrupt:
      return Ending::interrupted;
    case Request::stop_by_termination:
      return Ending::terminated;
    case Request::checkpoint:
      wants_checkpoint_ = true;
      break;
    case Request::none:
      break;
  }
  return std::nullopt;
}

Ending Runner::end_at_last_equilibrium() {
  const Ending ending = requested_ending().value_or(Ending::not_converged);
  // Its row and fields have been written if they were due.
  if (is_final(ending) && !is_due(input_.output.every)) table_.show(results_->add_row(built_));
  const bool has_fields = step() == 0 || (input_.output.fields_every && is_due(*input_.output.fields_every));
  if (is_final(ending) && !has_fields) results_->add_fields(built_.simulation);
  save_checkpoint(true);
  return ending;
}

void Runner::handle_boundary(std::optional<Ending> ending) {
  const bool is_end = stage_is_complete_ || (ending && is_final(*ending));
  const bool row_is_due = is_due(input_.output.every) || is_end;
  if (row_is_due) {
    check_finite();
    table_.show(results_->add_row(built_));
  }
  const bool fields_are_due = is_end || (input_.output.fields_every && is_due(*input_.output.fields_every));
  if (fields_are_due) results_->add_fields(built_.simulation);
  if (stage_is_complete_) finish_stage();
  // Last, so that it stands for everything this boundary has written.
  if (is_due(input_.checkpoint.every) || ending || wants_checkpoint_) {
    save_checkpoint(ending.has_value() || wants_checkpoint_);
    wants_checkpoint_ = false;
  } else if (row_is_due || fields_are_due) {
    write_results();
  }
  table_.show_progress(step());
}

void Runner::finish_stage() {
  console_.line(fmt::format("stage {} of {} in equilibrium at step {}", built_.simulation.state().stage.number,
                            built_.end_of_loading.size(), step()));
  built_.simulation.finish_stage(readings());
  stage_is_complete_ = false;
}

bool Runner::write_results() {
  try {
    results_->flush();
    if (!failed_write_.empty()) console_.line(fmt::format("step {}: the results that waited are written", step()));
    failed_write_.clear();
  } catch (const FileError& error) {
    failed_write_ = error.what();
    go_on_without_write("results wait in memory for the next try", failed_write_);
  }
  return failed_write_.empty();
}

void Runner::go_on_without_write(const std::string& consequence, const std::string& reason) {
  const bool has_room = results_->n_waiting() <= most_waiting_bytes;
  if (input_.output.on_failed_write == OnFailedWrite::go_on && has_room) {
    return console_.warning(fmt::format("step {}: {}: {}", step(), consequence, reason));
  }
  const char* const why = has_room ? "" : "; too many results wait in memory";
  throw FileError(fmt::format("step {}: {}{}; last good checkpoint: {}", step(), reason, why, last_checkpoint_));
}

void Runner::save_state() {
  check_finite();
  // A checkpoint stands for all results up to its step.
  results_->sync();
  last_checkpoint_ = checkpoints_.save(built_.simulation.state()).string();
  checkpoint_step_ = step();
}

void Runner::save_checkpoint(bool is_asked_for) {
  if (!write_results()) return;
  try {
    save_state();
    if (is_asked_for) console_.line(fmt::format("checkpoint: {}", last_checkpoint_));
  } catch (const FileError& error) {
    // The run is worth more than one checkpoint: the next one may find room again.
    go_on_without_write("no checkpoint written", error.what());
  }
}

void Runner::check_finite() {
  const Simulation& simulation = built_.simulation;
  const std::string body = describe_infinite_body(simulation.model(), simulation.state());
  if (!body.empty()) throw DivergenceError(fmt::format("step {}: {}", step(), body));
}

bool Runner::summarize(Ending ending) {
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  RunSummary summary{.ending = ending, .wall_time = seconds, .reached = reached_, .divergence = divergence_};
  if (step_audit_) {
    summary.motion_error = step_audit_->motion_error();
    summary.transfer_error = step_audit_->transfer_error();
  }
  const bool audit_passed = write_summary(input_, built_, directory_, summary);
  console_.line(describe_ending(input_, built_, summary, audit_passed));
  return audit_passed;
}

void Runner::end_diverged() {
  try {
    write_results();
    summarize(Ending::diverged);
  } catch (const FileError& error) {
    // That the run diverged is what is to be told.
    console_.warning(error.what());
  }
  throw DivergenceError(fmt::format("{}; time step {} s, limited by {}; last good checkpoint: {}", divergence_,
                                    built_.simulation.state().clock.time_step, built_.simulation.limiting_body(),
                                    last_checkpoint_));
}

ExitCode Runner::finish(Ending ending) {
  if (ending == Ending::diverged) end_diverged();
  if (!failed_write_.empty()) {
    throw FileError(
        fmt::format("step {}: the run is at its end, and results could not be written: {}; last good checkpoint: {}",
                    step(), failed_write_, last_checkpoint_));
  }
  const bool audit_passed = summarize(ending);
  console_.line(fmt::format("results: {}", directory_.path().string()));
  if (!is_final(ending)) {
    if (checkpoint_step_ != step()) throw FileError(fmt::format("step {}: stopped without a checkpoint", step()));
    console_.line(fmt::format("to go on: ligament resume {}", directory_.path().string()));
  }
  const ExitCode code = exit_code_of(ending);
  return code == ExitCode::done && !audit_passed ? ExitCode::audit_failed : code;
}

}  // namespace ligament
