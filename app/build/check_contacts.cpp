#include "build/check_contacts.hpp"

#include <fmt/format.h>

#include <string>

namespace ligament {
namespace {

/// What the law of a material has against one of its contacts.
struct WorstContact {
  LawComplaint complaint;
  std::string bodies;
};

template <class SecondName>
void find_worst(const Model& model, const ContactTable& contacts, SecondName&& second_name,
                std::vector<std::optional<WorstContact>>& worst_of_law) {
  for (std::size_t row = 0; row < contacts.size(); ++row) {
    const auto law = static_cast<std::size_t>(contacts.law[row]);
    auto complaint = model.laws[law].law->complaint(
        {contacts.normal_stiffness[row], contacts.shear_stiffness[row], contacts.area[row]});
    auto& worst = worst_of_law[law];
    if (!complaint || (worst && worst->complaint.severity >= complaint->severity)) continue;
    const std::string bodies =
        fmt::format("particle {} and {}", model.particles.id[contacts.first[row]], second_name(contacts.second[row]));
    worst = WorstContact{std::move(*complaint), bodies};
  }
}

}  // namespace

void check_contacts(Case& input, const Model& model, const State& state) {
  std::vector<std::optional<WorstContact>> worst_of_law(model.laws.size());
  const auto node = [&](Index row) { return fmt::format("node {}", model.nodes.id[row]); };
  find_worst(
      model, state.particle_contacts, [&](Index row) { return fmt::format("particle {}", model.particles.id[row]); },
      worst_of_law);
  find_worst(
      model, state.facet_contacts,
      [&](Index row) {
        const auto& nodes = model.facets.nodes[row];
        return fmt::format("the edge from {} to {}", node(nodes[0]), node(nodes[1]));
      },
      worst_of_law);
  find_worst(model, state.corner_contacts, node, worst_of_law);

  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    const auto& worst = worst_of_law[static_cast<std::size_t>(model.materials[i].bond_law)];
    if (!worst) continue;
    const TableView& view = input.materials[i].view;
    input.file.add_error(input.file.position(view, worst->complaint.parameter),
                         fmt::format("{} (contact of {} {})", worst->complaint.text, worst->bodies, view.where()));
  }
}

}  // namespace ligament
