#include "case/all_generators.hpp"
#include "case/case.hpp"
#include "constitutive/register_laws.hpp"
#include "integrator/register_methods.hpp"

namespace ligament {
namespace {

using Kind = TableDescription::Kind;

/// Only declarations are kept, so that the object they are bound to may go.
template <class Table>
TableDescription describe(std::string path, Kind kind, std::string description, bool required = false) {
  TableDescription table;
  table.path = std::move(path);
  table.kind = kind;
  table.description = std::move(description);
  table.required = required;
  Table object;
  object.declare(table.parameters);
  return table;
}

template <class Interface>
void add_variants(TableDescription& table, std::string selector, const Registry<Interface>& registry) {
  table.selector = std::move(selector);
  for (const std::string& name : registry.names()) {
    Variant variant{name, registry.description(name), {}};
    registry.create(name)->declare(variant.parameters);
    table.variants.push_back(std::move(variant));
  }
}

TableDescription describe_top() {
  TableDescription top;
  top.description = "Keys above the first table.";
  std::string title;
  top.parameters.text("title", title, "what the case is about");
  return top;
}

}  // namespace

std::vector<TableDescription> describe_case() {
  std::vector<TableDescription> tables{
      describe_top(),
      describe<ProblemTable>("problem", Kind::single, "The body as a whole.", true),
      describe<MaterialTable>("material.*", Kind::named,
                              "A material of elements, of contacts between particles, or both."),
      describe<MeshTable>("mesh", Kind::single, "A structured grid of 4-node elements; zones replace blocks of them."),
      describe<ContactTableOfCase>("contact", Kind::single, "Contact detection."),
      describe<GenerationTable>("generation", Kind::single, "What all generators of particles share."),
      describe<ZoneTable>("zone", Kind::array, "A rectangle filled with particles."),
      describe<NotchTable>("notch", Kind::array,
                           "A straight cut: contacts that cross it hold no tension; with a width, a slit."),
      describe<BeamTable>("beam", Kind::array, "A straight or bent beam of elements that bend, from node to node."),
      describe<WallTable>("wall", Kind::array, "A rigid wall: at rest, moved by a motion, or by forces as a platen."),
      describe<SupportTable>("support", Kind::array, "Bodies held in place."),
      describe<MotionTable>("motion", Kind::array, "Bodies moved at a prescribed velocity."),
      describe<LoadTable>("load", Kind::array, "Forces on bodies."),
      describe<GaugeTable>("gauge", Kind::array, "A column of history.csv, named <name>_<unit>."),
      describe<PropertiesTable>("properties", Kind::single,
                                "How assembly properties are measured; only with kind = \"assembly_properties\"."),
      describe<UniaxialTable>("uniaxial", Kind::single,
                              "Gauges that tell of a uniaxial test; only with kind = \"uniaxial\"."),
      describe<SolverTable>("solver", Kind::single, "How the equations of motion are stepped.", true),
      describe<StopTable>("stop", Kind::single, "When the run ends before its loading does."),
      describe<LimitTable>("limit", Kind::array, "A gauge that ends the run before its loading does, besides [stop]."),
      describe<OutputTable>("output", Kind::single, "What is written when."),
      describe<CheckpointTable>("checkpoint", Kind::single, "When the state is saved for `resume`."),
      describe<AuditTable>("audit", Kind::single, "How closely the energy ledger must close.")};
  for (TableDescription& table : tables) {
    if (table.path == "material.*") add_variants(table, "law", contact_laws());
    if (table.path == "zone") add_variants(table, "generator", all_generators(std::make_shared<InputFiles>(""), ""));
    if (table.path == "solver") {
      add_variants(table, "method", solver_methods());
      add_variants(table, "method", loading_methods());
      table.default_variant = "dynamic_relaxation";
    }
  }
  return tables;
}

}  // namespace ligament
