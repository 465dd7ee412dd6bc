#include "ensemble/ensemble_runs.hpp"

#include <fmt/format.h>

#include "ensemble/process_pool.hpp"

namespace ligament {
namespace {

std::vector<std::string> arguments_of(const RunSettings& settings, const EnsembleRow& row) {
  const std::string directory = (settings.folder / row.member.run).string();
  std::vector<std::string> arguments;
  if (std::filesystem::exists(directory)) {
    arguments = {"resume", directory};
  } else {
    arguments = {"run", settings.case_path.string(), "--output", directory};
    for (const std::string& override : row.member.overrides) arguments.insert(arguments.end(), {"--set", override});
  }
  arguments.insert(arguments.end(), {"--quiet", "--threads", fmt::format("{}", settings.n_threads)});
  return arguments;
}

/// What its directory says, and the exit code where that says nothing.
MemberOutcome outcome_after(const std::filesystem::path& run, const ProcessPool::Ended& ended) {
  MemberOutcome outcome = read_outcome(run);
  if (!outcome.is_final || outcome.exit_code == 0) outcome.exit_code = ended.code;
  return outcome;
}

std::string ending_of(const EnsembleRow& row) {
  std::string text = fmt::format("{}: {}", row.member.run, row.outcome.ended);
  if (!row.outcome.audit.empty()) {
    text += fmt::format(" at step {}, energy audit {}", row.outcome.steps, row.outcome.audit);
  }
  return row.outcome.exit_code == 0 ? text : text + fmt::format(" (exit code {})", row.outcome.exit_code);
}

}  // namespace

int make_runs(const RunSettings& settings, std::vector<EnsembleRow>& rows, Console& console) {
  std::vector<std::size_t> waiting;
  for (std::size_t i = rows.size(); i-- > 0;) {
    rows[i].outcome = read_outcome(settings.folder / rows[i].member.run);
    if (!rows[i].outcome.is_final) waiting.push_back(i);
  }
  console.line(fmt::format("{} of {} runs to make, {} at a time", waiting.size(), rows.size(), settings.n_jobs));
  ProcessPool pool;
  std::size_t n_made = 0;
  const std::size_t n_wanted = waiting.size();
  while (true) {
    while (pool.stop_signal() == 0 && !waiting.empty() &&
           pool.n_running() < static_cast<std::size_t>(settings.n_jobs)) {
      pool.start(waiting.back(), arguments_of(settings, rows[waiting.back()]));
      waiting.pop_back();
    }
    if (pool.n_running() == 0) return pool.stop_signal();
    console.progress(fmt::format("{} running, {} of {} ended", pool.n_running(), n_made, n_wanted));
    const ProcessPool::Ended ended = pool.wait_for_one();
    ++n_made;
    EnsembleRow& row = rows[ended.number];
    row.outcome = outcome_after(settings.folder / row.member.run, ended);
    console.line(ending_of(row));
    if (!ended.messages.empty())
      console.warning(row.member.run + ": " + ended.messages.substr(0, ended.messages.size() - 1));
  }
}

}  // namespace ligament
