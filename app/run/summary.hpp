#pragma once

#include <optional>
#include <string>

#include "build/build_simulation.hpp"
#include "run/ending.hpp"
#include "run/run_directory.hpp"

namespace ligament {

/// What a run knows about itself at its end.
struct RunSummary {
  Ending ending;
  double wall_time = 0.0;  ///< of this process (s)
  std::string reached;     ///< criterion of the case that ended it, in words; empty if none did
  std::string divergence;  ///< what happened, if it diverged
  std::optional<double> motion_error;
  std::optional<double> transfer_error;
};

/// Writes summary.json; returns whether the energy audit passed.
bool write_summary(const Case& input, const BuiltSimulation& built, const RunDirectory& directory,
                   const RunSummary& summary);

/// The last line of a run: how it ended, after how many steps, and the verdict of the audit.
std::string describe_ending(const Case& input, const BuiltSimulation& built, const RunSummary& summary,
                            bool audit_passed);

}  // namespace ligament
