#pragma once

#include <optional>

#include "build/build_simulation.hpp"
#include "io/csv_table.hpp"
#include "run/crack_record.hpp"
#include "run/field_output.hpp"
#include "run/run_directory.hpp"

namespace ligament {

/// One row of history.csv, for the live table as well.
struct HistoryRow {
  std::int64_t step = 0;
  double time = 0.0;
  std::vector<double> gauges;
  std::int64_t n_broken = 0;
  double unbalanced_force_ratio = 0.0;
  double energy_error = 0.0;
};

/// The result files of a run that grow with it: history.csv, energy.csv, cracks.csv, fields/, and transient.csv where
/// the case asks for it. Rows and fields are taken into memory and wait there for flush(), however often it fails.
class Results {
 public:
  /// Starts new files.
  Results(const RunDirectory& directory, BuiltSimulation& built, bool has_transients);
  /// Goes on with the files of a run that is resumed at this step; what they hold beyond it is dropped.
  Results(const RunDirectory& directory, const BuiltSimulation& built, bool has_transients, std::int64_t resumed_step);

  /// Takes note of the bonds that the last step or increment broke.
  void record_breaks(Simulation& simulation) { cracks_.observe(simulation); }
  /// Audits the energy and adds a row to both tables.
  HistoryRow add_row(BuiltSimulation& built);
  /// A row of transient.csv, on the way to the next state of equilibrium.
  void add_transient_row(const BuiltSimulation& built, std::int64_t evaluation, double kinetic_energy);
  void add_fields(const Simulation& simulation) { fields_.add(simulation.model(), simulation.state()); }
  /// Writes all that waits, as far as it can be written. Throws FileError for the first file that could not.
  void flush();
  /// Brings everything to the disk, before a checkpoint relies on it.
  void sync();
  /// Bytes that wait.
  [[nodiscard]] std::size_t n_waiting() const;

 private:
  CsvTable history_;
  CsvTable energy_;
  std::optional<CsvTable> transient_;
  CrackRecord cracks_;
  FieldOutput fields_;
};

}  // namespace ligament
