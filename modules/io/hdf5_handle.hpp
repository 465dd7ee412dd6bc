#pragma once

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <utility>

namespace ligament {

/// Owns one HDF5 identifier and the function that releases it.
class Hdf5Handle {
 public:
  using Release = herr_t (*)(hid_t);

  Hdf5Handle(hid_t id, Release release) : id_(id), release_(release) {}
  ~Hdf5Handle() {
    if (id_ >= 0) release_(id_);
  }
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), release_(other.release_) {}
  Hdf5Handle& operator=(Hdf5Handle&&) = delete;

  [[nodiscard]] hid_t get() const { return id_; }

 private:
  hid_t id_;
  Release release_;
};

/// Turns failures of the HDF5 library on one file into FileError. While one lives, the library prints nothing itself.
class Hdf5Checker {
 public:
  explicit Hdf5Checker(std::filesystem::path path);
  Hdf5Checker(const Hdf5Checker&) = delete;
  Hdf5Checker& operator=(const Hdf5Checker&) = delete;
  ~Hdf5Checker();

  /// Passes a good identifier on to a handle; FileError "cannot <action> <path>: <reason given by HDF5>" for a bad one.
  [[nodiscard]] Hdf5Handle own(hid_t id, Hdf5Handle::Release release, std::string_view action) const;
  /// FileError if a call returned a negative value.
  void expect(std::int64_t returned, std::string_view action) const;

 private:
  std::filesystem::path path_;
  H5E_auto2_t former_printer_ = nullptr;
  void* former_argument_ = nullptr;
};

}  // namespace ligament
