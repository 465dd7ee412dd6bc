#include "audit/lost_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/pairings.hpp"
#include "mesh/element_properties.hpp"

namespace ligament {
namespace {

bool is_within(const Vector& travel, double limit) { return dot(travel, travel) <= limit * limit; }

bool is_finite_row(const TranslationState& bodies, std::size_t i) {
  return is_finite(bodies.displacement[i]) && is_finite(bodies.velocity[i]) && is_finite(bodies.force[i]);
}

bool is_finite_row(const RotationState& bodies, std::size_t i) {
  return std::isfinite(bodies.rotation[i]) && std::isfinite(bodies.spin[i]) && std::isfinite(bodies.moment[i]);
}

std::string place(const Vector& rest, const Vector& displacement) {
  const auto [x, y, z] = to_space(is_finite(displacement) ? rest + displacement : rest);
  return fmt::format("({:.6g}, {:.6g}) m{}", x, y, is_finite(displacement) ? "" : " at rest");
}

/// What is not a number counts as the largest.
double size_of(double value) { return std::isnan(value) ? std::numeric_limits<double>::infinity() : std::abs(value); }

/// A contact in words, and how large its force is.
struct Suspect {
  double size = -1.0;
  std::string text;
};

template <class Pairing, class NameOf>
void see_contacts(const State& state, Index particle, const NameOf& name_of, Suspect& worst) {
  const ContactTable& contacts = Pairing::table(state);
  for (std::size_t row = 0; row < contacts.size(); ++row) {
    const Index second = contacts.second[row];
    const bool is_second = std::is_same_v<Pairing, ParticlePairing> && second == particle;
    if (contacts.first[row] != particle && !is_second) continue;
    const double size = std::max(size_of(contacts.normal_force[row]), size_of(contacts.shear_force[row]));
    if (size <= worst.size) continue;
    worst = {size, fmt::format("; of its contacts that with {} has the largest force, {:.4g} N along the normal and "
                               "{:.4g} N in shear at an opening of {:.4g} m",
                               name_of(is_second ? contacts.first[row] : second), contacts.normal_force[row],
                               contacts.shear_force[row], contacts.opening[row])};
  }
}

std::string worst_contact(const Model& model, const State& state, Index particle) {
  Suspect worst;
  see_contacts<ParticlePairing>(
      state, particle, [&](Index row) { return fmt::format("particle {}", model.particles.id[row]); }, worst);
  see_contacts<FacetPairing>(
      state, particle,
      [&](Index row) {
        const Index element = model.facets.element[row];
        return element < 0 ? std::string("a wall") : fmt::format("element {}", model.elements.id[element]);
      },
      worst);
  see_contacts<CornerPairing>(
      state, particle, [&](Index row) { return fmt::format("node {}", model.nodes.id[row]); }, worst);
  return worst.text;
}

std::string worst_element(const Model& model, const State& state, Index node) {
  Suspect worst;
  for (std::size_t element = 0; element < model.elements.size(); ++element) {
    const auto& nodes = model.elements.nodes[element];
    if (std::find(nodes.begin(), nodes.end(), node) == nodes.end()) continue;
    double size = 0.0;
    for (const double component : element_stress(model, state.nodes.translation.displacement, element).stress) {
      size = std::max(size, size_of(component));
    }
    if (size <= worst.size) continue;
    worst = {size,
             fmt::format("; of its elements {} has the largest stress, {:.4g} Pa", model.elements.id[element], size)};
  }
  return worst.text;
}

constexpr const char* infinite = "has a number that is not finite";

std::string describe_particle(const Model& model, const State& state, std::size_t row, const std::string& complaint) {
  const auto particle = static_cast<Index>(row);
  return fmt::format("particle {} at {} {}{}", model.particles.id[row],
                     place(model.particles.position[row], state.particles.translation.displacement[row]), complaint,
                     worst_contact(model, state, particle));
}

std::string describe_node(const Model& model, const State& state, std::size_t row) {
  return fmt::format("node {} at {} {}{}", model.nodes.id[row],
                     place(model.nodes.position[row], state.nodes.translation.displacement[row]), infinite,
                     worst_element(model, state, static_cast<Index>(row)));
}

}  // namespace

StepLimits step_limits(const Model& model) {
  const auto& radii = model.particles.radius;
  return {.travel = radii.empty() ? 0.0 : 2.0 * *std::min_element(radii.begin(), radii.end())};
}

bool is_within(const StepTravel& travel, const StepLimits& limits) {
  return travel.particles <= limits.travel && travel.turn <= limits.turn && std::isfinite(travel.nodes);
}

std::string describe_infinite_body(const Model& model, const State& state) {
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    if (is_finite_row(state.particles.translation, i) && is_finite_row(state.particles.rotation, i)) continue;
    return describe_particle(model, state, i, infinite);
  }
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    if (!is_finite_row(state.nodes.translation, i)) return describe_node(model, state, i);
  }
  for (std::size_t i = 0; i < model.beam_nodes.size(); ++i) {
    const auto& [translation, rotation] = state.beam_nodes;
    if (is_finite_row(translation, i) && is_finite_row(rotation, i)) continue;
    return fmt::format("node {} of a beam at {} {}", model.beam_nodes.id[i],
                       place(model.beam_nodes.position[i], translation.displacement[i]), infinite);
  }
  return {};
}

std::string describe_lost_body(const Model& model, const State& state, const StepLimits& limits) {
  if (std::string text = describe_infinite_body(model, state); !text.empty()) return text;
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    const Vector& travel = state.particles.translation.increment[i];
    const Rotation turn = state.particles.rotation.increment[i];
    if (!is_within(travel, limits.travel)) {
      return describe_particle(model, state, i,
                               fmt::format("has moved by {:.4g} m in one step", std::sqrt(dot(travel, travel))));
    }
    if (!(std::abs(turn) <= limits.turn)) {
      return describe_particle(model, state, i, fmt::format("has turned by {:.4g} rad in one step", turn));
    }
  }
  return {};
}

}  // namespace ligament
