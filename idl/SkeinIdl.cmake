# What the IDL compilers make of idl/*.idl, for tests and benchmarks (the product reads and writes CDR
# itself, see libs/blackboard/README.md): libraries
#   skein_idl_fastdds    headers <fastdds/state.h>, <fastdds/statePubSubTypes.h>, …
#   skein_idl_cyclone    headers <cyclone/state.h>, …
set(SKEIN_IDL_DIR ${CMAKE_CURRENT_LIST_DIR})
set(SKEIN_IDL_FILES common state event stream)
set(SKEIN_IDL_GENERATE ${CMAKE_CURRENT_LIST_DIR}/generate.sh)

# skein_add_idl_library(NAME TOOL DIRECTORY SUFFIXES…): generates at build time, compiles without our
# warnings. Of SKEIN_IDL_FILES in SKEIN_IDL_DIR, as they are set where it is called.
function(skein_add_idl_library name tool directory)
  set(output ${CMAKE_BINARY_DIR}/idl/${directory})
  set(generated)
  foreach(file IN LISTS SKEIN_IDL_FILES)
    foreach(suffix IN LISTS ARGN)
      list(APPEND generated ${output}/${file}${suffix})
    endforeach()
  endforeach()
  set(idl ${SKEIN_IDL_FILES})
  list(TRANSFORM idl APPEND .idl)
  set(idl_paths ${idl})
  list(TRANSFORM idl_paths PREPEND ${SKEIN_IDL_DIR}/)
  add_custom_command(
    OUTPUT ${generated}
    COMMAND ${SKEIN_IDL_GENERATE} ${tool} ${SKEIN_IDL_DIR} ${output} ${idl}
    DEPENDS ${idl_paths} ${SKEIN_IDL_GENERATE}
    COMMENT "${tool} for ${name}"
    VERBATIM)
  add_library(${name} STATIC EXCLUDE_FROM_ALL ${generated})
  target_include_directories(${name} SYSTEM PUBLIC ${CMAKE_BINARY_DIR}/idl ${output})
endfunction()

if(NOT TARGET skein_idl_fastdds)
  find_package(fastcdr REQUIRED)
  find_package(fastrtps REQUIRED)
  skein_add_idl_library(skein_idl_fastdds fastddsgen fastdds .cxx PubSubTypes.cxx)
  target_link_libraries(skein_idl_fastdds PUBLIC fastrtps fastcdr)
endif()
if(NOT TARGET skein_idl_cyclone)
  enable_language(C)
  find_package(CycloneDDS REQUIRED)
  skein_add_idl_library(skein_idl_cyclone idlc cyclone .c)
  target_link_libraries(skein_idl_cyclone PUBLIC CycloneDDS::ddsc)
endif()
