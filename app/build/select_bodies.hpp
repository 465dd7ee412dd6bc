#pragma once

#include <vector>

#include "case/case.hpp"
#include "core/model.hpp"

namespace ligament {

/// Rows of the bodies that a table of the case names.
struct SelectedBodies {
  std::vector<Index> nodes;
  std::vector<Index> particles;
  std::vector<Index> beam_nodes;
  std::vector<Index> platens;  ///< rows of Model::platens
};

/// Finds them; numbers that do not exist, or that a zone has replaced, and places without a node become errors of the
/// case file.
SelectedBodies select_bodies(const Model& model, const BodySelection& selection, CaseFile& file, const TableView& view);

/// A wall by its name; if there is none of this name, nothing, and an error of the case file at this key.
std::optional<std::size_t> find_wall(const Model& model, const std::string& name, CaseFile& file, const TableView& view,
                                     const char* key);

/// A beam, likewise.
const Beam* find_beam(const Model& model, const std::string& name, CaseFile& file, const TableView& view,
                      const char* key);

/// The row of the body with this number in a table of ids; -1 if there is none.
Index row_of_id(const Field<Index>& ids, std::int64_t id);

}  // namespace ligament
