#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "ensemble/plan.hpp"

namespace ligament {

/// How a run of an ensemble stands.
struct MemberOutcome {
  std::string ended = "not_started";  ///< as in summary.json; "unfinished" if a run has none yet
  bool is_final = false;              ///< at an end of its own, which calling it again would only repeat
  int exit_code = 0;                  ///< of the run; of its process if it came to no summary
  std::int64_t steps = 0;
  double energy_error = NAN;
  std::string audit;  ///< "passed" or "failed"; empty without summary
  /// Broken bonds, largest readings of all gauges (`peak_<gauge>`), and the `results` of the summary.
  std::vector<std::pair<std::string, double>> numbers;

  [[nodiscard]] bool is_done() const { return is_final && exit_code == 0; }
};

/// Reads summary.json and history.csv of a run directory, which may not be there yet. FileError if they are damaged.
MemberOutcome read_outcome(const std::filesystem::path& run);

/// Throws InputError unless the directory, if it is there, holds a run of this case with these overrides, and with the
/// same content of the files that the case names.
void check_member(const std::filesystem::path& run, const EnsembleMember& member,
                  const std::filesystem::path& case_path, const std::string& case_text);

}  // namespace ligament
