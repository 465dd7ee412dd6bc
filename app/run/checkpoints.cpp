#include "run/checkpoints.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/state_hash.hpp"
#include "core/text_hash.hpp"
#include "io/state_archive.hpp"
#include "run/case_changes.hpp"
#include "version.hpp"

namespace ligament {

Checkpoints::Checkpoints(const RunDirectory& directory, const Case& input)
    : store_(directory.checkpoint_folder(), directory.run_id(), static_cast<int>(input.checkpoint.keep)) {
  provenance_.program_version = program_version();
  provenance_.build = program_build();
  provenance_.compiler = program_compiler();
  provenance_.run_id = directory.run_id();
  provenance_.case_hash = case_hash(input);
  provenance_.case_text = input.file.resolved_text();
  provenance_.overrides = directory.overrides();
  for (const auto& [path, content] : input.files->contents()) provenance_.inputs.emplace_back(path, text_hash(content));
  provenance_.seed = input.generation.seed;
}

std::filesystem::path Checkpoints::save(const State& state) {
  CheckpointHeader header = provenance_;
  header.state_hash = state_hash(state);
  header.step = state.clock.step;
  header.time = state.clock.time;
  header.array_lengths = array_lengths(state);
  archive_ = save_state(state, std::move(archive_));
  return store_.write(std::move(header), archive_);
}

std::optional<std::int64_t> Checkpoints::restore(Simulation& simulation, const CheckpointStore::OnBad& on_bad) const {
  const std::optional<Checkpoint> checkpoint = store_.newest_good(on_bad);
  if (!checkpoint) return std::nullopt;
  require_same_run(checkpoint->header.case_text, provenance_.case_text);
  if (checkpoint->header.inputs != provenance_.inputs) {
    throw InputError(
        "a file in the inputs/ of the run directory is not the one the checkpoints were written with: it must not "
        "change between run and resume");
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
