#include <fmt/format.h>

#include <memory>

#include "commands/commands.hpp"
#include "io/checkpoint_file.hpp"
#include "io/fields_vtkhdf.hpp"

namespace ligament {
namespace {

ExitCode info(const std::filesystem::path& path) {
  if (path.extension() == ".hdf") {
    const FieldStamp stamp = read_field_stamp(path);
    fmt::print("{}: fields (VTKHDF) at step {}, time {} s\n", path.string(), stamp.step, stamp.time_s);
    return ExitCode::done;
  }
  const CheckpointHeader header = read_checkpoint_header(path);
  fmt::print(
      "{}: checkpoint at step {}, time {} s\n"
      "  run          {}\n  case hash    {}\n  state hash   {}\n  written by   ligament {} ({}), {}, Boost {}\n",
      path.string(), header.step, header.time, header.run_id, header.case_hash, header.state_hash,
      header.program_version, header.build, header.compiler, header.boost_version);
  for (const auto& [name, length] : header.array_lengths) {
    if (length > 0) fmt::print("  {:<42} {:>10}\n", name, length);
  }
  return ExitCode::done;
}

}  // namespace

void add_info_command(CLI::App& app, Action& action) {
  auto path = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("info", "what a checkpoint or field file is and where it came from");
  command->add_option("file", *path, "checkpoint (.ckpt) or field file (.hdf)")->required()->type_name("FILE");
  command->callback([path, &action] { action = [path] { return info(*path); }; });
}

}  // namespace ligament
