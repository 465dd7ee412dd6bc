#pragma once

#include <optional>

#include "io/checkpoint_store.hpp"
#include "run/run_directory.hpp"
#include "simulation.hpp"

namespace ligament {

/// The checkpoints of a run: State to archive and back, and what run they belong to.
class Checkpoints {
 public:
  Checkpoints(const RunDirectory& directory, const Case& input);

  /// Saves the state; returns the file. Throws FileError and keeps the earlier ones if that fails.
  std::filesystem::path save(const State& state);

  /// Brings the simulation to the newest good checkpoint; nothing if there is none. Damaged ones are passed over, each
  /// with a call of `on_bad`. Throws InputError if the case, or a file that it names, is another one than it was
  /// written with, but for the keys that may change.
  std::optional<std::int64_t> restore(Simulation& simulation, const CheckpointStore::OnBad& on_bad) const;

 private:
  CheckpointStore store_;
  CheckpointHeader provenance_;  ///< what all headers of this run have in common
  std::string archive_;          ///< the last one, for its memory
};

}  // namespace ligament
