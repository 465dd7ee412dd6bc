#pragma once

#include <filesystem>
#include <string>

#include "ensemble/plan.hpp"

namespace ligament {

/// The text of ensemble_plan.json.
std::string plan_text(const EnsembleRequest& request);

/// Reads it back; FileError if it cannot be read or is damaged.
EnsembleRequest read_plan(const std::filesystem::path& path);

/// What keeps runs of an earlier call from being part of this one, for a message; empty if nothing does: the same case,
/// overrides and swept keys, and all of its seeds and values.
std::string difference(const EnsembleRequest& before, const EnsembleRequest& now);

}  // namespace ligament
