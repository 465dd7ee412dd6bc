#include "ensemble/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "core/error.hpp"
#include "io/case_overrides.hpp"

namespace ligament {
namespace {

/// More are hardly meant.
constexpr std::size_t most_runs = 10000;

/// Pieces between commas that stand in no brackets, braces or quotes.
std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> pieces(1);
  int depth = 0;
  char quote = 0;
  for (const char c : text) {
    if (c == ',' && depth == 0 && quote == 0) {
      pieces.emplace_back();
      continue;
    }
    pieces.back() += c;
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return pieces;
}

std::int64_t seed_in(const std::string& word, const std::string& text) {
  std::int64_t seed = -1;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), seed);
  if (error == std::errc() && end == word.data() + word.size() && seed >= 0) return seed;
  throw InputError(
      fmt::format("--seeds '{}': '{}' is no seed; expected numbers and ranges, such as 1:4 or 1:3,7", text, word));
}

void refuse_too_many(std::size_t n_runs) {
  if (n_runs > most_runs) throw InputError(fmt::format("an ensemble may have {} runs at most", most_runs));
}

/// What a value looks like in the name of a folder.
std::string folder_text(const std::string& value) {
  std::string text;
  for (const char c : value) {
    const bool is_safe = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
                         c == '-' || c == '+' || c == '_';
    if (c != '"' && c != '\'') text += is_safe ? c : '_';
  }
  return text;
}

void check_keys(const EnsembleRequest& request) {
  std::set<std::string> keys;
  const auto add = [&](const std::string& key, const char* where) {
    if (keys.insert(key).second) return;
    throw InputError(fmt::format("{}: '{}' is given twice", where, key));
  };
  for (const std::string& text : request.overrides) keys.insert(parse_override(text).key);
  if (!request.seeds.empty()) add(seed_key, "--seeds");
  for (const Sweep& sweep : request.sweeps) add(sweep.key, "--sweep");
}

void check_folders(const Sweep& sweep) {
  std::set<std::string> folders;
  for (const std::string& value : sweep.values) {
    if (folders.insert(folder_text(value)).second) continue;
    throw InputError(
        fmt::format("--sweep {}: two values would share the folder '{}={}'", sweep.key, sweep.key, folder_text(value)));
  }
}

/// Every member once with each value.
std::vector<EnsembleMember> extended(const std::vector<EnsembleMember>& members, const Sweep& sweep) {
  std::vector<EnsembleMember> more;
  for (const EnsembleMember& member : members) {
    for (const std::string& value : sweep.values) {
      EnsembleMember& next = more.emplace_back(member);
      next.values.push_back(value);
      next.overrides.push_back(sweep.key + "=" + value);
      next.group += fmt::format("{}{}={}", next.group.empty() ? "" : "/", sweep.key, folder_text(value));
    }
    refuse_too_many(more.size());
  }
  return more;
}

EnsembleMember with_seed(EnsembleMember member, std::optional<std::int64_t> seed) {
  const std::string name = seed ? fmt::format("seed_{}", *seed) : "run";
  member.seed = seed;
  if (seed) member.overrides.push_back(fmt::format("{}={}", seed_key, *seed));
  member.run = member.group.empty() ? name : member.group + "/" + name;
  return member;
}

}  // namespace

std::vector<std::int64_t> parse_seeds(const std::string& text) {
  std::set<std::int64_t> seeds;
  for (const std::string& piece : split_at_commas(text)) {
    const std::size_t colon = std::min(piece.find(':'), piece.size());
    const std::int64_t first = seed_in(piece.substr(0, colon), text);
    const std::int64_t last = colon == piece.size() ? first : seed_in(piece.substr(colon + 1), text);
    if (last < first) throw InputError(fmt::format("--seeds '{}': {} holds no number", text, piece));
    refuse_too_many(static_cast<std::size_t>(last - first));
    for (std::int64_t seed = first; seed <= last; ++seed) seeds.insert(seed);
  }
  return {seeds.begin(), seeds.end()};
}

Sweep parse_sweep(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string key = text.substr(0, equals);
  Sweep sweep{key, {}};
  if (equals != std::string::npos) sweep.values = split_at_commas(text.substr(equals + 1));
  const bool has_all = std::find(sweep.values.begin(), sweep.values.end(), "") == sweep.values.end();
  if (sweep.values.empty() || !has_all) {
    throw InputError(fmt::format("--sweep '{}': expected key=value,value,…, such as solver.increment=1 um,2 um", text));
  }
  for (const std::string& value : sweep.values) static_cast<void>(parse_override(fmt::format("{}={}", key, value)));
  return sweep;
}

std::vector<EnsembleMember> members_of(const EnsembleRequest& request) {
  check_keys(request);
  std::vector<EnsembleMember> groups(1);
  groups.front().overrides = request.overrides;
  for (const Sweep& sweep : request.sweeps) {
    check_folders(sweep);
    groups = extended(groups, sweep);
  }
  std::vector<EnsembleMember> members;
  refuse_too_many(groups.size() * std::max<std::size_t>(request.seeds.size(), 1));
  for (const EnsembleMember& group : groups) {
    if (request.seeds.empty()) members.push_back(with_seed(group, std::nullopt));
    for (const std::int64_t seed : request.seeds) members.push_back(with_seed(group, seed));
  }
  return members;
}

}  // namespace ligament
