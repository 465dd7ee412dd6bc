#include "simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "integrator/platens.hpp"
#include "integrator/time_step.hpp"

namespace ligament {
namespace {

void resize(TranslationState& bodies, std::size_t count) {
  for (Field<Vector>* field :
       {&bodies.displacement, &bodies.increment, &bodies.velocity_before, &bodies.velocity, &bodies.force}) {
    field->assign(count, Vector{});
  }
  bodies.mass.assign(count, 0.0);
}

void resize(RotationState& bodies, std::size_t count) {
  for (Field<double>* field :
       {&bodies.rotation, &bodies.increment, &bodies.spin_before, &bodies.spin, &bodies.moment, &bodies.inertia}) {
    field->assign(count, 0.0);
  }
}

void clear(TranslationState& bodies) {
  parallel_bodies(bodies.force.size(), [&](std::size_t begin, std::size_t end) {
    std::fill(bodies.force.data() + begin, bodies.force.data() + end, Vector{});
  });
}

void clear(TurningState& bodies) {
  parallel_bodies(bodies.translation.force.size(), [&](std::size_t begin, std::size_t end) {
    std::fill(bodies.translation.force.data() + begin, bodies.translation.force.data() + end, Vector{});
    std::fill(bodies.rotation.moment.data() + begin, bodies.rotation.moment.data() + end, Moment{});
  });
}

void clear_forces(State& state) {
  clear(state.particles);
  clear(state.nodes.translation);
  clear(state.beam_nodes);
}

void merge(std::vector<EnergyTerm>& lines, const std::vector<EnergyTerm>& more) {
  for (const EnergyTerm& term : more) {
    const auto line =
        std::find_if(lines.begin(), lines.end(), [&](const EnergyTerm& known) { return known.name == term.name; });
    if (line == lines.end()) {
      lines.push_back(term);
    } else {
      line->value += term.value;
    }
  }
}

}  // namespace

Simulation::Simulation(Model model, Modules modules, TimeStepChoice time_step)
    : model_(std::move(model)),
      modules_(std::move(modules)),
      choice_(time_step),
      step_limits_(ligament::step_limits(model_)) {
  prepare_state();
  choose_time_step();
  if (is_quasi_static()) {
    IncrementalLoading::open_lines(state_.ledger);
    modules_.loading->use_stiffness(model_, state_, stiffness());
    add_forces();
    return;
  }
  if (modules_.integrator->needs_stiffness()) modules_.integrator->use_stiffness(model_, state_, stiffness());
  add_forces();
  modules_.integrator->update_velocities(model_, state_);
  for (auto& constraint : modules_.constraints) constraint->apply(model_, state_);
  book_work();
}

bool Simulation::advance() {
  if (is_quasi_static()) return increment();
  step();
  return true;
}

void Simulation::step() {
  const StepTravel travel = modules_.integrator->update_positions(model_, state_);  // x(n) = x(n-1) + v(n-½) Δt
  place_platen_ends(model_, state_);
  state_.clock.advance();
  check_travel(travel);
  if (update_contacts(travel)) check_time_step();          // update set of contacts
  add_forces();                                            // force-displacement law, Eqs (3)-(28)
  modules_.integrator->update_velocities(model_, state_);  // law of motion, Eqs (1)-(2): v(n+½)
  for (auto& constraint : modules_.constraints) constraint->apply(model_, state_);
  book_work();
}

bool Simulation::increment() {
  const auto update_contacts = [this] { modules_.contact_detector->update(model_, state_); };
  update_contacts();
  return modules_.loading->advance(
      model_, state_,
      {.add_forces = [this] { add_forces(); },
       .add_applied_loads = [this] { add_applied_loads(); },
       .internal = [this] { return internal_forces(); },
       .update_contacts = update_contacts,
       .is_interrupted = is_interrupted_,
       .stiffness = [this] { return stiffness(); },
       .secants = [this](const ContactMemory& before) { return secants(before); },
       .loose_contacts = [this](const auto& before) { return loose_contacts(before); },
       .try_contact = [this](const auto& before, std::size_t spring,
                             const auto& stretch) { return try_contact(before, spring, stretch); },
       .observer = observer_});
}

void Simulation::open_stages(std::size_t n_stages, std::size_t n_gauges) {
  state_.stage.readings.assign(n_stages * n_gauges, 0.0);
  state_.stage.peaks.assign(n_gauges, 0.0);
}

void Simulation::note_readings(const std::vector<double>& readings, double force_mismatch) {
  const double peak_force = state_.loading.peak_force;
  if (peak_force > 0.0) {
    state_.stage.force_mismatch = std::max(state_.stage.force_mismatch, force_mismatch / peak_force);
  }
  Field<double>& peaks = state_.stage.peaks;
  for (std::size_t i = 0; i < readings.size(); ++i) peaks[i] = std::max(peaks[i], readings[i]);
}

void Simulation::finish_stage(const std::vector<double>& readings) {
  StageState& stage = state_.stage;
  std::copy(readings.begin(), readings.end(),
            stage.readings.begin() + (stage.number - 1) * static_cast<std::ptrdiff_t>(readings.size()));
  ++stage.number;
  stage.begin_step = state_.clock.step;
  // The velocities of the step ahead are those of the stage before; increments have none.
  stage.begin_time = state_.clock.time + (is_quasi_static() ? 0.0 : state_.clock.time_step);
  if (is_quasi_static()) IncrementalLoading::begin_segment(state_);
}

double Simulation::audit() {
  EnergyBalance balance;
  for (const EnergyTerm& term : energies()) balance.add(term);
  return state_.ledger.audit(balance);
}

void Simulation::count_breaks(std::int64_t n_tension, std::int64_t n_shear) {
  state_.cracks.n_tension += n_tension;
  state_.cracks.n_shear += n_shear;
}

std::vector<EnergyTerm> Simulation::energies() const {
  std::vector<EnergyTerm> lines =
      is_quasi_static() ? modules_.loading->energies(model_, state_) : modules_.integrator->energies(model_, state_);
  for (const auto& provider : modules_.force_providers) merge(lines, provider->energies(model_, state_));
  merge(lines, modules_.contact_detector->energies(model_, state_));
  for (const auto& constraint : modules_.constraints) merge(lines, constraint->energies(model_, state_));
  return lines;
}

Unbalance Simulation::unbalance() const { return measure_unbalance(model_, state_, internal_forces()); }

ForceMagnitudes Simulation::internal_forces() const {
  ForceMagnitudes magnitudes;
  for (const auto& provider : modules_.force_providers) magnitudes += provider->internal_forces(model_, state_);
  return magnitudes;
}

StiffnessBounds Simulation::stiffness_bounds() const {
  StiffnessBounds bounds(model_.particles.size(), model_.nodes.size(), model_.beam_nodes.size());
  for (const auto& provider : modules_.force_providers) provider->add_stiffness(model_, state_, bounds);
  pass_on_platen_stiffness(model_, bounds);
  return bounds;
}

StiffnessSum Simulation::stiffness() const {
  StiffnessSum sum(model_);
  for (const auto& provider : modules_.force_providers) provider->assemble(model_, state_, sum);
  return sum;
}

std::vector<double> Simulation::secants(const ContactMemory& before) const {
  std::vector<double> secants;
  for (const auto& provider : modules_.force_providers) provider->add_secants(model_, state_, before, secants);
  return secants;
}

std::vector<LooseContact> Simulation::loose_contacts(const ContactMemory& before) const {
  std::vector<LooseContact> loose;
  std::size_t first_spring = 0;
  for (const auto& provider : modules_.force_providers) {
    provider->add_loose_contacts(state_, before, first_spring, loose);
    first_spring += provider->n_springs(model_, state_);
  }
  return loose;
}

SpringAnswer Simulation::try_contact(const ContactMemory& before, std::size_t spring, const SpringPair& stretch) const {
  for (const auto& provider : modules_.force_providers) {
    const std::size_t n_springs = provider->n_springs(model_, state_);
    if (spring < n_springs) return provider->try_contact(model_, state_, before, spring, stretch);
    spring -= n_springs;
  }
  throw std::logic_error("there is no such spring");
}

void Simulation::prepare_state() {
  resize(state_.particles.translation, model_.particles.size());
  resize(state_.particles.rotation, model_.particles.size());
  resize(state_.nodes.translation, model_.nodes.size());
  resize(state_.beam_nodes.translation, model_.beam_nodes.size());
  resize(state_.beam_nodes.rotation, model_.beam_nodes.size());
  state_.platens.force.assign(2 * model_.platens.size(), Vector{});
  modules_.contact_detector->bond(model_, state_);
}

void Simulation::choose_time_step() {
  const StiffnessBounds bounds = stiffness_bounds();
  Clock& clock = state_.clock;
  if (choice_.masses == Masses::scaled) {
    clock.time_step = choice_.time_step;
    use_scaled_masses(model_, state_, bounds, choice_.safety);
    limiting_body_ = critical_time_step(model_, state_, bounds).limiting_body;
  } else {
    use_real_masses(model_, state_);
    const CriticalTimeStep critical = critical_time_step(model_, state_, bounds);
    if (!std::isfinite(critical.time_step) && !(choice_.time_step > 0.0)) {
      throw InputError("nothing has stiffness, so that no stable time step follows; give 'time_step'");
    }
    clock.time_step = choice_.factor * critical.time_step;
    if (choice_.time_step > 0.0) clock.time_step = std::min(clock.time_step, choice_.time_step);
    limiting_body_ = critical.limiting_body;
  }
  clock.time_step_before = clock.time_step;
}

void Simulation::check_time_step() {
  // Masses made from the stiffness at set-up stay: bonds that break only soften it.
  if (modules_.integrator->needs_stiffness()) return;
  const StiffnessBounds bounds = stiffness_bounds();
  if (choice_.masses == Masses::scaled) {
    const double energy = raise_scaled_masses(model_, state_, bounds, choice_.safety);
    state_.ledger[state_.ledger.open("step_change")].add(energy);
    return;
  }
  const CriticalTimeStep critical = critical_time_step(model_, state_, bounds);
  if (state_.clock.time_step <= critical.time_step) return;
  state_.clock.time_step = choice_.factor * critical.time_step;
  limiting_body_ = critical.limiting_body;
}

bool Simulation::update_contacts(const StepTravel& travel) {
  spare_travel_ -= std::max(travel.particles, travel.nodes);
  if (spare_travel_ > 0.0) return false;
  const bool is_updated = modules_.contact_detector->update(model_, state_);
  // A little less, for what rounding adds up to. Ends of platens go where what they rest on takes them.
  constexpr double rounding = 1e-3;
  const double spare = model_.platens.empty() ? modules_.contact_detector->spare_travel(model_, state_) : 0.0;
  spare_travel_ = (1.0 - rounding) * spare;
  return is_updated;
}

void Simulation::check_travel(const StepTravel& travel) const {
  if (is_within(travel, step_limits_)) return;
  throw DivergenceError(
      fmt::format("step {}: {}", state_.clock.step, describe_lost_body(model_, state_, step_limits_)));
}

void Simulation::add_forces() {
  clear_forces(state_);
  // Increments of loading move the middles alone.
  place_platen_ends(model_, state_);
  for (auto& provider : modules_.force_providers) provider->add_forces(model_, state_);
  pass_on_platen_forces(model_, state_);
}

void Simulation::add_applied_loads() {
  clear_forces(state_);
  for (auto& provider : modules_.force_providers) {
    if (provider->is_applied_load()) provider->add_forces(model_, state_);
  }
}

void Simulation::book_work() {
  modules_.integrator->book_work(model_, state_);
  for (auto& provider : modules_.force_providers) provider->book_work(model_, state_);
  modules_.contact_detector->book_work(model_, state_);
  for (auto& constraint : modules_.constraints) constraint->book_work(model_, state_);
}

}  // namespace ligament
