#include "run/results.hpp"

#include <string>

#include "core/error.hpp"

namespace ligament {
namespace {

std::vector<std::string> history_columns(const BuiltSimulation& built) {
  std::vector<std::string> columns{"time_s"};
  for (const Gauge& gauge : built.gauges) columns.push_back(gauge.column);
  for (const char* name : {"n_broken", "unbalanced_force_ratio", "energy_error"}) columns.emplace_back(name);
  return columns;
}

std::vector<std::string> transient_columns(const BuiltSimulation& built) {
  std::vector<std::string> columns{"evaluation", "time_s"};
  for (const Gauge& gauge : built.gauges) columns.push_back(gauge.column);
  for (const char* name : {"unbalanced_force_ratio", "kinetic_energy_J"}) columns.emplace_back(name);
  return columns;
}

std::vector<std::string> energy_columns(const BuiltSimulation& built) {
  std::vector<std::string> columns{"time_s"};
  for (const EnergyTerm& term : built.simulation.energies()) columns.push_back(term.name + "_J");
  columns.emplace_back("defect_J");
  columns.emplace_back("error");
  return columns;
}

}  // namespace

Results::Results(const RunDirectory& directory, BuiltSimulation& built, bool has_transients)
    : history_(CsvTable::create(directory.file("history.csv"), history_columns(built))),
      energy_(CsvTable::create(directory.file("energy.csv"), energy_columns(built))),
      cracks_(directory.file("cracks.csv"), built.simulation),
      fields_(directory.file("fields")) {
  if (has_transients) {
    transient_.emplace(CsvTable::create(directory.file("transient.csv"), transient_columns(built)));
  }
  fields_.resume(-1);
}

Results::Results(const RunDirectory& directory, const BuiltSimulation& built, bool has_transients,
                 std::int64_t resumed_step)
    : history_(CsvTable::resume(directory.file("history.csv"), history_columns(built), resumed_step)),
      energy_(CsvTable::resume(directory.file("energy.csv"), energy_columns(built), resumed_step)),
      cracks_(directory.file("cracks.csv"), built.simulation, resumed_step),
      fields_(directory.file("fields")) {
  if (has_transients) {
    transient_.emplace(CsvTable::resume(directory.file("transient.csv"), transient_columns(built), resumed_step));
  }
  fields_.resume(resumed_step);
}

HistoryRow Results::add_row(BuiltSimulation& built) {
  Simulation& simulation = built.simulation;
  const Clock& clock = simulation.state().clock;
  HistoryRow row{.step = clock.step, .time = clock.time};
  for (const Gauge& gauge : built.gauges) row.gauges.push_back(gauge.value(simulation.model(), simulation.state()));
  row.n_broken = simulation.state().cracks.n_broken();
  row.unbalanced_force_ratio = simulation.unbalance().ratio();
  row.energy_error = simulation.audit();

  std::vector<double> history{row.time};
  history.insert(history.end(), row.gauges.begin(), row.gauges.end());
  history.insert(history.end(), {static_cast<double>(row.n_broken), row.unbalanced_force_ratio, row.energy_error});
  history_.append(row.step, history);

  std::vector<double> energy{row.time};
  EnergyBalance balance;
  for (const EnergyTerm& term : simulation.energies()) {
    energy.push_back(term.value);
    balance.add(term);
  }
  energy.insert(energy.end(), {balance.defect(), row.energy_error});
  energy_.append(row.step, energy);
  return row;
}

void Results::add_transient_row(const BuiltSimulation& built, std::int64_t evaluation, double kinetic_energy) {
  const Simulation& simulation = built.simulation;
  const Clock& clock = simulation.state().clock;
  std::vector<double> row{static_cast<double>(evaluation), clock.time};
  for (const Gauge& gauge : built.gauges) row.push_back(gauge.value(simulation.model(), simulation.state()));
  row.insert(row.end(), {simulation.unbalance().ratio(), kinetic_energy});
  // The clock counts equilibria: this is on the way to the next one.
  transient_->append(clock.step + 1, row);
}

void Results::flush() {
  std::optional<FileError> first_error;
  const auto try_to = [&](auto& file) {
    try {
      file.flush();
    } catch (const FileError& error) {
      if (!first_error) first_error = error;
    }
  };
  try_to(history_);
  if (transient_) try_to(*transient_);
  try_to(energy_);
  try_to(cracks_.table());
  try_to(fields_);
  if (first_error) throw FileError(*first_error);
}

void Results::sync() {
  flush();
  history_.sync();
  if (transient_) transient_->sync();
  energy_.sync();
  cracks_.table().sync();
}

std::size_t Results::n_waiting() const {
  const std::size_t n_transient = transient_ ? transient_->n_waiting() : 0;
  return history_.n_waiting() + n_transient + energy_.n_waiting() + cracks_.table().n_waiting() + fields_.n_waiting();
}

}  // namespace ligament
