#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "build/check_case.hpp"
#include "build/generate_packings.hpp"
#include "commands/commands.hpp"
#include "commands/common_options.hpp"
#include "io/assembly_file.hpp"
#include "version.hpp"

namespace ligament {
namespace {

struct GenerateOptions {
  std::string case_path;
  std::string output;
  bool overwrite = false;
  std::vector<std::string> overrides;
};

constexpr const char* table_extension = ".csv";

void check_output(const std::filesystem::path& output, bool overwrite) {
  if (output.extension() != ".h5" && output.extension() != table_extension) {
    throw InputError(fmt::format("{}: the name must end in .h5 or {}", output.string(), table_extension));
  }
  if (std::filesystem::is_directory(output)) throw InputError(fmt::format("{}: is a folder", output.string()));
  if (std::filesystem::exists(output) && !overwrite) {
    throw InputError(fmt::format("{}: exists; --overwrite replaces it", output.string()));
  }
  if (output.has_parent_path() && !std::filesystem::is_directory(output.parent_path())) {
    throw InputError(fmt::format("{}: there is no folder {}", output.string(), output.parent_path().string()));
  }
}

void check_zones(const Case& input, const std::filesystem::path& output) {
  if (input.zones.empty()) throw InputError(fmt::format("{}: has no zone to fill", input.file.file_name()));
  if (input.zones.size() > 1 && output.extension() == table_extension) {
    throw InputError(fmt::format("{}: a table holds one zone, and the case has {}: a name ending in .h5 would do",
                                 output.string(), input.zones.size()));
  }
}

Assemblies assemblies_of(const Case& input, std::vector<Packing> packings) {
  Assemblies assemblies{program_version(), input.file.text(), input.file.resolved_text(), input.generation.seed, {}};
  for (std::size_t i = 0; i < packings.size(); ++i) {
    const ZoneTable& zone = input.zones[i].table;
    assemblies.zones.push_back({zone.name, zone.generator_name, rectangle_of(zone), std::move(packings[i])});
  }
  return assemblies;
}

void print_report(const ZoneAssembly& assembly, std::int64_t seed) {
  const Vector size = assembly.region.size();
  fmt::print("zone {}: {}, {:.6g} m × {:.6g} m, seed {}\n", assembly.zone, assembly.generator, component(size, 0),
             component(size, 1), seed);
  fmt::print("  {:<24}{:>14}{:>14}\n", "", "got", "target");
  for (const ReportEntry& entry : assembly.packing.report) {
    fmt::print("  {:<24}{:>14.6g}{:>14}\n", entry.name, entry.value,
               entry.target ? fmt::format("{:.6g}", *entry.target) : "");
  }
}

ExitCode generate(const GenerateOptions& options) {
  const std::filesystem::path output = options.output;
  check_output(output, options.overwrite);
  Case input = read_case(options.case_path, options.overrides);
  check_case(input);
  check_zones(input, output);
  const Assemblies assemblies = assemblies_of(input, generate_packings(input));
  for (const ZoneAssembly& assembly : assemblies.zones) print_report(assembly, assemblies.seed);
  if (output.extension() == table_extension) {
    write_discs_csv(output, assemblies.zones[0].packing);
  } else {
    write_assemblies_hdf5(output, assemblies);
  }
  fmt::print("written to {}\n", output.string());
  return ExitCode::done;
}

}  // namespace

void add_generate_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<GenerateOptions>();
  CLI::App* command = app.add_subcommand("generate", "the particle assemblies of a case alone, into a file");
  command->add_option("case", options->case_path, "case file (TOML)")->required()->type_name("FILE");
  command->add_option("--output", options->output, "file to write: .h5, or .csv for the discs alone")
      ->required()
      ->type_name("FILE");
  command->add_flag("--overwrite", options->overwrite, "replace the file");
  add_set_option(*command, options->overrides);
  command->callback([options, &action] { action = [options] { return generate(*options); }; });
}

}  // namespace ligament
