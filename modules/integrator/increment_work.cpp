#include "integrator/increment_work.hpp"

#include <cmath>

#include "core/block_sum.hpp"
#include "integrator/freedom_columns.hpp"
#include "integrator/ledger_lines.hpp"
#include "integrator/line_integral.hpp"

namespace ligament {
namespace {

/// Works from one equilibrium to the next (J), or their rates on the way.
struct Work {
  double of_all = 0.0;    ///< of resultants on all freedoms
  double of_free = 0.0;   ///< on free ones
  double of_loads = 0.0;  ///< of applied loads

  Work& operator+=(const Work& b) {
    of_all += b.of_all;
    of_free += b.of_free;
    of_loads += b.of_loads;
    return *this;
  }
  friend Work operator+(Work a, const Work& b) { return a += b; }
  friend Work operator*(double s, const Work& a) { return {s * a.of_all, s * a.of_free, s * a.of_loads}; }
  friend Work operator-(const Work& a, const Work& b) { return a + (-1.0) * b; }
  /// Of what moves prescribed freedoms, against the resultants on them.
  [[nodiscard]] double of_prescribed() const { return of_free - of_all; }
  /// Of internal forces, which contacts and elements store or spend.
  [[nodiscard]] double of_internal() const { return of_all - of_loads; }
};

Work rate(const std::vector<double>& free, const std::vector<double>& motion, const std::vector<double>& forces,
          const std::vector<double>& loads) {
  return block_sum(motion.size(), [&](std::size_t i) {
    const double all = forces[i] * motion[i];
    return Work{all, free[i] * all, free[i] * loads[i] * motion[i]};
  });
}

/// The work along the straight line from the last equilibrium to this one, on which the contacts, too, take their
/// history from one to the other.
Work line_work(Increment& increment, const std::vector<double>& motion, const Work& begin, const Work& end,
               std::size_t fewest_intervals) {
  State& state = increment.state();
  const double time = state.clock.time;
  const ParticleState particles = state.particles;
  const NodeState nodes = state.nodes;
  ContactMemory contacts;
  contacts.take(state);
  const auto rate_at = [&](double share) {
    increment.go_along(motion, time, share);
    return rate(increment.free(), motion, increment.forces(), increment.loads());
  };
  const double scale = std::abs(state.ledger.total(ledger_lines::prescribed_motions)) +
                       std::abs(state.ledger.total(ledger_lines::applied_loads)) + std::abs(end.of_prescribed()) +
                       std::abs(end.of_loads);
  constexpr double tolerance = 1e-6;
  const auto internal = [](const Work& value) { return value.of_internal(); };
  const Work work = line_integral(begin, end, rate_at, internal, fewest_intervals, tolerance * scale);
  state.clock.time = time;
  state.particles = particles;
  state.nodes = nodes;
  contacts.put_back(state);
  return work;
}

}  // namespace

void book_increment_work(Increment& increment, std::size_t fewest_intervals) {
  const std::vector<double> motion = all_increments(increment.model(), increment.state());
  const Work begin = rate(increment.free(), motion, increment.start_forces(), increment.start_loads());
  const Work end = rate(increment.free(), motion, increment.forces(), increment.loads());
  const Work along_equilibria = 0.5 * (begin + end);
  const Work along_line = line_work(increment, motion, begin, end, fewest_intervals);
  EnergyLedger& ledger = increment.state().ledger;
  ledger[ledger.open(ledger_lines::prescribed_motions)].add(along_equilibria.of_prescribed());
  ledger[ledger.open(ledger_lines::applied_loads)].add(along_equilibria.of_loads);
  ledger[ledger.open(released_line)].add(along_line.of_free +
                                         (along_equilibria.of_prescribed() - along_line.of_prescribed()) +
                                         (along_equilibria.of_loads - along_line.of_loads));
}

}  // namespace ligament
