#include "io/hdf5_image.hpp"

namespace ligament {
namespace {

/// HDF5 has no texts of length zero.
std::string padded(std::string_view text) { return text.empty() ? std::string(1, '\0') : std::string(text); }

}  // namespace

Hdf5Image::Hdf5Image(const std::filesystem::path& path) : check_(path), file_(create_file(path)) {}

Hdf5Handle Hdf5Image::create_group(hid_t parent, const char* name) const {
  const Hdf5Handle creation = without_times(H5P_GROUP_CREATE);
  return own(H5Gcreate2(parent, name, H5P_DEFAULT, creation.get(), H5P_DEFAULT), H5Gclose);
}

void Hdf5Image::add_attribute(hid_t object, const char* name, std::string_view text) const {
  const std::string content = padded(text);
  const Hdf5Handle type = text_type(content.size(), H5T_CSET_ASCII);
  write_attribute(object, name, {type.get(), type.get()}, 1, content.data());
}

void Hdf5Image::add_text(hid_t parent, const char* name, std::string_view text) const {
  const std::string content = padded(text);
  const Hdf5Handle type = text_type(content.size(), H5T_CSET_UTF8);
  write_dataset(parent, name, {type.get(), type.get()}, 1, 1, content.data());
}

std::string Hdf5Image::bytes() const {
  expect(H5Fflush(file_.get(), H5F_SCOPE_LOCAL));
  const ssize_t size = H5Fget_file_image(file_.get(), nullptr, 0);
  expect(size);
  std::string image(static_cast<std::size_t>(size), '\0');
  expect(H5Fget_file_image(file_.get(), image.data(), image.size()));
  return image;
}

Hdf5Handle Hdf5Image::own(hid_t id, Hdf5Handle::Release release) const { return check_.own(id, release, "write"); }

void Hdf5Image::expect(std::int64_t returned) const { check_.expect(returned, "write"); }

/// Object times would make the bytes depend on the clock on the wall.
Hdf5Handle Hdf5Image::without_times(hid_t property_class) const {
  Hdf5Handle properties = own(H5Pcreate(property_class), H5Pclose);
  expect(H5Pset_obj_track_times(properties.get(), false));
  return properties;
}

Hdf5Handle Hdf5Image::create_file(const std::filesystem::path& path) const {
  constexpr std::size_t growth_in_bytes = 1 << 20;
  constexpr hbool_t on_disk = false;
  const Hdf5Handle access = own(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  expect(H5Pset_fapl_core(access.get(), growth_in_bytes, on_disk));
  const Hdf5Handle creation = without_times(H5P_FILE_CREATE);
  return own(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), H5Fclose);
}

Hdf5Handle Hdf5Image::text_type(std::size_t length, H5T_cset_t encoding) const {
  Hdf5Handle type = own(H5Tcopy(H5T_C_S1), H5Tclose);
  expect(H5Tset_size(type.get(), length));
  expect(H5Tset_strpad(type.get(), H5T_STR_NULLPAD));
  expect(H5Tset_cset(type.get(), encoding));
  return type;
}

Hdf5Handle Hdf5Image::write_dataset(hid_t parent, const char* name, Type type, std::size_t n_rows,
                                    std::size_t n_columns, const void* values) const {
  const std::array<hsize_t, 2> shape{n_rows, n_columns};
  const Hdf5Handle space = own(H5Screate_simple(n_columns == 1 ? 1 : 2, shape.data(), nullptr), H5Sclose);
  const Hdf5Handle properties = without_times(H5P_DATASET_CREATE);
  Hdf5Handle dataset =
      own(H5Dcreate2(parent, name, type.stored, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), H5Dclose);
  expect(H5Dwrite(dataset.get(), type.in_memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
  return dataset;
}

void Hdf5Image::write_attribute(hid_t object, const char* name, Type type, std::size_t length,
                                const void* values) const {
  const hsize_t shape = length;
  const Hdf5Handle space =
      length == 1 ? own(H5Screate(H5S_SCALAR), H5Sclose) : own(H5Screate_simple(1, &shape, nullptr), H5Sclose);
  const Hdf5Handle attribute =
      own(H5Acreate2(object, name, type.stored, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  expect(H5Awrite(attribute.get(), type.in_memory, values));
}

}  // namespace ligament
