# Every dependency is a Debian package; scripts/install_packages names them.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt 9 REQUIRED)
find_package(Boost 1.74 REQUIRED COMPONENTS serialization)
find_package(HDF5 REQUIRED COMPONENTS C)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(Threads REQUIRED)

# UDUNITS-2 and xxHash ship neither a CMake package nor a find module.
find_path(UDUNITS2_INCLUDE_DIR udunits2.h REQUIRED)
find_library(UDUNITS2_LIBRARY udunits2 REQUIRED)
add_library(udunits2::udunits2 UNKNOWN IMPORTED)
set_target_properties(udunits2::udunits2 PROPERTIES
  IMPORTED_LOCATION ${UDUNITS2_LIBRARY}
  INTERFACE_INCLUDE_DIRECTORIES ${UDUNITS2_INCLUDE_DIR})

find_path(XXHASH_INCLUDE_DIR xxhash.h REQUIRED)
add_library(xxhash::xxhash INTERFACE IMPORTED)
set_target_properties(xxhash::xxhash PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${XXHASH_INCLUDE_DIR})
