#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "case/case_tables.hpp"
#include "case/input_files.hpp"
#include "io/case_file.hpp"
#include "io/parameter_docs.hpp"

namespace ligament {

/// A table that was read, and where it stands in the file.
template <class Table>
struct Read {
  Table table;
  TableView view;
};

/// A case: everything that its file says.
struct Case {
  Case(CaseFile case_file, InputFiles input_files)
      : file(std::move(case_file)), files(std::make_shared<InputFiles>(std::move(input_files))) {}

  CaseFile file;
  std::shared_ptr<InputFiles> files;  ///< shared with the generators that read one
  std::string title;
  ProblemTable problem;
  std::vector<Read<MaterialTable>> materials;
  std::optional<Read<MeshTable>> mesh;
  ContactTableOfCase contact;
  GenerationTable generation;
  std::vector<Read<ZoneTable>> zones;
  std::vector<Read<NotchTable>> notches;
  std::vector<Read<BeamTable>> beams;
  std::vector<Read<WallTable>> walls;
  std::vector<Read<SupportTable>> supports;
  std::vector<Read<MotionTable>> motions;
  std::vector<Read<LoadTable>> loads;
  std::vector<Read<GaugeTable>> gauges;
  PropertiesTable properties;
  std::optional<Read<UniaxialTable>> uniaxial;  ///< of the kind "uniaxial", and of no other
  SolverTable solver;
  std::optional<Read<StopTable>> stop;
  std::vector<Read<LimitTable>> limits;
  OutputTable output;
  CheckpointTable checkpoint;
  AuditTable audit;
};

/// Reads a case file. Throws InputError with all errors of the file, each with its place. Of files that the case names,
/// `copies` are read where there are any.
Case read_case(const std::filesystem::path& path, const std::vector<std::string>& overrides,
               const FileCopies& copies = {});

/// The same for a case file that is read already.
Case read_case(CaseFile case_file, InputFiles files);

/// All tables and keys there are, for `explain`, the schema and the reference.
std::vector<TableDescription> describe_case();

/// Hash of what the case says, its layout and comments left out, and of the files that were read for it (32 hex
/// digits).
std::string case_hash(const Case& input);

}  // namespace ligament
