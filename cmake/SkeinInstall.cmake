# What `cmake --install` puts where, and how others find it.
#
#   find_package(Skein 0.1 REQUIRED COMPONENTS executive temporal)   # targets skein::executive, skein::temporal
#   pkg-config --cflags --libs skein-executive
#
# Every library under libs/ is a component: its archive, its public headers, a file of targets of its
# own and a pkg-config file. A component brings the components it declares and looks up the packages
# these need, and no others: who uses the executive needs neither DDS nor GDAL. Three groups can be
# installed apart: `--component runtime` (programs, data, services), `--component maps` (skein-refine,
# which needs the libraries of maps and motion planning) and `--component development`.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(SKEIN_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Skein)
set_property(GLOBAL PROPERTY SKEIN_COMPONENTS "")

# The Debian packages behind the targets that our libraries link: target, name for find_package, name for
# pkg-config, options of the linker where there is no pkg-config file, Debian package; "-" where none is
# needed.
set(SKEIN_PACKAGES
  "tl::expected|tl-expected|-|-|libexpected-dev"
  "nlohmann_json::nlohmann_json|nlohmann_json|nlohmann_json|-|nlohmann-json3-dev"
  "Eigen3::Eigen|Eigen3|eigen3|-|libeigen3-dev" "EXPAT::EXPAT|EXPAT|expat|-|libexpat1-dev"
  "tsl::robin_map|tsl-robin-map|-|-|robin-map-dev" "fmt::fmt|fmt|fmt|-|libfmt-dev"
  "SQLiteCpp|SQLiteCpp|-|-lSQLiteCpp|libsqlitecpp-dev"
  "ZLIB::ZLIB|ZLIB|zlib|-|zlib1g-dev"
  "PNG::PNG|PNG|libpng|-|libpng-dev" "Threads::Threads|Threads|-|-pthread|-"
  "fastrtps|fastrtps|-|-lfastrtps|libfastrtps-dev" "fastcdr|fastcdr|-|-lfastcdr|libfastcdr-dev"
  "CycloneDDS::ddsc|CycloneDDS|CycloneDDS|-|cyclonedds-dev"
  "GDAL::GDAL|GDAL|gdal|-|libgdal-dev" "yaml-cpp|yaml-cpp|yaml-cpp|-|libyaml-cpp-dev"
  "skein_ompl|-|ompl|-|libompl-dev" "fcl|fcl|fcl|-|libfcl-dev")

# skein_find_packages(OUT COLUMN dependencies…): what a column of the table says of them, without
# repeats. A library given by its path is an option of the linker.
function(skein_find_packages out column)
  set(found "")
  foreach(dependency IN LISTS ARGN)
    set(row ${SKEIN_PACKAGES})
    list(FILTER row INCLUDE REGEX "^${dependency}\\|")
    if(row)
      string(REPLACE "|" ";" row "${row}")
      list(GET row ${column} name)
    elseif(IS_ABSOLUTE "${dependency}")
      set(name -)
      if(column EQUAL 3)
        set(name ${dependency})
      elseif(column EQUAL 4)
        execute_process(COMMAND dpkg-query -S ${dependency} OUTPUT_VARIABLE owner ERROR_QUIET)
        if(owner MATCHES "^([a-z0-9.+-]+)")
          set(name ${CMAKE_MATCH_1})
        endif()
      endif()
    else()
      message(FATAL_ERROR "SKEIN_PACKAGES (cmake/SkeinInstall.cmake) does not say where ${dependency} comes from")
    endif()
    if(NOT name STREQUAL "-")
      list(APPEND found ${name})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES found)
  set(${out} "${found}" PARENT_SCOPE)
endfunction()

# skein_install_library(NAME DEPENDS … PACKAGES …): called by skein_add_library for what lies in libs/.
function(skein_install_library name)
  cmake_parse_arguments(ARG "" "" "DEPENDS;PACKAGES" ${ARGN})
  set(target skein_${name})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS ${target} EXPORT Skein_${name}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
          FILES_MATCHING PATTERN "*.hpp")
  install(EXPORT Skein_${name} NAMESPACE skein:: FILE Skein-${name}.cmake
          DESTINATION ${SKEIN_PACKAGE_DIR} COMPONENT development)
  skein_find_packages(packages 1 ${ARG_PACKAGES})
  set_property(GLOBAL APPEND PROPERTY SKEIN_COMPONENTS ${name})
  set_property(GLOBAL PROPERTY SKEIN_PACKAGES_${name} "${packages}")
  skein_find_packages(debian 4 ${ARG_PACKAGES})
  set_property(GLOBAL APPEND PROPERTY SKEIN_DEVELOPMENT_PACKAGES ${debian})
  skein_write_pkg_config(${name} "${ARG_DEPENDS}" "${ARG_PACKAGES}")
endfunction()

# Archives only: whoever links one needs all that it needs, so nothing is private here.
function(skein_write_pkg_config name depends packages)
  set(SKEIN_PC_NAME ${name})
  skein_find_packages(requires 2 ${packages})
  skein_find_packages(options 3 ${packages})
  list(TRANSFORM depends PREPEND skein-)
  list(JOIN depends " " SKEIN_PC_DEPENDS)
  list(JOIN requires " " SKEIN_PC_PACKAGES)
  list(JOIN options " " SKEIN_PC_LIBS)
  file(RELATIVE_PATH SKEIN_PC_UP /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  configure_file(${SKEIN_CMAKE_DIR}/skein.pc.in ${CMAKE_BINARY_DIR}/package/skein-${name}.pc @ONLY)
  install(FILES ${CMAKE_BINARY_DIR}/package/skein-${name}.pc
          DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endfunction()

# Once every library has been declared.
function(skein_install_package)
  get_property(components GLOBAL PROPERTY SKEIN_COMPONENTS)
  set(SKEIN_COMPONENT_TABLE "set(Skein_ALL_COMPONENTS ${components})\n")
  foreach(name IN LISTS components)
    get_property(depends GLOBAL PROPERTY SKEIN_DEPENDS_${name})
    get_property(packages GLOBAL PROPERTY SKEIN_PACKAGES_${name})
    string(APPEND SKEIN_COMPONENT_TABLE "set(Skein_DEPENDS_${name} ${depends})\n"
                                        "set(Skein_PACKAGES_${name} ${packages})\n")
  endforeach()
  configure_package_config_file(${SKEIN_CMAKE_DIR}/SkeinConfig.cmake.in
    ${CMAKE_BINARY_DIR}/package/SkeinConfig.cmake INSTALL_DESTINATION ${SKEIN_PACKAGE_DIR})
  write_basic_package_version_file(${CMAKE_BINARY_DIR}/package/SkeinConfigVersion.cmake
    VERSION ${PROJECT_VERSION} COMPATIBILITY SameMinorVersion)
  install(FILES ${CMAKE_BINARY_DIR}/package/SkeinConfig.cmake
                ${CMAKE_BINARY_DIR}/package/SkeinConfigVersion.cmake
          DESTINATION ${SKEIN_PACKAGE_DIR} COMPONENT development)
endfunction()

# The programs find each other beside themselves; scenarios and wire types are data. OPTIONAL: who builds
# one daemon for a companion computer installs what is there.
function(skein_install_programs)
  foreach(program skein skein-run skein-live skein-lab skein-tools skein-ground skein-ddn skein-sim skein-mavlink skein-refine)
    set(component runtime)
    if(program STREQUAL "skein-refine")
      set(component maps)
    endif()
    if(TARGET ${program})
      install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${component} OPTIONAL)
    endif()
  endforeach()
  install(PROGRAMS scripts/make-keys DESTINATION ${CMAKE_INSTALL_BINDIR} RENAME skein-make-keys COMPONENT runtime)
  install(DIRECTORY scenarios idl DESTINATION ${CMAKE_INSTALL_DATADIR}/skein COMPONENT runtime
          PATTERN "*.cmake" EXCLUDE)
  set(guides ${CMAKE_BINARY_DIR}/guides)  # cli/CMakeLists.txt makes them
  foreach(section 1 8)
    install(DIRECTORY ${guides}/man${section} DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT runtime OPTIONAL)
  endforeach()
  install(DIRECTORY ${guides}/bash/ DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT runtime OPTIONAL)
  foreach(program skein skein-ground skein-ddn skein-sim skein-mavlink)
    install(FILES ${guides}/zsh/${program} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions
            RENAME _${program} COMPONENT runtime OPTIONAL)
    install(FILES ${guides}/fish/${program} DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
            RENAME ${program}.fish COMPONENT runtime OPTIONAL)
  endforeach()
  install(FILES README.md CHANGELOG.md LICENSE docs/deploy.md docs/daemons.md docs/mavlink.md docs/threats.md docs/exit-codes.md
          DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
  install(DIRECTORY daemons/service/ DESTINATION lib/systemd/system COMPONENT runtime FILES_MATCHING PATTERN "*.service")
  # /etc belongs to /usr, as GNUInstallDirs has it, but what the prefix is shows only at installation.
  install(CODE "string(REGEX REPLACE \"/usr$\" \"\" root \"\${CMAKE_INSTALL_PREFIX}\")
    file(GLOB files \"${CMAKE_SOURCE_DIR}/daemons/service/*.yaml\")
    file(INSTALL DESTINATION \"\${root}/etc/skein\" TYPE FILE FILES \${files})" COMPONENT runtime)
endfunction()
