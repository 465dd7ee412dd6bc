#include "ensemble/plan_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "version.hpp"

namespace ligament {
namespace {

std::vector<std::string> keys_of(const EnsembleRequest& request) {
  std::vector<std::string> keys;
  for (const Sweep& sweep : request.sweeps) keys.push_back(sweep.key);
  return keys;
}

std::string list(const std::vector<std::string>& words) {
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ", "));
}

std::string difference_of_words(const char* what, const std::vector<std::string>& before,
                                const std::vector<std::string>& now) {
  return before == now ? "" : fmt::format("{} was {}, now {}", what, list(before), list(now));
}

/// The first line in which two texts of a case differ; empty if none does.
std::string difference_of_texts(const std::string& before, const std::string& now) {
  std::istringstream old_lines(before);
  std::istringstream new_lines(now);
  std::string old_line;
  std::string new_line;
  for (int number = 1;; ++number) {
    const bool has_old = static_cast<bool>(std::getline(old_lines, old_line));
    const bool has_new = static_cast<bool>(std::getline(new_lines, new_line));
    if (!has_old && !has_new) return {};
    if (!has_old) old_line = "(end of the file)";
    if (!has_new) new_line = "(end of the file)";
    if (old_line != new_line) return fmt::format("line {} of the case was '{}', now '{}'", number, old_line, new_line);
  }
}

/// What was there before and is no longer asked for.
template <class Value>
std::string left_out(const std::string& option, const std::vector<Value>& before, const std::vector<Value>& now) {
  std::vector<Value> missing;
  std::copy_if(before.begin(), before.end(), std::back_inserter(missing),
               [&](const Value& value) { return std::find(now.begin(), now.end(), value) == now.end(); });
  return missing.empty() ? "" : fmt::format("{} leaves out {}", option, fmt::join(missing, ", "));
}

}  // namespace

std::string plan_text(const EnsembleRequest& request) {
  nlohmann::ordered_json sweeps = nlohmann::ordered_json::array();
  for (const Sweep& sweep : request.sweeps) sweeps.push_back({{"key", sweep.key}, {"values", sweep.values}});
  const nlohmann::ordered_json plan{{"program", "ligament"},         {"version", program_version()},
                                    {"case", request.case_path},     {"overrides", request.overrides},
                                    {"seeds", request.seeds},        {"sweeps", sweeps},
                                    {"case_text", request.case_text}};
  try {
    return plan.dump(2) + "\n";
  } catch (const nlohmann::json::exception&) {
    throw InputError("the name of the case, overrides and swept values must be UTF-8 text");
  }
}

EnsembleRequest read_plan(const std::filesystem::path& path) {
  try {
    const auto plan = nlohmann::json::parse(read_file(path));
    EnsembleRequest request;
    request.case_path = plan.at("case");
    request.case_text = plan.at("case_text");
    request.seeds = plan.at("seeds").get<std::vector<std::int64_t>>();
    request.overrides = plan.at("overrides").get<std::vector<std::string>>();
    for (const auto& sweep : plan.at("sweeps")) request.sweeps.push_back({sweep.at("key"), sweep.at("values")});
    return request;
  } catch (const nlohmann::json::exception& error) {
    throw FileError(fmt::format("{}: is damaged: {}", path.string(), error.what()));
  }
}

std::string difference(const EnsembleRequest& before, const EnsembleRequest& now) {
  std::string found = difference_of_texts(before.case_text, now.case_text);
  if (found.empty()) found = difference_of_words("--set", before.overrides, now.overrides);
  if (found.empty()) found = difference_of_words("--sweep", keys_of(before), keys_of(now));
  if (found.empty() && before.seeds.empty() != now.seeds.empty()) {
    found = fmt::format("--seeds was {}given before", before.seeds.empty() ? "not " : "");
  }
  if (found.empty()) found = left_out("--seeds", before.seeds, now.seeds);
  for (std::size_t i = 0; found.empty() && i < before.sweeps.size(); ++i) {
    found = left_out("--sweep " + before.sweeps[i].key, before.sweeps[i].values, now.sweeps[i].values);
  }
  return found;
}

}  // namespace ligament
