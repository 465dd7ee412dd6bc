#pragma once

#include <filesystem>

#include "core/model.hpp"
#include "core/state.hpp"
#include "io/field_series.hpp"
#include "io/fields_vtkhdf.hpp"

namespace ligament {

/// The state as groups of fields for ParaView and other programs: discs at their centres, elements; contacts,
/// walls and beams as lines. Points are positions at rest.
FieldGroup particle_fields(const Model& model, const State& state);
FieldGroup element_fields(const Model& model, const State& state);
FieldGroup contact_fields(const Model& model, const State& state);
FieldGroup wall_fields(const Model& model, const State& state);
FieldGroup beam_fields(const Model& model, const State& state);

/// The folder fields/ of a run: one immutable file per group and output, and their time series.
class FieldOutput {
 public:
  explicit FieldOutput(const std::filesystem::path& folder);

  /// Drops what is later than this step; -1 drops everything.
  void resume(std::int64_t last_step);
  /// Takes the fields of this state, to be written by the next flush().
  void add(const Model& model, const State& state);
  /// Writes what waits; on FileError the rest waits on.
  void flush();
  /// Bytes of the files that wait.
  [[nodiscard]] std::size_t n_waiting() const;

 private:
  FieldSeries particles_;
  FieldSeries elements_;
  FieldSeries contacts_;
  FieldSeries walls_;
  FieldSeries beams_;
};

}  // namespace ligament
