#include "integrator/increment_work.hpp"

#include <cmath>

#include "integrator/freedom_columns.hpp"
#include "integrator/ledger_lines.hpp"
#include "integrator/line_integral.hpp"

namespace ligament {
namespace {

/// The work along the straight line from the last equilibrium to this one, on which the contacts, too, take their
/// history from one to the other.
ForceWork line_work(Increment& increment, const std::vector<double>& motion, const ForceWork& begin,
                    const ForceWork& end, std::size_t fewest_intervals) {
  State& state = increment.state();
  const double time = state.clock.time;
  BodyMemory bodies;
  bodies.take(state);
  ContactMemory contacts;
  contacts.take(state);
  const auto rate_at = [&](double share) {
    increment.go_along(motion, time, share);
    return work_of(increment.free(), motion, increment.forces(), increment.loads());
  };
  const double scale = std::abs(state.ledger.total(ledger_lines::prescribed_motions)) +
                       std::abs(state.ledger.total(ledger_lines::applied_loads)) + std::abs(end.of_prescribed()) +
                       std::abs(end.of_loads);
  constexpr double tolerance = 1e-5;
  const auto internal = [](const ForceWork& value) { return value.of_internal(); };
  const ForceWork work = line_integral(begin, end, rate_at, internal, fewest_intervals, tolerance * scale);
  state.clock.time = time;
  bodies.put_back(state);
  contacts.put_back(state);
  return work;
}

}  // namespace

void book_increment_work(Increment& increment, std::size_t fewest_intervals) {
  const std::vector<double> motion = increment.motion();
  const ForceWork begin = work_of(increment.free(), motion, increment.start_forces(), increment.start_loads());
  const ForceWork end = work_of(increment.free(), motion, increment.forces(), increment.loads());
  const ForceWork along_equilibria = 0.5 * (begin + end);
  const ForceWork on_the_way =
      increment.is_live() ? increment.work_on_the_way() : line_work(increment, motion, begin, end, fewest_intervals);
  EnergyLedger& ledger = increment.state().ledger;
  ledger[ledger.open(ledger_lines::prescribed_motions)].add(along_equilibria.of_prescribed());
  ledger[ledger.open(ledger_lines::applied_loads)].add(along_equilibria.of_loads);
  ledger[ledger.open(released_line)].add(on_the_way.of_free +
                                         (along_equilibria.of_prescribed() - on_the_way.of_prescribed()) +
                                         (along_equilibria.of_loads - on_the_way.of_loads));
}

}  // namespace ligament
