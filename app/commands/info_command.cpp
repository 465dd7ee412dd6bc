#include <fmt/format.h>

#include <memory>

#include "commands/commands.hpp"
#include "io/checkpoint_file.hpp"
#include "io/fields_vtkhdf.hpp"

namespace ligament {
namespace {

ExitCode info(const std::filesystem::path& path, bool shows_case) {
  if (path.extension() == ".hdf") {
    const FieldStamp stamp = read_field_stamp(path);
    fmt::print("{}: fields (VTKHDF) at step {}, time {} s\n", path.string(), stamp.step, stamp.time_s);
    return ExitCode::done;
  }
  const CheckpointHeader header = read_checkpoint_header(path);
  fmt::print(
      "{}: checkpoint at step {}, time {} s\n"
      "  run          {}\n  case hash    {}\n  state hash   {}\n"
      "  written by   ligament {} ({}), {}, Boost {}, {} bytes a word\n  seed         {}\n",
      path.string(), header.step, header.time, header.run_id, header.case_hash, header.state_hash,
      header.program_version, header.build, header.compiler, header.boost_version, header.word_size, header.seed);
  for (const std::string& override : header.overrides) fmt::print("  set          {}\n", override);
  for (const auto& [name, hash] : header.inputs) fmt::print("  input        {}, hash {}\n", name, hash);
  if (shows_case) {
    fmt::print("{}", header.case_text);
    return ExitCode::done;
  }
  for (const auto& [name, length] : header.array_lengths) {
    if (length > 0) fmt::print("  {:<42} {:>10}\n", name, length);
  }
  return ExitCode::done;
}

}  // namespace

void add_info_command(CLI::App& app, Action& action) {
  struct Options {
    std::string path;
    bool shows_case = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("info", "what a checkpoint or field file is and where it came from");
  command->add_option("file", options->path, "checkpoint (.ckpt) or field file (.hdf)")->required()->type_name("FILE");
  command->add_flag("--case", options->shows_case, "of a checkpoint: the case that it belongs to, every default in");
  command->callback([options, &action] { action = [options] { return info(options->path, options->shows_case); }; });
}

}  // namespace ligament
