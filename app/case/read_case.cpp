#include "case/all_generators.hpp"
#include "case/assembly_properties.hpp"
#include "case/case.hpp"
#include "constitutive/register_laws.hpp"
#include "core/text_hash.hpp"
#include "integrator/register_methods.hpp"

namespace ligament {
namespace {

constexpr const char* default_method = "dynamic_relaxation";
/// Converged to what elastic cases need, unless the case says otherwise.
constexpr double default_force_ratio = 1e-6;

template <class Table>
void read_single(CaseFile& file, const std::string& name, Table& table) {
  Parameters parameters;
  table.declare(parameters);
  file.read(file.table(name), parameters);
}

/// Reads an array of tables whose elements differ in nothing but values.
template <class Table>
std::vector<Read<Table>> read_array(CaseFile& file, const std::string& name) {
  std::vector<Read<Table>> tables;
  for (const TableView& view : file.array_of_tables(name)) {
    Table table;
    table.name = view.name();
    Parameters parameters;
    table.declare(parameters);
    file.read(view, parameters);
    tables.push_back({std::move(table), view});
  }
  return tables;
}

/// Reads a table together with the keys of the product that one of them names, and returns that name; the product stays
/// empty if it is wrong.
template <class Table, class Interface, class Pointer>
std::string read_with_choice(CaseFile& file, const TableView& view, Table& table, const Registry<Interface>& registry,
                             const std::string& selector, Pointer& product,
                             const std::optional<std::string>& fallback = std::nullopt) {
  Parameters parameters;
  table.declare(parameters);
  const auto choice = file.peek(view, selector, registry.names(), fallback);
  if (choice) {
    product = registry.create(*choice);
    product->declare(parameters);
  }
  file.read(view, parameters);
  return choice.value_or("");
}

std::vector<Read<MaterialTable>> read_materials(CaseFile& file) {
  std::vector<Read<MaterialTable>> materials;
  const auto laws = contact_laws();
  for (const TableView& view : file.named_tables("material")) {
    MaterialTable material;
    material.name = view.name();
    read_with_choice(file, view, material, laws, "law", material.law);
    materials.push_back({std::move(material), view});
  }
  return materials;
}

std::vector<Read<ZoneTable>> read_zones(CaseFile& file, const std::shared_ptr<InputFiles>& files) {
  std::vector<Read<ZoneTable>> zones;
  for (const TableView& view : file.array_of_tables("zone")) {
    ZoneTable zone;
    zone.name = view.name();
    zone.generator_name =
        read_with_choice(file, view, zone, all_generators(files, zone.name), "generator", zone.generator);
    zones.push_back({std::move(zone), view});
  }
  return zones;
}

void read_solver(CaseFile& file, SolverTable& solver) {
  const TableView view = file.table("solver");
  const auto loadings = loading_methods();
  std::vector<std::string> methods = solver_methods().names();
  for (const std::string& name : loadings.names()) methods.push_back(name);
  const auto method = file.peek(view, "method", methods, default_method);
  if (!method) return;
  solver.method = *method;
  // Increments of loading are no integrator.
  if (loadings.contains(solver.method)) {
    solver.unbalanced_force_ratio = loadings.create(solver.method)->usual_force_ratio();
    read_with_choice(file, view, solver, loadings, "method", solver.loading);
    return;
  }
  if (solver.method == default_method) solver.unbalanced_force_ratio = default_force_ratio;
  read_with_choice(file, view, solver, solver_methods(), "method", solver.integrator, default_method);
}

}  // namespace

Case read_case(const std::filesystem::path& path, const std::vector<std::string>& overrides, const FileCopies& copies) {
  return read_case(CaseFile::load(path, overrides), InputFiles(path.parent_path(), copies));
}

Case read_case(CaseFile case_file, InputFiles files) {
  Case input(std::move(case_file), std::move(files));
  CaseFile& file = input.file;
  Parameters top;
  top.text("title", input.title, "what the case is about");
  file.read(file.top_level(), top);
  read_single(file, "problem", input.problem);
  input.materials = read_materials(file);
  if (file.has("mesh")) {
    MeshTable mesh;
    read_single(file, "mesh", mesh);
    input.mesh.emplace(Read<MeshTable>{std::move(mesh), file.table("mesh")});
  }
  read_single(file, "contact", input.contact);
  read_single(file, "generation", input.generation);
  input.zones = read_zones(file, input.files);
  input.notches = read_array<NotchTable>(file, "notch");
  input.beams = read_array<BeamTable>(file, "beam");
  input.walls = read_array<WallTable>(file, "wall");
  input.supports = read_array<SupportTable>(file, "support");
  input.motions = read_array<MotionTable>(file, "motion");
  input.loads = read_array<LoadTable>(file, "load");
  input.gauges = read_array<GaugeTable>(file, "gauge");
  if (input.problem.kind == CaseKind::assembly_properties || file.has("properties")) {
    read_single(file, "properties", input.properties);
  }
  if (input.problem.kind != CaseKind::assembly_properties && file.has("properties")) {
    file.add_error(file.position(file.table("properties")), "[properties] is for kind = \"assembly_properties\" alone");
  }
  if (input.problem.kind == CaseKind::uniaxial) {
    UniaxialTable uniaxial;
    read_single(file, "uniaxial", uniaxial);
    input.uniaxial.emplace(Read<UniaxialTable>{std::move(uniaxial), file.table("uniaxial")});
  } else if (file.has("uniaxial")) {
    file.add_error(file.position(file.table("uniaxial")), "[uniaxial] is for kind = \"uniaxial\" alone");
    file.leave_unchecked(file.table("uniaxial"));
  }
  read_solver(file, input.solver);
  if (file.has("stop")) {
    StopTable stop;
    read_single(file, "stop", stop);
    input.stop.emplace(Read<StopTable>{std::move(stop), file.table("stop")});
  }
  input.limits = read_array<LimitTable>(file, "limit");
  read_single(file, "output", input.output);
  read_single(file, "checkpoint", input.checkpoint);
  read_single(file, "audit", input.audit);
  file.throw_if_errors();
  if (input.problem.kind == CaseKind::assembly_properties) {
    set_up_assembly_properties(input);
    file.throw_collected_errors();
  }
  return input;
}

std::string case_hash(const Case& input) {
  std::string text = input.file.resolved_text();
  for (const auto& [path, content] : input.files->contents()) text += path + '\n' + text_hash(content) + '\n';
  return text_hash(text);
}

}  // namespace ligament
