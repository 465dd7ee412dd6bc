#pragma once

#include "build/build_conditions.hpp"
#include "build/build_model.hpp"
#include "build/stop_criterion.hpp"
#include "build/structure_pieces.hpp"
#include "build/uniaxial_test.hpp"
#include "case/case.hpp"
#include "gauge.hpp"
#include "simulation.hpp"

namespace ligament {

/// A case ready to run.
struct BuiltSimulation {
  Simulation simulation;
  std::vector<Gauge> gauges;
  std::vector<ZoneReport> reports;
  std::vector<PrescribedFreedom> freedoms;  ///< held and moved
  std::vector<double> end_of_loading;       ///< of every stage, the last of Conditions::corners (s)
  std::vector<StopCriterion> stops;
  std::optional<StructurePieces> pieces;  ///< where one that is cut off ends the run
  std::optional<UniaxialTest> uniaxial;
  std::vector<std::string> warnings;
};

/// The composition root: makes model, modules and gauges of a case. Only here are concrete classes named. Throws
/// InputError with all errors, each with its place in the case file.
BuiltSimulation build_simulation(Case& input);

}  // namespace ligament
