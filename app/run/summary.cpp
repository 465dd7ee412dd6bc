#include "run/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "case/assembly_properties.hpp"
#include "core/parallel.hpp"
#include "core/state_hash.hpp"
#include "io/atomic_file.hpp"
#include "io/csv_table.hpp"
#include "run/crack_record.hpp"
#include "run/external_forces.hpp"
#include "run/macro_crack.hpp"
#include "run/run_report.hpp"
#include "run/uniaxial_results.hpp"
#include "version.hpp"

namespace ligament {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(Ending ending) {
  switch (ending) {
    case Ending::converged:
      return "converged";
    case Ending::completed:
      return "completed";
    case Ending::stopped:
      return "stopped";
    case Ending::interrupted:
    case Ending::terminated:
      return "interrupted";
    case Ending::not_converged:
      return "not_converged";
    case Ending::diverged:
      return "diverged";
  }
  return "";
}

double largest_error(const BuiltSimulation& built, const RunSummary& summary) {
  return std::max({built.simulation.state().ledger.largest_error, summary.motion_error.value_or(0.0),
                   summary.transfer_error.value_or(0.0)});
}

Json packings(const BuiltSimulation& built) {
  Json zones = Json::object();
  for (const auto& [zone, entries] : built.reports) {
    for (const ReportEntry& entry : entries) {
      const bool is_count = entry.name.starts_with("n_");
      zones[zone][entry.name] = is_count ? Json(static_cast<std::int64_t>(entry.value)) : Json(entry.value);
    }
  }
  return zones;
}

/// The largest of all increments; else of the only state of equilibrium there is, the last one, and null if the run has
/// found none.
Json force_mismatch(const BuiltSimulation& built, Ending ending) {
  if (built.simulation.is_quasi_static()) return built.simulation.state().stage.force_mismatch;
  if (ending != Ending::converged) return nullptr;
  const auto mismatch = external_forces(built.simulation, built.freedoms).mismatch();
  return mismatch ? Json(*mismatch) : Json(nullptr);
}

/// The largest reading of the gauge of the load, where there is one.
std::optional<double> peak_load(const BuiltSimulation& built) {
  for (std::size_t i = 0; i < built.gauges.size(); ++i) {
    if (built.gauges[i].column == "load_N") return built.simulation.state().stage.peaks[i];
  }
  return std::nullopt;
}

void add_properties(const std::string& prefix, const AssemblyProperties& properties, Json& values) {
  values[prefix + "young_modulus_x_Pa"] = properties.young_modulus_x;
  values[prefix + "poisson_ratio_x"] = properties.poisson_ratio_x;
  values[prefix + "young_modulus_y_Pa"] = properties.young_modulus_y;
  values[prefix + "poisson_ratio_y"] = properties.poisson_ratio_y;
}

/// What a uniaxial test has measured so far, by the rows of history.csv; nothing before the load has risen.
void add_uniaxial(const BuiltSimulation& built, const RunDirectory& directory, Json& values) {
  const UniaxialTest& test = *built.uniaxial;
  const CsvContent history = read_csv(directory.file("history.csv"));
  const std::vector<double> loads = history.numbers(built.gauges[test.load].column);
  if (!(*std::max_element(loads.begin(), loads.end()) > 0.0)) return;
  const UniaxialResults results = uniaxial_results(test, loads, history.numbers(built.gauges[test.elongation].column));
  double dissipated = 0.0;
  for (const EnergyTerm& term : built.simulation.energies()) {
    if (term.name.starts_with("fracture_") || term.name == "friction") dissipated += term.value;
  }
  values["strength_Pa"] = results.strength;
  values[test.axis == 0 ? "young_modulus_x_Pa" : "young_modulus_y_Pa"] = results.young_modulus;
  values["fracture_energy_N_per_m"] = results.fracture_energy;
  values["dissipated_energy_N_per_m"] = dissipated / test.area;
}

/// The values of the gauges at the end, and what the kind of case asks for once it is complete.
Json results(const Case& input, const BuiltSimulation& built, const RunDirectory& directory, Ending ending) {
  Json values = Json::object();
  const State& state = built.simulation.state();
  std::vector<double> readings = state.stage.readings;
  std::size_t row = (state.stage.number - 1) * built.gauges.size();
  for (const Gauge& gauge : built.gauges) {
    values[gauge.column] = readings[row++] = gauge.value(built.simulation.model(), state);
  }
  if (input.problem.kind == CaseKind::assembly_properties && ending == Ending::converged) {
    add_properties("", wall_properties(input, readings), values);
    add_properties("region_", region_properties(readings), values);
  }
  if (built.uniaxial) add_uniaxial(built, directory, values);
  return values;
}

/// The macro-crack in numbers; its path goes to crack_path.csv.
Json crack_of(const MacroCrack& crack, const RunDirectory& directory) {
  write_atomically(directory.file("crack_path.csv"), path_table(crack));
  const auto point = [](const Vector& place) { return Json::array({component(place, 0), component(place, 1)}); };
  return {{"length_m", crack.length},
          {"tortuosity", crack.tortuosity},
          {"damaged_width_m", crack.damaged_width},
          {"from", point(crack.path.front())},
          {"to", point(crack.path.back())}};
}

}  // namespace

bool write_summary(const Case& input, const BuiltSimulation& built, const RunDirectory& directory,
                   const RunSummary& summary) {
  const Simulation& simulation = built.simulation;
  const ModelSizes sizes = model_sizes(simulation.model());
  const Unbalance unbalance = simulation.unbalance();
  const double error = largest_error(built, summary);
  // An error that is not a number has not passed.
  const bool passed = error <= input.audit.tolerance && summary.ending != Ending::diverged;
  Json json{{"version", program_version()},
            {"case", directory.case_name()},
            {"case_hash", case_hash(input)},
            {"ended", name_of(summary.ending)},
            {"ended_by", summary.reached.empty() ? Json(nullptr) : Json(summary.reached)},
            {"steps", simulation.state().clock.step},
            {"wall_time_s", summary.wall_time},
            {"threads", threads().count},
            {"n_particles", sizes.n_particles},
            {"n_contacts", sizes.n_contacts},
            {"n_edge_contacts", sizes.n_edge_contacts},
            {"n_wall_contacts", sizes.n_wall_contacts},
            {"n_elements", sizes.n_elements},
            {"n_broken", simulation.state().cracks.n_broken()},
            {"n_broken_tension", simulation.state().cracks.n_tension},
            {"n_broken_shear", simulation.state().cracks.n_shear},
            {"unbalanced_force_ratio", unbalance.ratio()},
            {"largest_resultant_N", unbalance.largest_resultant},
            {"mean_force_N", unbalance.mean_force},
            {"energy_error", error},
            {"audit_tolerance", input.audit.tolerance},
            {"audit", passed ? "passed" : "failed"},
            {"final_state_hash", state_hash(simulation.state())},
            {"force_mismatch_max", force_mismatch(built, summary.ending)}};
  if (simulation.is_quasi_static()) {
    json["n_evaluations"] = simulation.state().loading.n_evaluations;
    json["n_factorisations"] = simulation.state().loading.n_factorisations;
    json["n_relaxed_increments"] = simulation.state().loading.n_relaxed;
    json["n_increments_without_control"] = simulation.state().loading.n_without_control;
  }
  if (const auto peak = peak_load(built)) json["peak_load_N"] = *peak;
  if (summary.motion_error) json["motion_error"] = *summary.motion_error;
  if (summary.transfer_error) json["transfer_error"] = *summary.transfer_error;
  if (!summary.divergence.empty()) json["divergence"] = summary.divergence;
  if (!built.reports.empty()) json["packing"] = packings(built);
  const auto planes = planes_so_far(directory.file("cracks.csv"), simulation);
  if (const auto crack = find_macro_crack(planes)) json["crack"] = crack_of(*crack, directory);
  json["results"] = results(input, built, directory, summary.ending);
  write_atomically(directory.file("summary.json"), json.dump(2) + "\n");
  return passed;
}

std::string describe_ending(const Case& input, const BuiltSimulation& built, const RunSummary& summary,
                            bool audit_passed) {
  const std::string reason = summary.reached.empty() ? "" : fmt::format(" ({})", summary.reached);
  return fmt::format("{} at step {}{} after {:.2f} s; energy audit {} (error {:.2g}, tolerance {:.2g})",
                     name_of(summary.ending), built.simulation.state().clock.step, reason, summary.wall_time,
                     audit_passed ? "passed" : "failed", largest_error(built, summary), input.audit.tolerance);
}

}  // namespace ligament
