#include <doctest/doctest.h>

#include <cmath>

#include "support/hand_made_simulation.hpp"
#include "support/hybrid_strip.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// A single hump of velocity, ½ (1 + cos) over one wave length, running to the right through a strip at rest.
struct Pulse {
  double length = 0.0;  ///< (m)
  double centre = 0.0;  ///< at time 0 (m)
  double wave_speed = 0.0;

  static constexpr double peak = 1e-4;  ///< (m/s)

  [[nodiscard]] double velocity(double x) const {
    const double q = (x - centre) / length;
    return std::abs(q) < 0.5 ? 0.5 * peak * (1.0 + std::cos(2.0 * std::numbers::pi * q)) : 0.0;
  }
  /// ∫ v/c from x to where nothing has arrived yet.
  [[nodiscard]] double displacement(double x) const {
    const double q = std::clamp((x - centre) / length, -0.5, 0.5);
    return 0.5 * peak * length / wave_speed *
           (0.5 - q - std::sin(2.0 * std::numbers::pi * q) / (2.0 * std::numbers::pi));
  }
};

/// A laterally constrained strip: bodies move along it and do not turn.
Simulation constrained_strip(const HybridStrip& strip) {
  Model model = strip.build();
  SimulationChoice choice;
  choice.time_step.factor = 0.9;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    choice.prescribed.push_back(held_node(static_cast<Index>(i))[1]);
  }
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    const auto held = held_particle(static_cast<Index>(i));
    choice.prescribed.insert(choice.prescribed.end(), {held[1], held[2]});
  }
  return make_simulation(std::move(model), std::move(choice));
}

void start(Simulation& simulation, const Pulse& pulse) {
  State state = simulation.state();
  const double half_step = 0.5 * state.clock.time_step * pulse.wave_speed;
  for (std::size_t i = 0; i < simulation.model().nodes.size(); ++i) {
    const double x = simulation.model().nodes.position[i].x;
    state.nodes.translation.displacement[i] = {pulse.displacement(x), 0.0};
    state.nodes.translation.velocity_before[i] = {pulse.velocity(x + half_step), 0.0};
    state.nodes.translation.velocity[i] = {pulse.velocity(x - half_step), 0.0};
  }
  simulation.restore(std::move(state));
}

double mean_velocity_at(const Simulation& simulation, double x, double tolerance) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < simulation.model().nodes.size(); ++i) {
    if (std::abs(simulation.model().nodes.position[i].x - x) > tolerance) continue;
    sum += simulation.state().nodes.translation.velocity[i].x;
    ++count;
  }
  return sum / count;
}

struct Echo {
  double reflected = 0.0;    ///< largest velocity that comes back from both interfaces, over that of the pulse
  double transmitted = 0.0;  ///< largest velocity beyond the zone
};

/// Sends a pulse of `n_diameters` through elements | particles | elements, elements of one diameter.
Echo send_pulse(double n_diameters, const std::string& lines) {
  HybridStrip strip;
  strip.lines = lines;
  strip.element_size = 2.0 * strip.radius;
  const double length = n_diameters * 2.0 * strip.radius;
  strip.zone_length = 2.0 * length;
  strip.side_length = 3.0 * length;
  Simulation simulation = constrained_strip(strip);
  const Pulse pulse{length, 1.5 * length, strip.wave_speed()};
  start(simulation, pulse);

  const double left = strip.side_length - 0.75 * length;
  const double right = strip.side_length + strip.zone_length + length;
  const double passed = (left + 0.6 * length - pulse.centre) / pulse.wave_speed;
  const double last_echo =
      (2.0 * (strip.side_length + strip.zone_length) - left + 0.6 * length - pulse.centre) / pulse.wave_speed;
  Echo echo;
  while (simulation.state().clock.time < last_echo) {
    simulation.step();
    if (simulation.state().clock.time > passed) {
      const double velocity = mean_velocity_at(simulation, left, 0.5 * strip.element_size);
      echo.reflected = std::max(echo.reflected, std::abs(velocity) / Pulse::peak);
    }
    const double velocity = mean_velocity_at(simulation, right, 0.5 * strip.element_size);
    echo.transmitted = std::max(echo.transmitted, velocity / Pulse::peak);
  }
  return echo;
}

}  // namespace

TEST_CASE("a plane pulse passes elements | particles | elements with little reflection") {
  for (const std::string lines : {"x", "y"}) {
    CAPTURE(lines);
    const Echo short_pulse = send_pulse(20.0, lines);
    const Echo long_pulse = send_pulse(40.0, lines);
    MESSAGE("lines along " << lines << ": reflected " << 100.0 * short_pulse.reflected << " % at 20 diameters, "
                           << 100.0 * long_pulse.reflected << " % at 40");
    CHECK(short_pulse.reflected < 0.03);
    CHECK(long_pulse.reflected < 0.015);
    CHECK(short_pulse.transmitted == doctest::Approx(1.0).epsilon(0.02));
    CHECK(long_pulse.transmitted == doctest::Approx(1.0).epsilon(0.01));
  }
}

TEST_CASE("the zone has the mass of the elements it replaces") {
  HybridStrip strip;
  const Model model = strip.build();
  double mass = 0.0;
  for (const double m : model.particles.real_mass) mass += m;
  for (const double m : model.nodes.real_mass) mass += m;
  CHECK(mass == doctest::Approx(strip.density * strip.length() * strip.height).epsilon(1e-12));
}
