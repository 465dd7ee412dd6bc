#include <doctest/doctest.h>

#include <cmath>

#include "build/build_simulation.hpp"
#include "integrator/coarse_space.hpp"
#include "reference/direct_solution.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;

namespace {

Simulation column(const std::string& name) {
  Case input = read_case(LIGAMENT_SOURCE_DIR "/config/" + name + ".toml", {"solver.method=two_level_relaxation"});
  return build_simulation(input).simulation;
}

std::vector<double> random_column(std::size_t size, std::uint64_t seed) {
  support::RandomNumbers numbers(seed);
  std::vector<double> column(size);
  for (double& value : column) value = numbers.uniform(-1.0, 1.0);
  return column;
}

double largest(const std::vector<double>& column) {
  double result = 0.0;
  for (const double value : column) result = std::max(result, std::abs(value));
  return result;
}

}  // namespace

TEST_CASE("the stiffness that contacts and elements add up is that of the slow twin") {
  for (const char* name : {"column_hexagonal_h1", "column_hexagonal_h2"}) {
    CAPTURE(name);
    const Simulation simulation = column(name);
    const StiffnessSum sum = simulation.stiffness();
    const auto twin = reference::assemble_stiffness(simulation.model(), simulation.state());
    const std::vector<double> x = random_column(sum.numbers().count(), 5);
    const std::vector<double> product = sum.times(x);
    const Eigen::VectorXd wanted = twin * Eigen::Map<const Eigen::VectorXd>(x.data(), twin.cols());
    for (std::size_t i = 0; i < product.size(); ++i) {
      CHECK(std::abs(product[i] - wanted[static_cast<Eigen::Index>(i)]) < 1e-12 * largest(product));
    }
  }
}

TEST_CASE("coarse motions answer the forces of a coarse motion by that motion") {
  const Simulation simulation = column("column_hexagonal_h1");
  const StiffnessSum stiffness = simulation.stiffness();
  CoarseSpace coarse(simulation.model(), stiffness, 0.5);
  // Any answer is a coarse motion; its own forces give it back.
  std::vector<double> motion(stiffness.numbers().count(), 0.0);
  coarse.add_answer(random_column(motion.size(), 7), 1.0, motion);
  std::vector<double> again(motion.size(), 0.0);
  coarse.add_answer(stiffness.times(motion), 1.0, again);
  for (std::size_t i = 0; i < motion.size(); ++i) {
    CHECK(std::abs(again[i] - motion[i]) < 1e-5 * largest(motion));
  }
}

TEST_CASE("with two levels of masses the columns relax in fewer steps than the paper's, to the direct solution") {
  struct Column {
    const char* name;
    int steps_of_paper;
  };
  for (const Column& wanted : {Column{"column_fem", 160},
                               {"column_hexagonal_h1", 816},
                               {"column_random_r1", 1123},
                               {"column_hexagonal_h2", 395},
                               {"column_random_r2", 1032}}) {
    CAPTURE(wanted.name);
    Simulation simulation = column(wanted.name);
    const auto direct =
        reference::solve_directly(simulation.model(), simulation.state(), simulation.state().nodes.translation.force);
    std::int64_t steps_to_convergence = 0;
    while (simulation.unbalance().ratio() > 1e-9) {
      if (simulation.unbalance().ratio() > 1e-6) steps_to_convergence = simulation.state().clock.step + 1;
      simulation.step();
      simulation.audit();
      REQUIRE(simulation.state().clock.step < 1000);
    }
    CHECK(steps_to_convergence < wanted.steps_of_paper);
    CHECK(simulation.state().ledger.largest_error < 1e-7);
    const Field<Vector>& got = simulation.state().nodes.translation.displacement;
    double scale = 0.0;
    double difference = 0.0;
    for (std::size_t i = 0; i < got.size(); ++i) {
      scale = std::max(scale, norm(direct.node_displacement[i]));
      difference = std::max(difference, norm(got[i] - direct.node_displacement[i]));
    }
    CHECK(difference < 1e-6 * scale);
  }
}
