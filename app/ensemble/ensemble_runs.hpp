#pragma once

#include <filesystem>
#include <vector>

#include "ensemble/ensemble_tables.hpp"
#include "run/console.hpp"

namespace ligament {

/// How the runs of an ensemble are made.
struct RunSettings {
  std::filesystem::path folder;     ///< of the ensemble
  std::filesystem::path case_path;  ///< as it was named
  int n_jobs = 2;                   ///< runs at a time
  int n_threads = 1;                ///< of every run
};

/// Starts the runs that are missing and resumes those that have not come to an end of their own, each as a process; a
/// line tells of every one that ends. A signal to stop is passed on, and no more runs are started. Brings the outcomes
/// of all rows up to date; returns the signal, or 0.
int make_runs(const RunSettings& settings, std::vector<EnsembleRow>& rows, Console& console);

}  // namespace ligament
