#pragma once

#include <string>
#include <vector>

#include "io/case_node.hpp"
#include "io/case_resolved.hpp"

namespace ligament {

/// One table that was asked for, and what became of its keys.
struct CaseTable {
  /// "[material.concrete]", "[[zone]]"; empty for the keys at the top of the file.
  std::string header;
  /// "concrete", the `name` of an element of an array, "problem"; empty for the keys at the top.
  std::string name;
  /// For messages: "in [material.concrete]", "in [[zone]] 'middle'".
  std::string where;
  /// Null if the file does not have the table.
  const CaseNode* node = nullptr;
  SourcePosition position;
  /// The keys that were asked for.
  std::vector<std::string> known;
  /// Keys nobody asked for are not reported: which ones there can be is unknown.
  bool is_unchecked = false;
  ResolvedKeys resolved;
};

/// A table of a case file, as handed out by CaseFile, which must outlive it.
class TableView {
 public:
  explicit TableView(CaseTable& table) : table_(&table) {}

  /// "concrete" of [material.concrete], the `name` of an element of an array, "problem" of [problem].
  [[nodiscard]] const std::string& name() const { return table_->name; }
  /// For messages: "in [material.concrete]", "in [[zone]] 'middle'".
  [[nodiscard]] const std::string& where() const { return table_->where; }
  /// Whether the file has the table; if not, reading it gives the defaults.
  [[nodiscard]] bool present() const { return table_->node != nullptr; }

 private:
  friend class CaseFile;
  CaseTable* table_;
};

}  // namespace ligament
