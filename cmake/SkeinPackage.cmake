# Debian packages of what `cmake --install` lays out: skein (programs, data, services), skein-refine (which
# alone needs the libraries of maps and motion planning) and libskein-dev.
#   cmake --build build && cd build && cpack
# What the programs need is asked of them (dpkg-shlibdeps); what the headers need is the table of
# SkeinInstall.cmake.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON) # pack what is built, build nothing
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_PACKAGE_VENDOR "Skein")
set(CPACK_PACKAGE_CONTACT "Skein <skein@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL runtime maps development)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME skein)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION science)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS passwd)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS openssl)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS skein-refine)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "Ground station, decision nodes and simulator as daemons over DDS, the
commands that play and examine missions, and scenarios.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA
    ${SKEIN_CMAKE_DIR}/deb/conffiles ${SKEIN_CMAKE_DIR}/deb/postinst ${SKEIN_CMAKE_DIR}/deb/prerm ${SKEIN_CMAKE_DIR}/deb/postrm)

set(CPACK_DEBIAN_MAPS_PACKAGE_NAME skein-refine)
set(CPACK_DEBIAN_MAPS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_MAPS_PACKAGE_DEPENDS "skein (= ${PROJECT_VERSION})")
set(CPACK_COMPONENT_MAPS_DESCRIPTION "Specialised refiners over maps: ways, tours, sweeps, patrols and viewpoints over measured terrain.")

get_property(skein_development GLOBAL PROPERTY SKEIN_DEVELOPMENT_PACKAGES)
list(REMOVE_DUPLICATES skein_development)
list(JOIN skein_development ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libskein-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Executive, temporal networks, symbolic planner, refiners and what they
stand on, as static libraries with CMake and pkg-config files.")
include(CPack)
