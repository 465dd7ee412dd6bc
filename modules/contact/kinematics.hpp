#pragma once

#include "core/turn.hpp"
#include "core/vector.hpp"

/// Relative motion of two bodies at their contact, in total form: openings come from displacements, never from
/// differences of positions, and slips from the exact turn of the contact plane, so that rigid motion, however large,
/// makes none.
namespace ligament {

/// Where the force of a contact acts.
struct ContactGeometry {
  Vector normal;            ///< n(n), from the first body to the second
  double arm_first = 0.0;   ///< r_A from the centre of the first body to the contact point, along n (m)
  double arm_second = 0.0;  ///< r_B from the centre of the second body, against n (m)
  double share = 0.0;       ///< N_j, share of the second node of a facet; N_i = 1 - N_j
};

struct ContactMotion {
  ContactGeometry geometry;
  double opening = 0.0;              ///< u_n(n), from the reference distance (m)
  ShearVector slip_increment = 0.0;  ///< Δu_s of the second body against the first, along tangent(n) (m)
};

/// What the contact remembers of its distance.
struct ContactReference {
  double rest_distance = 0.0;     ///< of the bodies at rest (m)
  double initial_gap = 0.0;       ///< rest distance less reference distance (m)
  double previous_opening = 0.0;  ///< u_n(n-1) (m)

  [[nodiscard]] double previous_distance() const { return rest_distance + (previous_opening - initial_gap); }
};

/// The line between two points A and B.
struct PointPairMotion {
  Vector rest;          ///< B - A at rest (m)
  Vector displacement;  ///< of B less that of A at n (m)
  Vector increment;     ///< of that from n-1 to n (m)
};

/// Sine and cosine of the turn of that line from n-1 to n, up to a common factor.
struct LineTurn {
  double sine = 0.0;
  double cosine = 0.0;
};

inline LineTurn line_turn(const PointPairMotion& pair) {
  const Vector line = pair.rest + pair.displacement;
  return {cross(line, pair.increment), dot(line, line - pair.increment)};
}

/// What two discs have besides the line between their centres.
struct DiscPair {
  Rotation turn_first = 0.0;       ///< Δθ_A from n-1 to n (rad)
  Rotation turn_second = 0.0;      ///< Δθ_B
  double radius_difference = 0.0;  ///< R_A - R_B (m)
};

/// Two discs whose line of centres turns by this angle, contact point at the middle of their overlap or gap.
inline ContactMotion particle_pair_motion(const PointPairMotion& pair, const ContactReference& reference,
                                          const DiscPair& discs, double turn) {
  const Vector line = pair.rest + pair.displacement;
  const double distance = norm(line);
  const double previous = reference.previous_distance();
  // Divisions take longer than all else here: one for both quotients.
  const double distances = distance + reference.rest_distance;
  const double inverse = 1.0 / (distance * distances);
  const double stretch = (inverse * distance) * dot(2.0 * pair.rest + pair.displacement, pair.displacement);
  const double mean_distance = 0.5 * (distance + previous);
  const double mean_arm_first = 0.5 * (mean_distance + discs.radius_difference);
  const double mean_arm_second = 0.5 * (mean_distance - discs.radius_difference);
  ContactMotion motion;
  motion.geometry.normal = (inverse * distances) * line;
  motion.geometry.arm_first = 0.5 * (distance + discs.radius_difference);
  motion.geometry.arm_second = 0.5 * (distance - discs.radius_difference);
  motion.opening = stretch + reference.initial_gap;
  motion.slip_increment =
      mean_distance * turn - (mean_arm_first * discs.turn_first + mean_arm_second * discs.turn_second);
  return motion;
}

inline ContactMotion particle_pair_motion(const PointPairMotion& pair, const ContactReference& reference,
                                          const DiscPair& discs) {
  const LineTurn turn = line_turn(pair);
  return particle_pair_motion(pair, reference, discs, turn_angle(turn.sine, turn.cosine));
}

/// A disc and a node: the contact point is the node, which does not turn.
inline ContactMotion corner_motion(const PointPairMotion& pair, const ContactReference& reference,
                                   Rotation turn_first) {
  // A disc against a disc of no size: the arm of the first is the whole distance.
  const double distance = norm(pair.rest + pair.displacement);
  ContactMotion motion = particle_pair_motion(pair, reference, {});
  motion.slip_increment -= 0.5 * (distance + reference.previous_distance()) * turn_first;
  motion.geometry.arm_first = distance;
  motion.geometry.arm_second = 0.0;
  return motion;
}

/// A facet i→j and the centre A of a disc on its right.
struct FacetMotion {
  Vector rest_edge;          ///< j - i at rest (m)
  Vector edge_displacement;  ///< of j less that of i (m)
  Vector edge_increment;     ///< of that from n-1 to n (m)
  Vector rest_centre;        ///< A - i at rest (m)
  Vector centre_displacement;
  Vector centre_increment;
};

/// A disc and a facet: the contact point is the projection of the centre on the edge and moves as the edge does there,
/// v_C = N_i v_i + N_j v_j. Both bodies feel the force at that point, so that momentum and angular momentum balance.
inline ContactMotion facet_motion(const FacetMotion& facet, const ContactReference& reference, Rotation turn_first) {
  const Vector edge = facet.rest_edge + facet.edge_displacement;
  const Vector previous_edge = edge - facet.edge_increment;
  const Vector centre = facet.rest_centre + facet.centre_displacement;
  const double rest_length = norm(facet.rest_edge);
  const double length = norm(edge);
  const double previous_length = norm(previous_edge);
  const Vector axial = edge / length;
  const Vector normal = tangent(axial);

  // Distance h = -axial × centre, less its value at rest, without cancellation.
  const double elongation =
      dot(2.0 * facet.rest_edge + facet.edge_displacement, facet.edge_displacement) / (length + rest_length);
  const double area_change = -(cross(facet.rest_edge, facet.centre_displacement) +
                               cross(facet.edge_displacement, facet.rest_centre + facet.centre_displacement));
  const double stretch = (area_change - reference.rest_distance * elongation) / length;
  const double distance = -cross(axial, centre);
  const double previous = reference.previous_distance();

  const double sine = cross(edge, facet.edge_increment) / (length * previous_length);
  const double cosine = dot(edge, previous_edge) / (length * previous_length);
  const double turn = turn_angle(sine, cosine);

  const double position = dot(axial, centre);
  const double previous_position = dot(previous_edge, centre - facet.centre_increment) / previous_length;
  const double share = position / length;
  const double mean_share = 0.5 * (share + previous_position / previous_length);
  const double mean_distance = 0.5 * (distance + previous);
  // 1 - cos without cancellation.
  const double versine = cosine > 0.0 ? sine * sine / (1.0 + cosine) : 1.0 - cosine;
  const double advance = dot(facet.centre_increment, axial) - previous_position * versine - previous * sine;
  const double length_increment = dot(facet.edge_increment, edge + previous_edge) / (length + previous_length);

  ContactMotion motion;
  motion.geometry.normal = normal;
  motion.geometry.arm_first = distance;
  motion.geometry.share = share;
  motion.opening = stretch + reference.initial_gap;
  // tangent(n) = -axial: a centre that advances along the edge leaves the edge behind.
  motion.slip_increment = advance - mean_share * length_increment + mean_distance * (turn - turn_first);
  return motion;
}

}  // namespace ligament
