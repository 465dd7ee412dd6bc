#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/constitutive_law.hpp"
#include "core/generator.hpp"
#include "core/integrator.hpp"
#include "core/model.hpp"
#include "core/parameters.hpp"
#include "io/case_table.hpp"
#include "mesh/beam_properties.hpp"
#include "simulation.hpp"

/// The tables of a case file: what each may hold, bound to the members that take it.
namespace ligament {

/// What a case is: a structure under the loads it lists, or a test that sets its own.
enum class CaseKind { structure, assembly_properties, uniaxial };

struct ProblemTable {
  CaseKind kind = CaseKind::structure;
  PlaneState plane = PlaneState::stress;
  double thickness = 0.0;
  std::array<double, 2> gravity{};

  void declare(Parameters& parameters);
};

struct MaterialTable {
  std::string name;
  double young_modulus = 0.0;
  double poisson_ratio = 0.0;
  std::optional<double> density;
  StiffnessFormula stiffness = StiffnessFormula::plane;
  ContactLength contact_length = ContactLength::centre_distance;
  std::shared_ptr<ConstitutiveLaw> law;

  void declare(Parameters& parameters);
};

struct MeshTable {
  std::vector<double> x;
  std::vector<double> y;
  std::string material;

  void declare(Parameters& parameters);
};

struct ContactTableOfCase {
  std::optional<double> skin;

  void declare(Parameters& parameters);
};

struct GenerationTable {
  std::int64_t seed = 1;

  void declare(Parameters& parameters);
};

struct ZoneTable {
  std::string name;
  std::array<double, 2> from{};
  std::array<double, 2> to{};
  std::string material;
  std::optional<std::string> interface_material;
  std::optional<double> detection_gap;
  std::optional<double> interface_gap;
  std::string generator_name;
  std::unique_ptr<Generator> generator;

  void declare(Parameters& parameters);
};

struct NotchTable {
  std::string name;
  std::array<double, 2> from{};
  std::array<double, 2> to{};
  double width = 0.0;
  double gap = 0.0;

  void declare(Parameters& parameters);
};

/// How a wall holds the particles that touch it at set-up: by contact alone, or along its normal in tension as well.
enum class WallContact { frictional, tied };
/// Whether motions say how a wall moves, or the forces on it.
enum class WallDrive { motion, force };

struct BeamTable {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;
  std::string material;
  double depth = 0.0;
  double width = 0.0;
  BeamTheory theory = BeamTheory::timoshenko;

  void declare(Parameters& parameters);
};

struct WallTable {
  std::string name;
  std::array<double, 2> from{};
  std::array<double, 2> to{};
  WallContact contact = WallContact::frictional;
  double friction_coefficient = 0.0;
  WallDrive driven_by = WallDrive::motion;
  std::optional<std::string> beam;
  std::optional<double> mass;

  void declare(Parameters& parameters);
};

/// Which bodies a support, motion or load concerns.
struct BodySelection {
  std::optional<double> x;
  std::optional<double> y;
  std::vector<std::int64_t> nodes;
  std::vector<std::int64_t> particles;
  std::optional<std::string> beam;  ///< to whose nodes the above then belong
  std::vector<std::string> walls;

  void declare(Parameters& parameters);
};

struct SupportTable {
  std::string name;
  BodySelection bodies;
  std::vector<std::string> fix;

  void declare(Parameters& parameters);
};

/// Displacements at times, with straight lines between them.
struct MotionSchedule {
  bool is_given = false;
  std::vector<double> time;
  std::vector<double> displacement;

  void declare(Parameters& parameters);
};

/// Shares of a force at times, likewise.
struct LoadSchedule {
  bool is_given = false;
  std::vector<double> time;
  std::vector<double> share;

  void declare(Parameters& parameters);
};

struct MotionTable {
  std::string name;
  BodySelection bodies;
  std::string direction;
  std::optional<double> velocity;
  std::optional<double> displacement;
  MotionSchedule schedule;
  double rise_time = 0.0;
  std::optional<double> stop_time;
  std::int64_t stage = 1;

  void declare(Parameters& parameters);
};

struct LoadTable {
  std::string name;
  BodySelection bodies;
  std::array<double, 2> force{};
  LoadSchedule schedule;
  double rise_time = 0.0;
  std::int64_t stage = 1;

  void declare(Parameters& parameters);
};

/// One body, a place, a wall, or the bodies of supports, and an axis.
struct GaugePoint {
  bool is_given = false;
  std::optional<std::array<double, 2>> point;  ///< displacements alone
  std::vector<std::string> relative_to;        ///< names of supports; displacements alone
  std::optional<std::int64_t> node;
  std::optional<std::int64_t> particle;
  std::optional<std::string> beam;
  std::optional<std::string> wall;
  std::vector<std::string> supports;
  std::string direction;

  void declare(Parameters& parameters);
  void declare_displacement(Parameters& parameters);
};

/// Two places, and an axis.
struct GaugePair {
  bool is_given = false;
  std::array<double, 2> from{};
  std::array<double, 2> to{};
  std::string direction;
  double foot = 0.0;  ///< diameter (m)

  void declare(Parameters& parameters);
};

/// A component of a mean over the particles of a rectangle.
struct GaugeRegion {
  bool is_given = false;
  std::array<double, 2> from{};
  std::array<double, 2> to{};
  std::string component;

  void declare(Parameters& parameters);
};

struct GaugeTable {
  std::string name;
  GaugePoint displacement;
  GaugePoint reaction;
  GaugePair opening;
  GaugeRegion stress;
  GaugeRegion strain;
  double factor = 1.0;

  void declare(Parameters& parameters);
};

/// How assembly properties are measured.
struct PropertiesTable {
  double strain = 1e-5;
  double loading_time = 200.0;
  double margin = 0.15;

  void declare(Parameters& parameters);
};

struct SolverTable {
  TimeStepChoice time_step;
  std::optional<double> unbalanced_force_ratio;
  std::int64_t max_steps = 0;
  std::int64_t check_every = 10;
  std::string method;
  /// One of the two, by the method.
  std::unique_ptr<Integrator> integrator;
  std::unique_ptr<IncrementalLoading> loading;

  void declare(Parameters& parameters);
};

/// A gauge that ends the run before its loading does.
struct GaugeLimit {
  std::optional<double> drop_to_share;
  std::optional<double> above;
  std::optional<double> below;

  void declare(Parameters& parameters);
};

struct LimitTable {
  std::string name;
  std::string gauge;
  GaugeLimit limit;

  void declare(Parameters& parameters);
};

/// When a run ends before its loading does.
struct StopTable {
  std::optional<std::string> gauge;
  GaugeLimit limit;
  std::optional<double> cut_off_share;
  std::optional<double> crack_span;

  void declare(Parameters& parameters);
};

/// Which gauges of a uniaxial test tell of its results.
struct UniaxialTable {
  std::string load = "load";
  std::string elongation = "elongation";

  void declare(Parameters& parameters);
};

/// What a run does when results or a checkpoint cannot be written.
enum class OnFailedWrite { go_on, stop };

struct OutputTable {
  std::int64_t every = 100;
  std::optional<std::int64_t> fields_every;
  std::optional<std::int64_t> transient_every;
  OnFailedWrite on_failed_write = OnFailedWrite::go_on;

  void declare(Parameters& parameters);
};

struct CheckpointTable {
  std::int64_t every = 1000;
  std::int64_t keep = 3;
  std::optional<std::string> folder;

  void declare(Parameters& parameters);
};

struct AuditTable {
  double tolerance = 1e-6;
  bool every_step = false;

  void declare(Parameters& parameters);
};

}  // namespace ligament
