#pragma once

#include <fmt/format.h>

#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/closest_name.hpp"
#include "core/error.hpp"

namespace ligament {

/// The implementations of one interface, by the name a case file calls them.
///
/// Entries are added by explicit lists, never by static objects, which linkers drop from static libraries.
template <class Interface>
class Registry {
 public:
  using Factory = std::function<std::unique_ptr<Interface>()>;

  /// `what` names the things registered, in messages: "law", "generator".
  explicit Registry(std::string what) : what_(std::move(what)) {}

  /// Throws std::logic_error if the name is taken.
  void add(std::string name, std::string description, Factory factory) {
    const auto [entry, is_new] =
        entries_.try_emplace(std::move(name), Entry{std::move(description), std::move(factory)});
    if (!is_new) throw std::logic_error(fmt::format("{} '{}' is registered twice", what_, entry->first));
  }

  /// A new object with default parameters. Throws InputError, naming the known ones, if the name is unknown.
  [[nodiscard]] std::unique_ptr<Interface> create(const std::string& name) const { return entry(name).factory(); }

  /// One line of prose. Throws InputError if the name is unknown.
  [[nodiscard]] const std::string& description(const std::string& name) const { return entry(name).description; }

  [[nodiscard]] bool contains(const std::string& name) const { return entries_.count(name) > 0; }

  /// In alphabetical order.
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& [name, entry] : entries_) all.push_back(name);
    return all;
  }

  [[nodiscard]] const std::string& what() const { return what_; }

 private:
  struct Entry {
    std::string description;
    Factory factory;
  };

  const Entry& entry(const std::string& name) const {
    const auto found = entries_.find(name);
    if (found != entries_.end()) return found->second;
    throw InputError(
        fmt::format("unknown {} '{}': known are {}{}", what_, name, quoted_list(names()), did_you_mean(name, names())));
  }

  std::string what_;
  std::map<std::string, Entry> entries_;
};

}  // namespace ligament
