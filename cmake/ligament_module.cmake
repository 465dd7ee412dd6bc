# Headers that nearly every source includes, read once for each target. They spare the compiler a third of its time; a
# source still includes what it uses: the preset `tidy` compiles without them.
function(ligament_precompile_headers target)
  target_precompile_headers(${target} PRIVATE
    <algorithm> <array> <cmath> <filesystem> <functional> <memory> <optional> <string> <utility> <vector> ${ARGN})
endfunction()

# Sources that are small beside the headers they include are compiled several at a time, in half the time. The presets
# "debug" and "tidy" compile each alone, so that each includes what it uses and a change of one is soon built.
option(LIGAMENT_BATCHES "Compile the driver and io several sources at a time" ON)
function(ligament_compile_in_batches target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${LIGAMENT_BATCHES} UNITY_BUILD_BATCH_SIZE 8)
endfunction()

# A module is one folder and one static library. It sees core and what is named here, never another module.
function(ligament_module name)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  add_library(ligament_${name} STATIC ${sources})
  target_include_directories(ligament_${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(ligament_${name} PUBLIC ligament_options ${ARGN})
  ligament_precompile_headers(ligament_${name})
endfunction()

# A test program: the doctest cases of one folder, each registered with ctest. The doctest suite of a case becomes its
# ctest label: those of the suite "slow" are left out of short forms.
function(ligament_test folder)
  string(REPLACE "/" "_" name ${folder})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
  add_executable(test_${name} ${sources})
  target_include_directories(test_${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(test_${name} PRIVATE ligament_doctest_main Eigen3::Eigen ${ARGN})
  ligament_precompile_headers(test_${name} <doctest/doctest.h>)
  target_compile_definitions(test_${name} PRIVATE
    LIGAMENT_SOURCE_DIR="${PROJECT_SOURCE_DIR}" LIGAMENT_TEST_SCRATCH="${CMAKE_BINARY_DIR}/scratch")
  # Compiling tests takes longer than running them.
  if(LIGAMENT_SANITIZE OR LIGAMENT_SANITIZE_THREADS)
    target_compile_options(test_${name} PRIVATE -O0)
  elseif(NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
    target_compile_options(test_${name} PRIVATE -O1)
  endif()
  # A name that selects no test case would pass unnoticed.
  doctest_discover_tests(test_${name} TEST_PREFIX "${name}: " ADD_LABELS 1
    PROPERTIES FAIL_REGULAR_EXPRESSION "test cases: +0 " TIMEOUT 600)
endfunction()
