# skein_add_library: the one way to declare a library, with what it depends on and its tests.
#
#   skein_add_library(executive
#     SOURCES src/a.cpp src/b.cpp          # listed, never globbed
#     DEPENDS foundation                    # skein libraries its public headers may include
#     TYPES auction                         # likewise, but for types alone: nothing of them is linked
#     PRIVATE_DEPENDS nlohmann_json::nlohmann_json   # other targets, used in its .cpp files only
#     PUBLIC_DEPENDS tl::expected           # other targets its public headers include
#     TESTS test/a_test.cpp                 # one GoogleTest program, skein_<name>_test
#     TEST_DEPENDS rapidcheck)              # other targets of that program, libraries as skein::NAME
#
# The declared skein dependencies are written to the global property SKEIN_DEPENDS_<name>; the
# architecture test (tests/architecture) compares them with the include directives and with the
# layers of spec 1.6.
set_property(GLOBAL PROPERTY SKEIN_LIBRARIES "")
set(SKEIN_CMAKE_DIR ${CMAKE_CURRENT_LIST_DIR})

function(skein_add_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;TYPES;PUBLIC_DEPENDS;PRIVATE_DEPENDS;TESTS;TEST_DEPENDS;TEST_ARGS" ${ARGN})
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "skein_add_library(${name}): unknown arguments ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  set(target skein_${name})
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(skein::${name} ALIAS ${target})
  target_include_directories(${target}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
  set(own_deps ${ARG_DEPENDS})
  list(TRANSFORM own_deps PREPEND skein::)
  target_link_libraries(${target} PUBLIC ${own_deps} PRIVATE $<BUILD_INTERFACE:skein::options>)
  skein_use_types(${target} ${ARG_TYPES})
  skein_link_system(${target} PUBLIC ${ARG_PUBLIC_DEPENDS})
  skein_link_system(${target} PRIVATE ${ARG_PRIVATE_DEPENDS})

  set_property(GLOBAL APPEND PROPERTY SKEIN_LIBRARIES ${name})
  set_property(GLOBAL PROPERTY SKEIN_DEPENDS_${name} "${ARG_DEPENDS}")
  set_property(GLOBAL PROPERTY SKEIN_TYPES_${name} "${ARG_TYPES}")
  set(test_deps ${ARG_TEST_DEPENDS})
  list(FILTER test_deps INCLUDE REGEX "^skein::")
  list(REMOVE_ITEM test_deps skein::test_cases)
  list(TRANSFORM test_deps REPLACE "^skein::" "")
  set_property(GLOBAL PROPERTY SKEIN_TEST_DEPENDS_${name} "${test_deps}")
  set_property(GLOBAL PROPERTY SKEIN_SOURCE_DIR_${name} ${CMAKE_CURRENT_SOURCE_DIR})

  if(CMAKE_CURRENT_SOURCE_DIR MATCHES "^${CMAKE_SOURCE_DIR}/libs/")
    skein_install_library(${name} DEPENDS ${ARG_DEPENDS} PACKAGES ${ARG_PUBLIC_DEPENDS} ${ARG_PRIVATE_DEPENDS})
  endif()
  skein_share_prelude()
  target_compile_options(${target} PRIVATE ${SKEIN_PRELUDE_OPTIONS})
  target_precompile_headers(${target} REUSE_FROM skein_prelude)
  skein_compile_together(${target})
  skein_link_alone(${target})
  if(SKEIN_BUILD_TESTS AND ARG_TESTS)
    skein_add_test(${target}_test SOURCES ${ARG_TESTS} DEPENDS skein::${name} ${ARG_TEST_DEPENDS})
    target_include_directories(${target}_test PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src
                                                      ${CMAKE_CURRENT_SOURCE_DIR}/test)
  endif()
endfunction()

# One precompiled header for all libraries: a third of their compile time. Eigen is in it because most
# public headers of the geometry include it; who does not declare Eigen may still not include it.
# Read from there, the standard headers are no system headers any more to g++ 12, whose false alarms about
# bounds of strings that it inlined then count.
set(SKEIN_PRELUDE_OPTIONS
  $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>
  $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overread> $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)

function(skein_share_prelude)
  if(TARGET skein_prelude)
    return()
  endif()
  find_package(Eigen3 REQUIRED)
  find_package(tl-expected REQUIRED)
  add_library(skein_prelude STATIC EXCLUDE_FROM_ALL ${SKEIN_CMAKE_DIR}/prelude.cpp)
  target_link_libraries(skein_prelude PRIVATE skein::options)
  skein_link_system(skein_prelude PRIVATE Eigen3::Eigen tl::expected)
  target_compile_options(skein_prelude PRIVATE ${SKEIN_PRELUDE_OPTIONS})
  target_precompile_headers(skein_prelude PRIVATE ${SKEIN_CMAKE_DIR}/prelude.hpp)
endfunction()

# Links a program of tests by gold (of binutils, as ld is), in half the processor time. What is installed
# is linked by ld; so is everything with sanitizers, and where there is no gold.
find_program(SKEIN_GOLD ld.gold)
function(skein_link_soon target)
  if(SKEIN_GOLD AND NOT SKEIN_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_link_options(${target} PRIVATE -fuse-ld=gold)
  endif()
endfunction()

# A program of the whole library and of what it declares, nothing else: what the library uses without
# declaring it is undefined here, whatever the tests and programs beside it are linked with.
function(skein_link_alone target)
  if(NOT SKEIN_BUILD_TESTS OR SKEIN_SANITIZE)
    return()
  endif()
  add_executable(${target}_alone ${SKEIN_CMAKE_DIR}/alone.cpp)
  skein_link_soon(${target}_alone)
  target_link_libraries(${target}_alone PRIVATE "$<LINK_LIBRARY:WHOLE_ARCHIVE,${target}>")
  set_target_properties(${target}_alone PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/alone)
endfunction()

# Makes the headers of libraries known and links nothing of them: a scenario has the team's configuration
# as a value, and a daemon that reads scenarios need not compile the market. `skein_NAME_alone` does not
# link where more than types and inline functions was used.
function(skein_use_types target)
  foreach(name IN LISTS ARGN)
    target_include_directories(${target} PUBLIC
      $<BUILD_INTERFACE:$<TARGET_PROPERTY:skein_${name},INTERFACE_INCLUDE_DIRECTORIES>>)
  endforeach()
endfunction()

# Links targets that are not ours; their headers count as system headers (no warnings from them).
function(skein_link_system target scope)
  foreach(dependency IN LISTS ARGN)
    target_link_libraries(${target} ${scope} ${dependency})
    if(TARGET ${dependency})
      get_target_property(dirs ${dependency} INTERFACE_INCLUDE_DIRECTORIES)
      if(dirs)
        target_include_directories(${target} SYSTEM ${scope} "$<BUILD_INTERFACE:${dirs}>")
      endif()
    endif()
  endforeach()
endfunction()

# What tests share: #include "test_cases.hpp" (more in the long form of the checks), "temporary_folder.hpp",
# "level_world.hpp", "processor_time.hpp" (budgets).
add_library(skein_test_cases INTERFACE)
add_library(skein::test_cases ALIAS skein_test_cases)
target_include_directories(skein_test_cases INTERFACE ${CMAKE_CURRENT_LIST_DIR})

# skein_add_test(NAME SOURCES … DEPENDS … [LABELS …] [TIMEOUT S]): a GoogleTest program, one ctest
# entry for the whole program. The root of the source tree is compiled in as SKEIN_SOURCE_DIR.
# Test code is compiled with little optimisation and over one precompiled header: half the time of the
# whole build, and what is measured is never test code.
function(skein_share_test_prelude)
  if(TARGET skein_test_prelude)
    return()
  endif()
  find_package(GTest REQUIRED)
  # A program, since code of programs is compiled otherwise (-fPIE) than that of libraries.
  add_executable(skein_test_prelude EXCLUDE_FROM_ALL ${CMAKE_SOURCE_DIR}/cmake/test_prelude.cpp)
  target_link_libraries(skein_test_prelude PRIVATE skein::options GTest::gmock GTest::gtest_main)
  target_compile_options(skein_test_prelude PRIVATE ${SKEIN_TEST_OPTIONS})
  target_precompile_headers(skein_test_prelude PRIVATE ${CMAKE_SOURCE_DIR}/cmake/test_prelude.hpp)
endfunction()

function(skein_add_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;DEPENDS;LABELS;COMMAND" ${ARGN})
  find_package(GTest REQUIRED)
  skein_share_test_prelude()
  add_executable(${name} ${ARG_SOURCES})
  skein_link_soon(${name})
  target_link_libraries(${name} PRIVATE skein::options ${ARG_DEPENDS} GTest::gmock GTest::gtest_main)
  target_compile_options(${name} PRIVATE ${SKEIN_TEST_OPTIONS})
  target_precompile_headers(${name} REUSE_FROM skein_test_prelude)
  skein_compile_together(${name})
  target_compile_definitions(${name} PRIVATE SKEIN_SOURCE_DIR="${CMAKE_SOURCE_DIR}"
                                             SKEIN_BINARY_DIR="${CMAKE_BINARY_DIR}")
  if(NOT ARG_COMMAND)
    set(ARG_COMMAND ${name})
  endif()
  if(NOT ARG_LABELS)
    set(ARG_LABELS unit)
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  add_test(NAME ${name} COMMAND ${ARG_COMMAND})
  set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT ${ARG_TIMEOUT})
endfunction()

# skein_long_cases(NAME CASE…): what needs seconds by its nature, of a program of tests (GoogleTest
# filters). It becomes a ctest entry of its own, NAME_long with the label `long`, and NAME leaves it
# out; the program by itself runs everything.
function(skein_long_cases name)
  if(NOT TARGET ${name})
    return()
  endif()
  list(JOIN ARGN ":" cases)
  get_property(environment TEST ${name} PROPERTY ENVIRONMENT)
  get_property(labels TEST ${name} PROPERTY LABELS)
  list(FILTER labels INCLUDE REGEX "^dds$")
  add_test(NAME ${name}_long COMMAND ${name})
  set_tests_properties(${name}_long PROPERTIES LABELS "long;${labels}" TIMEOUT 300 FAIL_REGULAR_EXPRESSION "Running 0 tests")
  set_property(TEST ${name}_long PROPERTY ENVIRONMENT ${environment} "GTEST_FILTER=${cases}")
  set_property(TEST ${name} PROPERTY ENVIRONMENT ${environment} "GTEST_FILTER=-${cases}")
endfunction()

# skein_add_bench(NAME SOURCES … DEPENDS …): a Google Benchmark program; never run as a test.
function(skein_add_bench name)
  if(NOT SKEIN_BUILD_BENCH)
    return()
  endif()
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  find_package(benchmark REQUIRED)
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE skein::options ${ARG_DEPENDS} benchmark::benchmark)
endfunction()

# skein_add_fuzzer(NAME SOURCES … DEPENDS … CORPUS dir): a libFuzzer program with -DSKEIN_BUILD_FUZZ=ON
# (clang). Without it the same entry point is built as a plain program that replays the corpus, as a test.
function(skein_add_fuzzer name)
  cmake_parse_arguments(ARG "" "CORPUS" "SOURCES;DEPENDS" ${ARGN})
  if(SKEIN_BUILD_FUZZ)
    add_executable(${name} ${ARG_SOURCES})
    target_compile_options(${name} PRIVATE -fsanitize=fuzzer)
    target_link_options(${name} PRIVATE -fsanitize=fuzzer)
    target_link_libraries(${name} PRIVATE skein::options ${ARG_DEPENDS})
  elseif(SKEIN_BUILD_TESTS)
    add_executable(${name} ${ARG_SOURCES} ${CMAKE_SOURCE_DIR}/cmake/replay_corpus.cpp)
    skein_link_soon(${name})
    target_link_libraries(${name} PRIVATE skein::options ${ARG_DEPENDS})
    add_test(NAME ${name}_corpus COMMAND ${name} ${CMAKE_CURRENT_SOURCE_DIR}/${ARG_CORPUS})
    set_tests_properties(${name}_corpus PROPERTIES LABELS unit TIMEOUT 120)
  endif()
endfunction()

# Adds a directory if it exists and, when SKEIN_ONLY is set, only if it is listed there: by its path or
# by its last name.
function(skein_add_subdirectory directory)
  if(NOT EXISTS ${CMAKE_SOURCE_DIR}/${directory}/CMakeLists.txt)
    return()
  endif()
  get_filename_component(name ${directory} NAME)
  if(SKEIN_ONLY AND NOT directory IN_LIST SKEIN_ONLY AND NOT name IN_LIST SKEIN_ONLY)
    return()
  endif()
  add_subdirectory(${CMAKE_SOURCE_DIR}/${directory})
endfunction()
