#pragma once

#include <cstdint>
#include <string>

#include "core/constitutive_law.hpp"
#include "core/energy_ledger.hpp"
#include "core/vector.hpp"

/// Everything that changes during a run, as plain data. All of it belongs to one time n: positions and forces at n,
/// velocities on both sides of it.
namespace ligament {

/// Steps decide schedules; time is derived. Under mass scaling time is a pseudo-time.
struct Clock {
  std::int64_t step = 0;
  double time = 0.0;              ///< t(n) (s)
  double time_step = 1.0;         ///< Δt from n to n+1 (s)
  double time_step_before = 1.0;  ///< Δt from n-1 to n (s)

  /// Goes from n to n+1.
  void advance() {
    ++step;
    time += time_step;
    time_step_before = time_step;
  }
  /// The time over which the acceleration of n acts: from n-½ to n+½ (s).
  [[nodiscard]] double acceleration_time() const { return 0.5 * (time_step_before + time_step); }
};

/// Translation of a table of bodies (particles or nodes).
struct TranslationState {
  Field<Vector> displacement;     ///< u(n) from the position at rest (m)
  Field<Vector> increment;        ///< u(n) less its value when contacts last stored their state (m)
  Field<Vector> velocity_before;  ///< v(n-½) (m/s)
  Field<Vector> velocity;         ///< v(n+½) (m/s)
  Field<Vector> force;            ///< resultant at n without damping and reactions (N)
  Field<double> mass;             ///< real or scaled (kg)
};

/// Rotation of a table of bodies.
struct RotationState {
  Field<Rotation> rotation;   ///< θ(n) (rad)
  Field<Rotation> increment;  ///< see TranslationState::increment (rad)
  Field<Spin> spin_before;    ///< ω(n-½) (rad/s)
  Field<Spin> spin;           ///< ω(n+½) (rad/s)
  Field<Moment> moment;       ///< at n (N m)
  Field<double> inertia;      ///< real or scaled (kg m2)
};

/// Bodies that move and turn.
struct TurningState {
  TranslationState translation;
  RotationState rotation;
};
using ParticleState = TurningState;
using BeamNodeState = TurningState;

struct NodeState {
  TranslationState translation;
};

/// What passes through platens.
struct PlatenState {
  Field<Vector> force;  ///< on both ends of every platen at n, handed on to its middle (N)
};

/// One array of history for the contacts of one law, in their order.
struct HistoryColumn {
  std::string name;  ///< "<law>.<variable>"
  double initial_value = 0.0;
  Field<double> values;
};

/// Contacts of one kind, sorted by (law, first, second): the contacts of a law are one contiguous range.
/// `first` is a particle; `second` a particle, a facet or a node. Of seats `first` is a node, `second` a facet.
struct ContactTable {
  Field<Index> law;     ///< row of Model::laws
  Field<Index> first;   ///< A, "U1"
  Field<Index> second;  ///< B, "U2"
  // Constant while the contact lives.
  Field<double> rest_distance;  ///< distance of the bodies at rest (m)
  Field<double>
      initial_gap;  ///< rest distance less the reference distance d_ref (m); of pairs of set-up that of a notch
  Field<double> normal_stiffness;  ///< k_n (N/m)
  Field<double> shear_stiffness;   ///< k_s (N/m)
  Field<double> area;              ///< A = H t (m2)
  // What the contact remembers.
  Field<double> opening;                  ///< u_n (m)
  Field<ShearVector> shear_displacement;  ///< Σ Δu_s (m)
  Field<double> normal_force;             ///< F_n (N), > 0 in compression
  Field<ShearVector> shear_force;         ///< F_s (N)
  Field<BondState> bond;
  /// First row of each law's range; one entry more than laws.
  Field<Index> law_begin;
  /// History arrays of all laws, law by law; a column has as many rows as its law has contacts.
  std::vector<HistoryColumn> history;

  [[nodiscard]] std::size_t size() const { return first.size(); }
};

/// What the search must remember between its updates.
struct SearchState {
  Field<Vector> particle_displacement;  ///< at the last update (m)
  Field<Vector> node_displacement;
  std::int64_t n_updates = 0;
};

/// Loading comes in stages, each carried to equilibrium before the next one begins.
struct StageState {
  std::int64_t number = 1;      ///< of the stage under way
  std::int64_t begin_step = 0;  ///< n at which it began
  double begin_time = 0.0;      ///< t at which it began (s)
  Field<double> readings;       ///< of all gauges at the ends of the stages before, stage by stage
  Field<double> peaks;          ///< largest reading of every gauge so far
  double force_mismatch =
      0.0;  ///< largest so far in an increment: what external forces lacked, over their peak by then
};

/// How many bonds have broken since the start, also where nothing else tells of them any more: a broken contact whose
/// bodies have moved apart leaves its table.
struct CrackState {
  std::int64_t n_tension = 0;
  std::int64_t n_shear = 0;

  [[nodiscard]] std::int64_t n_broken() const { return n_tension + n_shear; }
};

/// What quasi-static loading in increments remembers.
struct LoadingState {
  double step = 0.0;            ///< the last increment, of pseudo-time (s) or of a gauge; 0 before the first
  double direction_step = 0.0;  ///< that of the increment whose motion is extrapolated (s)
  Field<double> direction;      ///< that motion, all freedoms in one column
  // After an increment that may have held a jump the motion with which it began, which may do better.
  double older_step = 0.0;
  Field<double> older_direction;
  double peak_force = 0.0;  ///< largest external force so far (N)
  double gauge_sign = 0.0;  ///< the way in which a gauge is followed in the stage under way; 0 before that
  // The stiffness matrix in use.
  Field<double> secants;               ///< of the springs of all contacts (N/m)
  Field<double> places;                ///< displacements of all freedoms for which it was made (m, rad)
  std::int64_t secants_update = 0;     ///< SearchState::n_updates of the contacts it is of
  std::int64_t n_evaluations = 0;      ///< of the forces, in all increments so far
  std::int64_t n_factorisations = 0;   ///< of stiffness matrices
  std::int64_t n_relaxed = 0;          ///< increments that a direct search left to relaxation
  std::int64_t n_without_control = 0;  ///< increments in which a gauge could not be followed
};

/// What adaptive damping remembers: the internal forces of the step before.
struct RelaxationState {
  double damping = 0.0;  ///< c of the step (1/s)
  Field<Vector> particle_force;
  Field<Moment> particle_moment;
  Field<Vector> node_force;
  Field<Vector> beam_force;
  Field<Moment> beam_moment;
  /// Of relaxation with two levels of masses: momenta p(n+½) and forces at n of all freedoms in one column.
  Field<double> momentum;
  Field<double> force;
};

struct State {
  Clock clock;
  ParticleState particles;
  NodeState nodes;
  BeamNodeState beam_nodes;
  PlatenState platens;
  ContactTable particle_contacts;
  ContactTable facet_contacts;
  ContactTable corner_contacts;
  ContactTable seat_contacts;  ///< nodes of elements that stand on walls
  SearchState search;
  StageState stage;
  RelaxationState relaxation;
  LoadingState loading;
  CrackState cracks;
  EnergyLedger ledger;
};

}  // namespace ligament
