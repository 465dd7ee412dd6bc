#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ligament {

/// A key of the case and the values that it takes in turn.
struct Sweep {
  std::string key;
  std::vector<std::string> values;
};

/// What is asked of an ensemble: all combinations of seeds and swept values.
struct EnsembleRequest {
  std::string case_path;
  std::string case_text;            ///< of the file, byte for byte
  std::vector<std::int64_t> seeds;  ///< ascending; empty if the seed stays that of the case
  std::vector<Sweep> sweeps;
  std::vector<std::string> overrides;  ///< --set of all runs
};

/// One run of an ensemble.
struct EnsembleMember {
  std::vector<std::string> values;  ///< of the swept keys, in their order
  std::optional<std::int64_t> seed;
  std::string group;  ///< folder of the runs with these values within the ensemble; empty without sweep
  std::string run;    ///< run directory within the ensemble
  std::vector<std::string> overrides;  ///< all of its --set
};

/// The override of the seed, in every case that has one.
inline constexpr const char* seed_key = "generation.seed";

/// Numbers and ranges with both ends, such as "1:4" or "1:3,7"; ascending, each once. InputError for anything else.
std::vector<std::int64_t> parse_seeds(const std::string& text);

/// "key=a,b,c"; commas within brackets, braces and quotes part nothing. InputError for anything else.
Sweep parse_sweep(const std::string& text);

/// The runs, seeds changing fastest. Folders are named by keys and values: `solver.increment=1_um/seed_2`. InputError
/// if a key is given twice, if two values would share a folder, or if there are too many runs.
std::vector<EnsembleMember> members_of(const EnsembleRequest& request);

}  // namespace ligament
