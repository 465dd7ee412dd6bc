# One interface target carries what every target of the project is compiled with.
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

option(LIGAMENT_AUDIT "Check every step: finite values, motion and transfer audits" OFF)
option(LIGAMENT_SANITIZE "Address and undefined-behaviour sanitizers" OFF)
option(LIGAMENT_SANITIZE_THREADS "Thread sanitizer, for clang" OFF)
option(LIGAMENT_FUZZ "Harnesses of libFuzzer, for clang" OFF)

add_library(ligament_options INTERFACE)
target_compile_features(ligament_options INTERFACE cxx_std_20)
target_compile_options(ligament_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Werror
  # Members that a designated initializer leaves out have their defaults.
  -Wno-missing-field-initializers
  # gcc 12 warns of overlapping copies inside std::string, and of overflows inside fmt, that are none.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>
  # Exact restart asks for the same roundings everywhere: no contraction to fused multiply-adds.
  -ffp-contract=off
  # Nobody asks for errno after a square root; without it a root is one instruction, with the same bits.
  -fno-math-errno)
target_link_libraries(ligament_options INTERFACE Threads::Threads)
if(LIGAMENT_AUDIT)
  target_compile_definitions(ligament_options INTERFACE LIGAMENT_AUDIT=1)
endif()
if(LIGAMENT_SANITIZE)
  # What is left out of "undefined" doubles the time of compilation, and most of it is seen by "address".
  target_compile_options(ligament_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize=null,alignment,object-size,vptr
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(ligament_options INTERFACE -fsanitize=address,undefined)
endif()
if(LIGAMENT_SANITIZE_THREADS)
  # Functions with versions for several instruction sets get theirs before the sanitizer is there: it is not told of calls.
  target_compile_options(ligament_options INTERFACE -fsanitize=thread "SHELL:-mllvm -tsan-instrument-func-entry-exit=0")
  target_link_options(ligament_options INTERFACE -fsanitize=thread)
endif()
if(LIGAMENT_FUZZ)
  # What is covered steers the fuzzer; only its harnesses have its main function.
  target_compile_options(ligament_options INTERFACE -fsanitize=fuzzer-no-link)
  target_link_options(ligament_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
