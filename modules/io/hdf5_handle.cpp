#include "io/hdf5_handle.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "core/error.hpp"

namespace ligament {
namespace {

/// Keeps the description nearest to the cause.
herr_t keep_first_description(unsigned position, const H5E_error2_t* error, void* reason) {
  if (position == 0 && error->desc != nullptr) *static_cast<std::string*>(reason) = error->desc;
  return 0;
}

std::string failure_reason() {
  std::string reason = "unknown HDF5 failure";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first_description, &reason);
  // Descriptions of system calls are long lists that quote the reason.
  constexpr std::string_view quote = "error message = '";
  if (const std::size_t begin = reason.find(quote); begin != std::string::npos) {
    reason.erase(0, begin + quote.size());
    reason.erase(std::min(reason.find('\''), reason.size()));
  }
  return reason;
}

}  // namespace

Hdf5Checker::Hdf5Checker(std::filesystem::path path) : path_(std::move(path)) {
  H5Eget_auto2(H5E_DEFAULT, &former_printer_, &former_argument_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Checker::~Hdf5Checker() { H5Eset_auto2(H5E_DEFAULT, former_printer_, former_argument_); }

Hdf5Handle Hdf5Checker::own(hid_t id, Hdf5Handle::Release release, std::string_view action) const {
  expect(id, action);
  return {id, release};
}

void Hdf5Checker::expect(std::int64_t returned, std::string_view action) const {
  if (returned < 0) throw FileError(fmt::format("cannot {} {}: {}", action, path_.string(), failure_reason()));
}

}  // namespace ligament
