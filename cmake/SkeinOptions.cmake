# Compile options, shared by every target through the interface library skein_options.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# Debian's own flags on -O2; no -g in Release keeps a full build short on two cores.
set(CMAKE_CXX_FLAGS_RELEASE "-O2")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ looks for garbage from 128 MB on, again and again, which takes a tenth of its time; at most 0.2 GB more
  # memory per job (scripts/build reckons with 1.5 GB).
  add_compile_options("SHELL:--param ggc-min-heapsize=1000000")
endif()

# Of test code: little optimised, and without what g++ 12 wrongly suspects in texts that are put together.
set(SKEIN_TEST_OPTIONS $<$<CONFIG:Release>:-Og>
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>
    $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overread> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>)

add_library(skein_options INTERFACE)
add_library(skein::options ALIAS skein_options)
target_compile_options(skein_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wnon-virtual-dtor -Wold-style-cast
  # g++ 12 takes moved-from alternatives of std::variant for uninitialised ones at -O2.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>
  $<$<BOOL:${SKEIN_WERROR}>:-Werror>)
if(SKEIN_SANITIZE)
  add_compile_options(-fsanitize=${SKEIN_SANITIZE} -fno-omit-frame-pointer -g1)
  add_link_options(-fsanitize=${SKEIN_SANITIZE})
  if(SKEIN_SANITIZE MATCHES "undefined")
    add_compile_options(-fno-sanitize-recover=undefined)
  endif()
endif()

if(SKEIN_BUILD_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)  # so that the libraries under test guide the fuzzer
endif()

find_program(SKEIN_CCACHE ccache)
if(SKEIN_CCACHE)
  # The sloppiness is what ccache asks for to keep what was compiled over a precompiled header. None about
  # the times of headers: one that is edited while it is compiled would be kept as it was before.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros ${SKEIN_CCACHE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-fpch-preprocess)
  endif()
endif()
