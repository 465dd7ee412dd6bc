#include "run/checkpoints.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/state_hash.hpp"
#include "io/state_archive.hpp"
#include "version.hpp"

namespace ligament {

Checkpoints::Checkpoints(const RunDirectory& directory, const Case& input)
    : store_(directory.checkpoint_folder(), directory.run_id(), static_cast<int>(input.checkpoint.keep)),
      run_id_(directory.run_id()),
      case_hash_(case_hash(input)) {}

std::filesystem::path Checkpoints::save(const State& state) {
  CheckpointHeader header;
  header.program_version = program_version();
  header.build = program_build();
  header.compiler = program_compiler();
  header.run_id = run_id_;
  header.case_hash = case_hash_;
  header.state_hash = state_hash(state);
  header.step = state.clock.step;
  header.time = state.clock.time;
  header.array_lengths = array_lengths(state);
  return store_.write(std::move(header), save_state(state));
}

std::optional<std::int64_t> Checkpoints::restore(Simulation& simulation, const CheckpointStore::OnBad& on_bad) const {
  const std::optional<Checkpoint> checkpoint = store_.newest_good(on_bad);
  if (!checkpoint) return std::nullopt;
  if (checkpoint->header.case_hash != case_hash_) {
    throw InputError(
        "the case in the run directory, or a file in its inputs/, is not the one the checkpoints were written with: a "
        "case must not change between run and resume");
  }
  State state = simulation.state();
  load_state(checkpoint->payload, checkpoint->header.array_lengths, simulation.model(), state);
  if (state_hash(state) != checkpoint->header.state_hash) {
    throw FileError("the state read from the checkpoint is not the one that was written");
  }
  simulation.restore(std::move(state));
  return checkpoint->header.step;
}

}  // namespace ligament
