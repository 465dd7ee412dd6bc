#include "case/case_tables.hpp"

namespace ligament {
namespace {

void declare_stage(Parameters& parameters, std::int64_t& stage) {
  parameters
      .integer("stage", stage, "stage of loading it belongs to; a stage begins when the one before is in equilibrium")
      .at_least(1)
      .at_most(1000);
}

}  // namespace

void ProblemTable::declare(Parameters& parameters) {
  parameters.choice(
      "kind", kind,
      {{"structure", CaseKind::structure},
       {"assembly_properties", CaseKind::assembly_properties},
       {"uniaxial", CaseKind::uniaxial}},
      "'structure': what the tables say; 'assembly_properties': the one zone is put between frictionless "
      "walls and loaded along x, then along y, for its Young's moduli and Poisson's ratios; 'uniaxial': a "
      "structure that is a specimen, whose strength, Young's modulus and fracture energy are results");
  parameters.choice("plane", plane, {{"stress", PlaneState::stress}, {"strain", PlaneState::strain}},
                    "plane stress or plane strain");
  parameters.quantity("thickness", thickness, "m", "thickness t of the body").required().greater_than(0.0);
  parameters.point("gravity", gravity, "m/s2", "acceleration of gravity g; acts on the bodies' real masses");
}

void MaterialTable::declare(Parameters& parameters) {
  parameters.quantity("young_modulus", young_modulus, "Pa", "Young's modulus E").required().greater_than(0.0);
  parameters.number("poisson_ratio", poisson_ratio, "Poisson's ratio ν").required().greater_than(-1.0).less_than(0.5);
  parameters.quantity("density", density, "kg/m3", "density ρ; needed where masses are real or gravity acts")
      .greater_than(0.0);
  parameters.choice("stiffness", stiffness,
                    {{"plane", StiffnessFormula::plane}, {"hexagonal", StiffnessFormula::hexagonal}},
                    "how k_n and k_s of a contact follow from E and ν: 'plane', Eq. (33), for any assembly; "
                    "'hexagonal', Eq. (34), for hexagonal lattices, needs ν < 1/3 (plane strain: 1/4)");
  parameters.choice("contact_length", contact_length,
                    {{"centre_distance", ContactLength::centre_distance}, {"radius_sum", ContactLength::radius_sum}},
                    "length L in Eq. (33) of two particles: their distance at set-up, or the sum of their radii");
}

void MeshTable::declare(Parameters& parameters) {
  parameters.quantities("x", x, "m", "positions of the vertical grid lines, ascending").required().length_at_least(2);
  parameters.quantities("y", y, "m", "positions of the horizontal grid lines, ascending").required().length_at_least(2);
  parameters.text("material", material, "name of the material of the elements").required();
}

void ContactTableOfCase::declare(Parameters& parameters) {
  parameters
      .quantity(
          "skin", skin, "m",
          "pairs are listed while their gap is below the skin, lists are renewed when a body has moved by half of "
          "it; default a quarter of the smallest radius")
      .greater_than(0.0);
}

void GenerationTable::declare(Parameters& parameters) {
  parameters.integer("seed", seed, "seed of the random numbers of all generators").at_least(0);
}

void ZoneTable::declare(Parameters& parameters) {
  parameters.point("from", from, "m", "lower left corner of the rectangle filled with particles").required();
  parameters.point("to", to, "m", "upper right corner").required();
  parameters.text("material", material, "name of the material of the contacts between particles").required();
  parameters.text("interface_material", interface_material,
                  "name of the material of the contacts with elements; default that of the zone");
  parameters
      .number("detection_gap", detection_gap,
              "particles closer than this times the sum of their radii are bonded; default by the generator")
      .at_least(0.0);
  parameters
      .number("interface_gap", interface_gap,
              "particles closer to an element than this times their radius are bonded to it; default by the generator")
      .at_least(0.0);
}

void NotchTable::declare(Parameters& parameters) {
  parameters.point("from", from, "m", "one end of the notch").required();
  parameters.point("to", to, "m", "the other end").required();
  parameters
      .quantity("width", width, "m",
                "0: contacts that cross the notch lose their bond; more: particles with their centre in a slit of this "
                "width, and elements in it, are taken away as well")
      .at_least(0.0);
  parameters
      .quantity("gap", gap, "m",
                "by how much the faces stand apart: contacts that the notch cuts press only when this is closed; of a "
                "sawn notch its width, though no particle is taken away")
      .at_least(0.0);
}

void BeamTable::declare(Parameters& parameters) {
  parameters.quantities("x", x, "m", "positions of the nodes, from one end to the other").required().length_at_least(2);
  parameters.quantities("y", y, "m", "positions of the nodes, as many").required().length_at_least(2);
  parameters.text("material", material, "name of the material").required();
  parameters.quantity("depth", depth, "m", "height of the rectangular section, in the plane")
      .required()
      .greater_than(0.0);
  parameters.quantity("width", width, "m", "width of the section, across the plane").required().greater_than(0.0);
  parameters.choice(
      "theory", theory, {{"euler_bernoulli", BeamTheory::euler_bernoulli}, {"timoshenko", BeamTheory::timoshenko}},
      "'euler_bernoulli': sections stay normal to the axis; 'timoshenko': they shear, with 5/6 of their area");
}

void WallTable::declare(Parameters& parameters) {
  parameters.point("from", from, "m", "one end of the wall").required();
  parameters.point("to", to, "m", "the other end; particles are on one side of the wall").required();
  parameters.choice(
      "contact", contact, {{"frictional", WallContact::frictional}, {"tied", WallContact::tied}},
      "'frictional': presses and rubs; 'tied': particles that touch it at set-up are held along its normal "
      "in tension, too, and are free along it");
  parameters
      .number("friction_coefficient", friction_coefficient, "friction coefficient μ between wall and what it touches")
      .at_least(0.0);
  parameters.choice("driven_by", driven_by, {{"motion", WallDrive::motion}, {"force", WallDrive::force}},
                    "'motion': stands still unless a [[motion]] moves it; 'force': a platen, which moves and turns as "
                    "the forces on it ask, of what it touches, of loads and of a beam");
  parameters.text("beam", beam, "name of a beam with a node at the middle of the platen, which is hinged to it");
  parameters.quantity("mass", mass, "kg", "mass of the platen; needed where masses are real").greater_than(0.0);
}

void BodySelection::declare(Parameters& parameters) {
  Parameters& at = parameters.table("at", "all nodes on a line, or at a point");
  at.quantity("x", x, "m", "position of the nodes");
  at.quantity("y", y, "m", "position of the nodes");
  parameters.integers("nodes", nodes, "numbers of nodes in the full grid, row by row from the bottom left, from 1")
      .at_least(1);
  parameters.integers("particles", particles, "numbers of particles, from 1").at_least(1);
  parameters.text("beam", beam,
                  "name of a beam: 'nodes' then count its nodes, from 1, and 'at' finds them; alone: all");
  parameters.texts("walls", walls, "names of walls; in loads and supports those that are driven by force");
}

void SupportTable::declare(Parameters& parameters) {
  bodies.declare(parameters);
  parameters.texts("fix", fix, "what is held: 'x', 'y', and 'rotation' of particles, nodes of beams, platens")
      .required()
      .length_at_least(1)
      .one_of({"x", "y", "rotation"});
}

void MotionSchedule::declare(Parameters& parameters) {
  parameters.quantities("time", time, "s", "ascending from 0 s, the beginning of the stage").required();
  parameters
      .quantities("displacement", displacement, "m", "at each of the times, from where the stage began: 0 m at first")
      .required();
}

void LoadSchedule::declare(Parameters& parameters) {
  parameters.quantities("time", time, "s", "ascending from 0 s, the beginning of the stage").required();
  parameters.numbers("share", share, "share of the force that acts at each of the times").required();
}

void MotionTable::declare(Parameters& parameters) {
  bodies.declare(parameters);
  parameters.text("direction", direction, "axis of the prescribed motion").required().one_of({"x", "y"});
  parameters.quantity("velocity", velocity, "m/s", "prescribed velocity; or give 'displacement' or 'schedule'");
  parameters.quantity("displacement", displacement, "m", "displacement made until 'stop_time', instead of 'velocity'");
  schedule.declare(parameters.table("schedule", schedule.is_given,
                                    "displacements at times, with straight lines between them, instead of 'velocity'"));
  parameters.quantity("rise_time", rise_time, "s", "time within which the velocity rises linearly").at_least(0.0);
  parameters.quantity("stop_time", stop_time, "s", "time at which the motion stops, from the beginning of its stage")
      .at_least(0.0);
  declare_stage(parameters, stage);
}

void LoadTable::declare(Parameters& parameters) {
  bodies.declare(parameters);
  parameters.point("force", force, "N", "force on each of the bodies").required();
  parameters.quantity("rise_time", rise_time, "s", "time within which the force rises linearly; 0: suddenly")
      .at_least(0.0);
  schedule.declare(parameters.table("schedule", schedule.is_given,
                                    "shares of the force at times, with straight lines between them, instead of "
                                    "'rise_time'; the last one stays on"));
  declare_stage(parameters, stage);
}

void GaugePoint::declare(Parameters& parameters) {
  parameters.integer("node", node, "number of the node").at_least(1);
  parameters.integer("particle", particle, "number of the particle").at_least(1);
  parameters.text("beam", beam, "name of a beam, whose nodes 'node' then counts, from 1");
  parameters.text("wall", wall, "name of the wall");
  parameters.texts("supports", supports, "names of supports, whose reactions are summed up");
  parameters.text("direction", direction, "axis").required().one_of({"x", "y"});
}

void GaugePoint::declare_displacement(Parameters& parameters) {
  declare(parameters);
  parameters.point("point", point, "m",
                   "a place at set-up: of the element there, or of the particle that is nearest by its edge");
  parameters.texts("relative_to", relative_to, "names of supports, whose mean displacement is taken off");
}

void GaugePair::declare(Parameters& parameters) {
  parameters.point("from", from, "m", "place of the first body: the nearest one at set-up counts").required();
  parameters.point("to", to, "m", "place of the second body, likewise").required();
  parameters.text("direction", direction, "axis").required().one_of({"x", "y"});
  parameters
      .quantity(
          "foot", foot, "m",
          "each end moves with the particles nearer to it than to the other whose centres are in a circle of this "
          "diameter about it, as with one rigid body; 0: with the nearest body")
      .at_least(0.0);
}

void GaugeRegion::declare(Parameters& parameters) {
  parameters.point("from", from, "m", "lower left corner of the region").required();
  parameters.point("to", to, "m", "upper right corner").required();
  parameters.text("component", component, "component of the tensor").required().one_of({"xx", "yy", "xy"});
}

void GaugeTable::declare(Parameters& parameters) {
  displacement.declare_displacement(
      parameters.table("displacement", displacement.is_given, "displacement of a node, particle, place or wall (m)"));
  reaction.declare(parameters.table("reaction", reaction.is_given, "force that holds a supported or driven body (N)"));
  opening.declare(
      parameters.table("opening", opening.is_given, "displacement of a second body less that of a first one (m)"));
  stress.declare(parameters.table("stress", stress.is_given,
                                  "mean stress of the particles in a rectangle, tension positive (Pa)"));
  strain.declare(parameters.table("strain", strain.is_given,
                                  "mean strain of the particles in a rectangle, shear as half the angle (1)"));
  parameters.number("factor", factor, "what is measured is multiplied by this; -1 turns its sign");
}

void PropertiesTable::declare(Parameters& parameters) {
  parameters.number("strain", strain, "compression along either axis").greater_than(0.0).less_than(0.01);
  parameters.quantity("loading_time", loading_time, "s", "pseudo-time within which the strain is applied")
      .greater_than(0.0);
  parameters.number("margin", margin, "distance of the gauge region from the walls over the size of the zone")
      .at_least(0.0)
      .less_than(0.5);
}

void SolverTable::declare(Parameters& parameters) {
  parameters.choice("masses", time_step.masses, {{"scaled", Masses::scaled}, {"real", Masses::real}},
                    "masses scaled so that the time step is stable for every body (quasi-static runs; time is a "
                    "pseudo-time), or real ones (dynamics)");
  parameters.number("mass_safety", time_step.safety, "scaled masses over those of the stability bound").at_least(1.0);
  parameters.number("time_step_factor", time_step.factor, "time step over the critical one, real masses")
      .greater_than(0.0)
      .at_most(1.0);
  parameters
      .quantity("time_step", time_step.time_step, "s",
                "time step of scaled masses (pseudo-time), default 1 s; upper bound of the time step of real masses")
      .greater_than(0.0);
  parameters
      .number("unbalanced_force_ratio", unbalanced_force_ratio,
              "the run has converged when the largest resultant force over the mean contact force is below this; "
              "without it the run goes on to max_steps")
      .greater_than(0.0);
  parameters.integer("max_steps", max_steps, "the run ends at this step at the latest").required().at_least(1);
  parameters.integer("check_every", check_every, "steps between two checks of convergence").at_least(1);
}

void GaugeLimit::declare(Parameters& parameters) {
  parameters
      .number("drop_to_share", drop_to_share,
              "the run ends when the gauge has fallen to this share of its largest value")
      .greater_than(0.0)
      .less_than(1.0);
  parameters.number("above", above, "the run ends when the gauge is above this, in its SI unit");
  parameters.number("below", below, "the run ends when the gauge is below this, in its SI unit");
}

void LimitTable::declare(Parameters& parameters) {
  parameters.text("gauge", gauge, "name of the gauge that is watched").required();
  limit.declare(parameters);
}

void StopTable::declare(Parameters& parameters) {
  parameters.text("gauge", gauge, "name of a gauge that is watched; [[limit]] watches more");
  limit.declare(parameters);
  parameters
      .number(
          "cut_off_share", cut_off_share,
          "the run ends when broken bonds have cut off a piece with more than this share of the area of the structure")
      .greater_than(0.0)
      .less_than(0.5);
  parameters
      .quantity("crack_span", crack_span, "m",
                "the run ends when the ends of the macro-crack are further apart than this: when it has run through a "
                "section of this width")
      .greater_than(0.0);
}

void UniaxialTable::declare(Parameters& parameters) {
  parameters.text("load", load, "name of the gauge of the load, a reaction along the axis of the specimen");
  parameters.text("elongation", elongation,
                  "name of the gauge of the elongation; the area below load over elongation is the fracture energy");
}

void OutputTable::declare(Parameters& parameters) {
  parameters.integer("every", every, "steps between two rows of history.csv and energy.csv").at_least(1);
  parameters
      .integer("fields_every", fields_every,
               "steps between two field outputs; without it only the first and the last state are written")
      .at_least(1);
  parameters
      .integer(
          "transient_every", transient_every,
          "evaluations of the forces between two rows of transient.csv, which shows what happens from one state of "
          "equilibrium to the next; without it there is no such file")
      .at_least(1);
  parameters.choice("on_failed_write", on_failed_write,
                    {{"go_on", OnFailedWrite::go_on}, {"stop", OnFailedWrite::stop}},
                    "what is done when results or a checkpoint cannot be written: 'go_on': warn, keep the results in "
                    "memory and try again with the next ones; 'stop': end the run (exit 5)");
}

void CheckpointTable::declare(Parameters& parameters) {
  parameters.integer("every", every, "steps between two checkpoints").at_least(1);
  parameters.integer("keep", keep, "number of checkpoints that are kept").at_least(1).at_most(1000);
  parameters.text("folder", folder,
                  "where the checkpoints go, relative to the case file; default checkpoints/ in the working directory");
}

void AuditTable::declare(Parameters& parameters) {
  parameters.number("tolerance", tolerance, "largest error of the energy ledger, over the largest energy so far")
      .greater_than(0.0);
  parameters.boolean("every_step", every_step,
                     "check motion and transfer of energy and all numbers at every step (always on in audit builds)");
}

}  // namespace ligament
