#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/case_node.hpp"

namespace ligament {

/// The errors of meaning of a case, collected so that the user sees them all at once.
class CaseErrors {
 public:
  /// An error already there (same place, same message) is not added again.
  void add(SourcePosition position, std::string message);
  [[nodiscard]] bool empty() const { return errors_.empty(); }
  /// One line per error, `file:line:column: message`: the file as a whole, its lines in order, then the --set ones.
  [[nodiscard]] std::string text(std::string_view file_name) const;

 private:
  struct Item {
    SourcePosition position;
    std::string message;
  };
  std::vector<Item> errors_;
};

}  // namespace ligament
