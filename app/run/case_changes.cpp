#include "run/case_changes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "core/error.hpp"

namespace ligament {
namespace {

using Keys = std::vector<std::pair<std::string, std::string>>;

constexpr const char* name_key = "name = \"";

/// Keys and values of a resolved text, which has one on a line; elements of arrays go by their name.
Keys keys_of(const std::string& text) {
  Keys keys;
  std::string table;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#') || line.empty()) continue;
    if (line.starts_with('[')) {
      const std::size_t n_brackets = line.starts_with("[[") ? 2 : 1;
      table = line.substr(n_brackets, line.size() - 2 * n_brackets) + ".";
    } else if (line.starts_with(name_key)) {
      const std::size_t begin = std::char_traits<char>::length(name_key);
      table += line.substr(begin, line.size() - begin - 1) + ".";
      keys.emplace_back(table + "name", line.substr(begin - 1));
    } else if (const std::size_t equals = line.find(" = "); equals != std::string::npos) {
      keys.emplace_back(table + line.substr(0, equals), line.substr(equals + 3));
    }
  }
  return keys;
}

std::string value_of(const Keys& keys, const std::string& key) {
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const auto& entry) { return entry.first == key; });
  return found != keys.end() ? found->second : "not given";
}

}  // namespace

std::vector<CaseChange> case_changes(const std::string& before, const std::string& now) {
  const Keys old_keys = keys_of(before);
  const Keys new_keys = keys_of(now);
  std::vector<CaseChange> changes;
  for (const auto& [key, value] : new_keys) {
    if (std::string old_value = value_of(old_keys, key); old_value != value) {
      changes.push_back({key, std::move(old_value), value});
    }
  }
  for (const auto& [key, value] : old_keys) {
    if (std::string new_value = value_of(new_keys, key); new_value == "not given") {
      changes.push_back({key, value, std::move(new_value)});
    }
  }
  return changes;
}

const std::vector<std::string>& changeable_keys() {
  static const std::vector<std::string> keys{
      "title",           "solver.max_steps", "stop.gauge",          "stop.drop_to_share",     "stop.above",
      "stop.below",      "output.every",     "output.fields_every", "output.on_failed_write", "checkpoint.every",
      "checkpoint.keep", "audit.tolerance",  "audit.every_step"};
  return keys;
}

void require_same_run(const std::string& before, const std::string& now) {
  std::string refused;
  for (const CaseChange& change : case_changes(before, now)) {
    const auto& keys = changeable_keys();
    if (std::find(keys.begin(), keys.end(), change.key) != keys.end()) continue;
    refused += fmt::format("\n  {}: {} in the run, {} now", change.key, change.before, change.now);
  }
  if (refused.empty()) return;
  throw InputError(
      fmt::format("a run that is resumed must stay the same run, and the case has changed:{}\nwhat may change is {}",
                  refused, fmt::join(changeable_keys(), ", ")));
}

}  // namespace ligament
