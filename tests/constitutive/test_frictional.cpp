#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "constitutive/frictional.hpp"
#include "support/random_numbers.hpp"

using namespace ligament;
using namespace ligament::support;

namespace {

/// One contact, k_n = 2, k_s = 1.
struct Slider {
  static constexpr double k_n = 2.0;
  static constexpr double k_s = 1.0;
  Frictional law{0.5};
  ContactForce force{0.0, 0.0, BondState::unbonded};
  std::array<double, 1> history{0.0};

  /// Presses with N and slips by ds.
  void step(double normal_force, double slip) {
    law.evaluate({-normal_force / k_n, slip, k_n, k_s, 1.0}, force, history);
  }
  [[nodiscard]] double friction_work() const { return history[0]; }
  [[nodiscard]] double stored_shear() const {
    return law.energies({0.0, 0.0, k_n, k_s, 1.0}, force, history).elastic_shear;
  }
};

/// Follows N(x), s(x) from x = 0 to 1 in equal steps; N is there before slip begins.
Slider follow(const std::function<double(double)>& normal, const std::function<double(double)>& slip, int n_steps) {
  Slider slider;
  slider.step(normal(0.0), 0.0);
  for (int i = 1; i <= n_steps; ++i) {
    const double x = static_cast<double>(i) / n_steps;
    slider.step(normal(x), slip(x) - slip(static_cast<double>(i - 1) / n_steps));
  }
  return slider;
}

}  // namespace

TEST_CASE("a frictional contact presses and never pulls") {
  Slider slider;
  slider.step(3.0, 0.0);
  CHECK(slider.force.normal == doctest::Approx(3.0).epsilon(1e-15));
  slider.step(-3.0, 0.0);
  CHECK(slider.force.normal == 0.0);
}

TEST_CASE("the shear force grows with the slip up to μ N and stays there") {
  Slider slider;
  for (int i = 1; i <= 40; ++i) {
    slider.step(4.0, 0.1);
    CHECK(slider.force.shear == doctest::Approx(-std::min(0.1 * i, 2.0)).epsilon(1e-12));
  }
  // μ N (s - μ N / k_s).
  CHECK(slider.friction_work() == doctest::Approx(2.0 * (4.0 - 2.0)).epsilon(1e-12));
  CHECK(slider.stored_shear() == doctest::Approx(2.0).epsilon(1e-12));
}

TEST_CASE("a closed loop of slip spends 4 μ N (S - μ N / k_s)") {
  const auto amplitude = 5.0;
  const auto triangle = [&](double x) {
    // Two loops after the quarter that leads to the first turning point.
    const double phase = std::fmod(2.25 * x, 1.0);
    return amplitude * (phase < 0.25 ? 4.0 * phase : phase < 0.75 ? 2.0 - 4.0 * phase : 4.0 * phase - 4.0);
  };
  const auto constant = [](double) { return 4.0; };
  const double work = follow(constant, triangle, 9000).friction_work();
  const double first_quarter = 2.0 * (amplitude - 2.0);
  CHECK(work == doctest::Approx(first_quarter + 2.0 * 4.0 * 2.0 * (amplitude - 2.0)).epsilon(1e-10));
}

TEST_CASE("below the limit nothing is spent") {
  RandomNumbers random(21);
  Slider slider;
  double slip = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double next = random.uniform(-1.9, 1.9);
    slider.step(4.0, next - slip);
    slip = next;
  }
  CHECK(slider.friction_work() == 0.0);
  CHECK(slider.force.shear == doctest::Approx(-slip).epsilon(1e-12));
}

TEST_CASE("what a contact stores in shear when it opens becomes friction work") {
  Slider slider;
  slider.step(4.0, 1.5);
  const double stored = slider.stored_shear();
  CHECK(stored == doctest::Approx(0.5 * 1.5 * 1.5).epsilon(1e-15));
  slider.step(-1.0, 0.0);
  CHECK(slider.force.shear == 0.0);
  CHECK(slider.friction_work() == doctest::Approx(stored).epsilon(1e-15));
}

TEST_CASE("without friction nothing resists") {
  Slider slider;
  slider.law.friction_coefficient = 0.0;
  slider.step(4.0, 1.0);
  CHECK(slider.force.shear == 0.0);
  CHECK(slider.friction_work() == 0.0);
}

TEST_CASE("under constant pressure the friction work never falls, whatever the slip") {
  RandomNumbers random(22);
  Slider slider;
  slider.step(4.0, 0.0);
  double work = 0.0;
  for (int i = 0; i < 100000; ++i) {
    slider.step(4.0, std::pow(10.0, random.uniform(-3.0, 1.0)) * random.uniform(-1.0, 1.0));
    // A step back across the whole range is worked on by forces that cancel, but for a rounding.
    REQUIRE(slider.friction_work() >= work - 1e-12);
    work = std::max(work, slider.friction_work());
  }
  CHECK(work > 1000.0);
}

TEST_CASE("under any random pressure the friction work never falls as long as steps are small against the forces") {
  RandomNumbers random(23);
  Slider slider;
  double pressure = 4.0;
  double highest = 0.0;
  double largest_fall = 0.0;
  for (int i = 0; i < 100000; ++i) {
    pressure = std::clamp(pressure + random.uniform(-0.05, 0.05), -0.5, 8.0);
    slider.step(pressure, random.uniform(-0.05, 0.05));
    largest_fall = std::max(largest_fall, highest - slider.friction_work());
    highest = std::max(highest, slider.friction_work());
  }
  CHECK(highest > 10.0);
  // Near zero pressure one step may be large against the force: it falls by no more than its square.
  CHECK(largest_fall < 0.5 * 0.05 * 0.05);
}

TEST_CASE("external work is stored or spent: the trapezoid of a step closes to rounding") {
  RandomNumbers random(24);
  Slider slider;
  double done = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double before = slider.force.shear;
    const double slip = random.uniform(-2.0, 2.0);
    slider.step(random.uniform(-1.0, 8.0), slip);
    done -= 0.5 * (before + slider.force.shear) * slip;
  }
  CHECK(slider.friction_work() + slider.stored_shear() == doctest::Approx(done).epsilon(1e-12));
}

TEST_CASE("under changing pressure the friction work converges with order 2") {
  // N = 4 (1 + x²), slip 40 x: sliding throughout after the first stick.
  const auto normal = [](double x) { return 4.0 * (1.0 + x * x); };
  const auto slip = [](double x) { return 40.0 * x; };
  // W = ∫ μN (ds - μ dN / k_s) from where k_s s = μ N: 40 x = 2 + 2 x².
  const double start = 10.0 - std::sqrt(99.0);
  const auto antiderivative = [](double x) {
    const double sliding = 40.0 * (2.0 * x + 2.0 / 3.0 * x * x * x);
    const double half_force = 2.0 * (1.0 + x * x);
    return sliding - 0.5 * half_force * half_force;
  };
  const double exact = antiderivative(1.0) - antiderivative(start);
  const auto error = [&](int n_steps) { return std::abs(follow(normal, slip, n_steps).friction_work() - exact); };
  CHECK(error(100) / exact < 1e-3);
  // Mean over runs whose first sliding step falls differently.
  double coarse = 0.0;
  double fine = 0.0;
  for (int k = 0; k < 20; ++k) {
    coarse += error(200 + k);
    fine += error(10 * (200 + k));
  }
  CHECK(fine < 0.02 * coarse);
}
