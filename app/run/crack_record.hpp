#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "io/csv_table.hpp"
#include "run/crack_planes.hpp"
#include "simulation.hpp"

namespace ligament {

/// cracks.csv: a row for every bond that breaks, after the step or increment that broke it. What is known to be broken
/// already follows from the state.
class CrackRecord {
 public:
  /// Starts a new file, with what is broken at step 0.
  CrackRecord(const std::filesystem::path& path, Simulation& simulation);
  /// Goes on with the file of a run that is resumed at this step; what it holds beyond it is dropped.
  CrackRecord(const std::filesystem::path& path, const Simulation& simulation, std::int64_t resumed_step);

  /// Adds a row for every bond that has broken since the last call, and counts it in the state.
  void observe(Simulation& simulation);
  /// The file it writes to.
  CsvTable& table() { return table_; }
  [[nodiscard]] const CsvTable& table() const { return table_; }

 private:
  /// Broken contacts in the list at the last look; sorted.
  using Pairs = std::vector<SetupPair>;

  template <class Pairing>
  void observe_table(Simulation& simulation, const char* kind, Pairs& known);

  CsvTable table_;
  std::array<Pairs, 3> known_;
  std::int64_t n_updates_ = -1;  ///< of the search at the last look
};

/// The planes of the bonds that broke up to a step, as cracks.csv tells of them: also of contacts that have left the
/// list since. FileError if the file cannot be read.
std::vector<CrackPlane> read_broken_planes(const std::filesystem::path& path, std::int64_t last_step);

/// The planes of all bonds that have broken or soften at the present step.
std::vector<CrackPlane> planes_so_far(const std::filesystem::path& path, const Simulation& simulation);

}  // namespace ligament
