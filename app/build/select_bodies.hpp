#pragma once

#include <vector>

#include "case/case.hpp"
#include "core/model.hpp"

namespace ligament {

/// Rows of the bodies that a table of the case names.
struct SelectedBodies {
  std::vector<Index> nodes;
  std::vector<Index> particles;
};

/// Finds them; numbers that do not exist, or that a zone has replaced, and places without a node become errors of the
/// case file.
SelectedBodies select_bodies(const Model& model, const BodySelection& selection, CaseFile& file, const TableView& view);

/// The end nodes of a wall; if there is none of this name, nothing, and an error of the case file at this key.
std::optional<std::array<Index, 2>> find_wall(const Model& model, const std::string& name, CaseFile& file,
                                              const TableView& view, const char* key);

/// The row of the body with this number in a table of ids; -1 if there is none.
Index row_of_id(const Field<Index>& ids, std::int64_t id);

}  // namespace ligament
