#include <doctest/doctest.h>

#include <cmath>

#include "integrator/dynamic_relaxation.hpp"
#include "reference/direct_solution.hpp"
#include "support/hand_made_simulation.hpp"
#include "support/hybrid_strip.hpp"
#include "support/moved_bodies.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

constexpr double stress = 100.0;  // Pa: strains of 5e-9, so that geometry plays no part.

/// Nodes at x, with the force that a uniform traction gives to each.
std::vector<PointLoad> end_traction(const Model& model, double x, double height) {
  std::vector<PointLoad> loads;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    if (std::abs(model.nodes.position[i].x - x) < 1e-9) loads.push_back({.row = static_cast<Index>(i), .force = {}});
  }
  const double share = stress * height * model.thickness / static_cast<double>(loads.size() - 1);
  for (PointLoad& load : loads) {
    const double y = model.nodes.position[load.row].y;
    const bool is_end = y < 1e-9 || y > height - 1e-9;
    load.force = {is_end ? 0.5 * share : share, 0.0};
  }
  return loads;
}

/// A strip pulled at its right end, free to contract.
struct PulledStrip {
  HybridStrip strip;
  Simulation simulation;
  Field<Vector> node_loads;

  explicit PulledStrip(const HybridStrip& dimensions, SimulationChoice choice = {})
      : strip(dimensions), simulation(make(dimensions, choice)), node_loads(simulation.model().nodes.size()) {
    for (const PointLoad& load : end_traction(simulation.model(), strip.length(), strip.height)) {
      node_loads[load.row] = load.force;
    }
  }
  static Simulation make(const HybridStrip& strip, SimulationChoice& choice) {
    Model model = strip.build();
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
      const auto held = held_node(static_cast<Index>(i));
      const Vector& place = model.nodes.position[i];
      if (place.x < 1e-9) choice.prescribed.push_back(held[0]);
      if (place.x < 1e-9 && place.y < 1e-9) choice.prescribed.push_back(held[1]);
    }
    choice.loads = end_traction(model, strip.length(), strip.height);
    return make_simulation(std::move(model), std::move(choice));
  }
  [[nodiscard]] reference::DirectSolution solve() const {
    return reference::solve_directly(simulation.model(), simulation.state(), node_loads);
  }
  /// Mean displacement of the right end less that of a uniform strip, over the elongation of the zone.
  [[nodiscard]] double zone_error(const reference::DirectSolution& solution) const {
    const double strain = stress / strip.young_modulus;
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < node_loads.size(); ++i) {
      if (node_loads[i].x == 0.0) continue;
      sum += solution.node_displacement[i].x;
      ++count;
    }
    return (sum / count - strain * strip.length()) / (strain * strip.zone_length);
  }
};

/// Mean stress of discs well inside the zone, from the forces of their contacts (Pa).
std::array<double, 3> lattice_stress(const PulledStrip& pulled, const reference::DirectSolution& solution) {
  const Model& model = pulled.simulation.model();
  State state = pulled.simulation.state();
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    displace(state.particles.translation, i, solution.particle_displacement[i]);
    rotate(state.particles.rotation, i, solution.particle_rotation[i]);
  }
  clear_forces(state);
  ContactForces<ParticlePairing>().add_forces(model, state);
  const Vector middle{0.5 * pulled.strip.length(), 0.5 * pulled.strip.height};
  const auto is_inside = [&](Index i) {
    const Vector place = model.particles.position[i] - middle;
    return std::abs(place.x) < 0.25 * pulled.strip.zone_length && std::abs(place.y) < 0.25 * pulled.strip.height;
  };
  double n_inside = 0.0;
  for (std::size_t i = 0; i < model.particles.size(); ++i) n_inside += is_inside(static_cast<Index>(i)) ? 1.0 : 0.0;
  const double area_per_particle =
      pulled.strip.zone_length * pulled.strip.height / static_cast<double>(model.particles.size());
  const ContactTable& contacts = state.particle_contacts;
  std::array<double, 3> sum{};
  for (std::size_t row = 0; row < contacts.size(); ++row) {
    // Half of a contact belongs to either disc.
    const double share = 0.5 * (is_inside(contacts.first[row]) + is_inside(contacts.second[row]));
    const Vector branch =
        model.particles.position[contacts.second[row]] - model.particles.position[contacts.first[row]];
    const Vector normal = branch / norm(branch);
    // The force on the second body points against a tension.
    const Vector force = -(contacts.normal_force[row] * normal + contacts.shear_force[row] * tangent(normal));
    sum[0] += share * force.x * branch.x;
    sum[1] += share * force.y * branch.y;
    sum[2] += share * force.x * branch.y;
  }
  for (double& s : sum) s /= n_inside * area_per_particle * model.thickness;
  return sum;
}

/// The paper's zone H1 between elements.
HybridStrip zone_h1() {
  HybridStrip strip;
  strip.height = 1.0;
  strip.element_size = 0.1;
  return strip;
}

}  // namespace

TEST_CASE("a uniform stress passes from elements to a hexagonal assembly and back") {
  const PulledStrip pulled(zone_h1());
  REQUIRE(pulled.simulation.model().particles.size() == 595);
  // Both families of rows are linked to the edges.
  CHECK(pulled.simulation.state().facet_contacts.size() == 58);
  const auto solution = pulled.solve();
  // Two interfaces and the squeezed lattice together, as a share of the elongation of the zone.
  const double error = pulled.zone_error(solution);
  MESSAGE("the zone is " << 100.0 * error << " % too soft");
  CHECK(std::abs(error) < 0.02);
  // What is pulled at one end is held at the other, and nothing turns.
  Vector reaction;
  Moment moment = 0.0;
  for (std::size_t i = 0; i < solution.node_reaction.size(); ++i) {
    reaction += solution.node_reaction[i];
    moment += cross(pulled.simulation.model().nodes.position[i], solution.node_reaction[i] + pulled.node_loads[i]);
  }
  CHECK(reaction.x == doctest::Approx(-stress * pulled.strip.height).epsilon(1e-9));
  CHECK(std::abs(reaction.y) < 1e-9 * stress);
  CHECK(std::abs(moment) < 1e-8 * stress);
  // Stress inside the lattice, the same state.
  const auto inside = lattice_stress(pulled, solution);
  MESSAGE("stress inside the lattice: " << inside[0] << ", " << inside[1] << ", " << inside[2] << " of 100 Pa");
  CHECK(inside[0] == doctest::Approx(stress).epsilon(0.03));
  CHECK(std::abs(inside[1]) < 0.02 * stress);
  CHECK(std::abs(inside[2]) < 0.01 * stress);
}

TEST_CASE("the elements on either side keep the uniform stress, a tenth off at the interface at most") {
  const PulledStrip pulled(zone_h1());
  const auto solution = pulled.solve();
  const Model& model = pulled.simulation.model();
  double largest_near = 0.0;
  double largest_far = 0.0;
  for (std::size_t element = 0; element < model.elements.size(); ++element) {
    const double off = std::abs(element_stress(model, solution.node_displacement, element).stress[0] / stress - 1.0);
    const double x = 0.5 * (corners_of(model, element)[0].x + corners_of(model, element)[2].x);
    const double from_zone = std::abs(x - 0.5 * pulled.strip.length()) - 0.5 * pulled.strip.zone_length;
    double& largest = from_zone < 0.3 ? largest_near : largest_far;
    largest = std::max(largest, off);
  }
  MESSAGE("stress in elements off by " << largest_near << " at the interface, " << largest_far << " beyond 0.3 m");
  CHECK(largest_near < 0.1);
  CHECK(largest_far < 0.01);
}

TEST_CASE("Eq. (33) is the better stiffness of the interface: with (34) the zone is softer by several percent") {
  HybridStrip strip = zone_h1();
  const double plane = PulledStrip(strip).zone_error(PulledStrip(strip).solve());
  strip.interface_stiffness = StiffnessFormula::hexagonal;
  const double hexagonal = PulledStrip(strip).zone_error(PulledStrip(strip).solve());
  MESSAGE("zone too soft by " << 100.0 * plane << " % with (33), " << 100.0 * hexagonal << " % with (34)");
  CHECK(hexagonal > plane + 0.03);
  CHECK(hexagonal < 0.12);
}

TEST_CASE("stepping with adaptive dynamic relaxation comes to the direct solution, particles, interface and elements") {
  HybridStrip strip;
  strip.element_size = 0.1;
  SimulationChoice choice;
  choice.damping = std::make_unique<DynamicRelaxation>();
  choice.time_step = {.masses = Masses::scaled};
  PulledStrip pulled(strip, std::move(choice));
  const auto solution = pulled.solve();
  int n_steps = 0;
  while (pulled.simulation.unbalance().ratio() > 1e-9 && ++n_steps < 50000) pulled.simulation.step();
  REQUIRE(n_steps < 50000);
  const double scale = stress / strip.young_modulus * strip.length();
  const State& state = pulled.simulation.state();
  double largest_error = 0.0;
  for (std::size_t i = 0; i < pulled.simulation.model().nodes.size(); ++i) {
    largest_error =
        std::max(largest_error, norm(state.nodes.translation.displacement[i] - solution.node_displacement[i]));
  }
  for (std::size_t i = 0; i < pulled.simulation.model().particles.size(); ++i) {
    largest_error =
        std::max({largest_error, norm(state.particles.translation.displacement[i] - solution.particle_displacement[i]),
                  strip.radius * std::abs(state.particles.rotation.rotation[i] - solution.particle_rotation[i])});
  }
  MESSAGE(n_steps << " steps, " << largest_error / scale << " off");
  CHECK(largest_error < 1e-6 * scale);
}
