#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "io/hdf5_handle.hpp"

namespace ligament {

/// Builds an HDF5 file in memory: HDF5 keeps data back until it closes a file, and does not recover from a disk that is
/// full by then, so its own files cannot be written reliably. The bytes depend on what is added alone. FileError names
/// the path that the bytes are meant for.
class Hdf5Image {
 public:
  explicit Hdf5Image(const std::filesystem::path& path);

  [[nodiscard]] hid_t file() const { return file_.get(); }
  [[nodiscard]] Hdf5Handle create_group(hid_t parent, const char* name) const;

  /// Adds a list of values, or a table with rows of `n_columns` if that is more than one.
  template <class Value>
  Hdf5Handle add_dataset(hid_t parent, const char* name, std::span<const Value> values,
                         std::size_t n_columns = 1) const {
    return write_dataset(parent, name, type_of(values.data()), values.size() / n_columns, n_columns, values.data());
  }

  template <class Value>
  void add_attribute(hid_t object, const char* name, std::span<const Value> values) const {
    write_attribute(object, name, type_of(values.data()), values.size(), values.data());
  }
  /// ParaView wants fixed-length ASCII without a terminator.
  void add_attribute(hid_t object, const char* name, std::string_view text) const;

  /// Adds a text of any length, in UTF-8: attributes end at 64 KB.
  void add_text(hid_t parent, const char* name, std::string_view text) const;

  [[nodiscard]] std::string bytes() const;

 private:
  struct Type {
    hid_t stored;
    hid_t in_memory;
  };
  static Type type_of(const double*) { return {H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE}; }
  static Type type_of(const std::int64_t*) { return {H5T_STD_I64LE, H5T_NATIVE_INT64}; }
  static Type type_of(const std::uint8_t*) { return {H5T_STD_U8LE, H5T_NATIVE_UINT8}; }

  [[nodiscard]] Hdf5Handle own(hid_t id, Hdf5Handle::Release release) const;
  void expect(std::int64_t returned) const;
  [[nodiscard]] Hdf5Handle without_times(hid_t property_class) const;
  [[nodiscard]] Hdf5Handle create_file(const std::filesystem::path& path) const;
  [[nodiscard]] Hdf5Handle text_type(std::size_t length, H5T_cset_t encoding) const;
  Hdf5Handle write_dataset(hid_t parent, const char* name, Type type, std::size_t n_rows, std::size_t n_columns,
                           const void* values) const;
  void write_attribute(hid_t object, const char* name, Type type, std::size_t length, const void* values) const;

  Hdf5Checker check_;
  Hdf5Handle file_;
};

}  // namespace ligament
