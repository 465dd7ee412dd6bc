#include "build/build_model.hpp"

#include <algorithm>

#include "build/build_beams.hpp"
#include "build/build_notches.hpp"
#include "build/build_walls.hpp"
#include "build/check_case.hpp"
#include "build/generate_packings.hpp"
#include "mesh/boundary_facets.hpp"
#include "mesh/element_properties.hpp"
#include "mesh/structured_mesh.hpp"

namespace ligament {
namespace {

Index add_law(Model& model, const std::string& name, std::shared_ptr<const ConstitutiveLaw> law) {
  const std::size_t n_history = law->history().size();
  model.laws.push_back({name, std::move(law), n_history});
  return static_cast<Index>(model.laws.size() - 1);
}

void add_materials(const Case& input, Model& model) {
  for (const auto& [table, view] : input.materials) {
    Material material;
    material.name = table.name;
    material.young_modulus = table.young_modulus;
    material.poisson_ratio = table.poisson_ratio;
    material.density = table.density.value_or(0.0);
    material.stiffness = table.stiffness;
    material.contact_length = table.contact_length;
    material.bond_law = add_law(model, table.name + ".bond", table.law);
    material.contact_law = add_law(model, table.name + ".contact", table.law->contact_law());
    model.materials.push_back(std::move(material));
  }
}

void add_mesh(const Case& input, Model& model) {
  if (!input.mesh) return;
  const MeshTable& table = input.mesh->table;
  std::vector<Rectangle> holes;
  for (const auto& zone : input.zones) holes.push_back(rectangle_of(zone.table));
  for (const Rectangle& element : take_elements(input, model.notches)) holes.push_back(element);
  StructuredMesh mesh = build_structured_mesh({table.x, table.y}, holes);
  model.nodes = std::move(mesh.nodes);
  model.elements = std::move(mesh.elements);
  model.elements.material.assign(model.elements.size(), material_row(model, table.material));
  model.facets = find_boundary_facets(model.elements);
  fill_element_properties(model);
}

/// Whether a slit takes a particle away. The first that does has it on its account.
bool is_taken(std::vector<Notch>& notches, const Vector& centre) {
  const auto taker =
      std::find_if(notches.begin(), notches.end(), [&](const Notch& notch) { return is_in_slit(notch, centre); });
  if (taker == notches.end()) return false;
  ++taker->n_taken;
  return true;
}

void add_zone(const ZoneTable& table, const Packing& packing, Model& model) {
  Zone zone;
  zone.name = table.name;
  const Index material = material_row(model, table.material);
  zone.interface_material = table.interface_material ? material_row(model, *table.interface_material) : material;
  zone.detection_gap = table.detection_gap.value_or(table.generator->default_detection_gap());
  zone.interface_gap = table.interface_gap.value_or(table.generator->default_interface_gap());
  const auto zone_row = static_cast<Index>(model.zones.size());
  model.zones.push_back(std::move(zone));

  // The zone weighs what its area does; overlapping discs alone would weigh more.
  const Vector size = rectangle_of(table).size();
  const double mass = model.materials[material].density * model.thickness * component(size, 0) * component(size, 1);
  double squares = 0.0;
  for (const double radius : packing.radius) squares += radius * radius;

  ParticleData& particles = model.particles;
  for (std::size_t i = 0; i < packing.size(); ++i) {
    if (is_taken(model.notches, packing.position[i])) continue;
    const double radius = packing.radius[i];
    particles.position.push_back(packing.position[i]);
    particles.radius.push_back(radius);
    particles.real_mass.push_back(mass * radius * radius / squares);
    particles.material.push_back(material);
    particles.zone.push_back(zone_row);
    particles.id.push_back(static_cast<Index>(particles.size()));
    particles.free.push_back(uniform_vector(1.0));
    particles.rotation_free.push_back(1.0);
  }
}

}  // namespace

Index material_row(const Model& model, const std::string& name) {
  const auto found = std::find_if(model.materials.begin(), model.materials.end(),
                                  [&](const Material& material) { return material.name == name; });
  return static_cast<Index>(found - model.materials.begin());
}

BuiltModel build_model(Case& input) {
  check_case(input);
  BuiltModel built;
  built.model.thickness = input.problem.thickness;
  built.model.plane = input.problem.plane;
  add_materials(input, built.model);
  built.model.notches = build_notches(input);
  add_mesh(input, built.model);
  std::vector<Packing> packings = generate_packings(input);
  for (std::size_t i = 0; i < packings.size(); ++i) {
    const ZoneTable& zone = input.zones[i].table;
    add_zone(zone, packings[i], built.model);
    built.reports.push_back({zone.name, std::move(packings[i].report)});
  }
  input.file.throw_collected_errors();
  add_beams(input, built.model);
  add_walls(input, built.model);
  input.file.throw_collected_errors();
  return built;
}

}  // namespace ligament
