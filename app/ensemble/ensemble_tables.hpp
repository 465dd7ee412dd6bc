#pragma once

#include <filesystem>
#include <vector>

#include "ensemble/member_outcome.hpp"
#include "ensemble/plan.hpp"
#include "ensemble/swept_columns.hpp"

namespace ligament {

/// A member, how it stands, and its swept values as columns.
struct EnsembleRow {
  EnsembleMember member;
  MemberOutcome outcome;
  std::vector<SweptValue> values;
};

/// Writes ensemble.csv, a row per run, and ensemble.json: mean, standard deviation, least and largest of every number
/// over the runs that are done, for every combination of swept values.
void write_ensemble_tables(const std::filesystem::path& folder, const std::vector<EnsembleRow>& rows);

/// The rows of every folder of runs with the same values, in their order.
std::vector<std::vector<EnsembleRow>> groups_of(const std::vector<EnsembleRow>& rows);

}  // namespace ligament
