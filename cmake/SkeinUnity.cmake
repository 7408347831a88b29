# Unity builds (SKEIN_UNITY, on in all presets but dev): up to eight neighbouring sources of a target are
# compiled as one, which halves the processor time of a full build.
#
# Sources whose own names (of an unnamed namespace, or made visible by `using`) collide with those of a
# neighbour are listed in cmake/compiled_apart.txt, a path a line, and are compiled by themselves. The
# preset dev compiles every source so.
option(SKEIN_UNITY "Compile neighbouring sources together" OFF)
set(SKEIN_UNITY_BATCH 8)

file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/compiled_apart.txt SKEIN_COMPILED_APART REGEX "^[^#]")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/compiled_apart.txt)

# skein_compile_together(TARGET): puts the sources of the target into groups, eight in the order in which
# they are listed and of one folder; who is compiled apart leaves a place empty, so that others stay where
# they were.
function(skein_compile_together target)
  if(NOT SKEIN_UNITY)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources EXCLUDE REGEX "^\\$<")
  file(RELATIVE_PATH here ${CMAKE_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  foreach(source IN LISTS sources)
    get_filename_component(folder ${source} DIRECTORY)
    string(MAKE_C_IDENTIFIER "${folder}" folder)
    if(NOT DEFINED count_${folder})
      set(count_${folder} 0)
    endif()
    math(EXPR number "${count_${folder}} / ${SKEIN_UNITY_BATCH}")
    math(EXPR count_${folder} "${count_${folder}} + 1")
    if(NOT "${here}/${source}" IN_LIST SKEIN_COMPILED_APART)
      list(APPEND members_${folder}_${number} ${source})
      list(APPEND groups ${folder}_${number})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES groups)
  foreach(group IN LISTS groups)
    list(LENGTH members_${group} length)
    if(length GREATER 1)
      set_source_files_properties(${members_${group}} PROPERTIES UNITY_GROUP ${group})
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
