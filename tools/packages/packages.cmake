# Debian packages, made by cpack: the program, the library with its headers, and the Python package where it is
# built. What binaries depend on dpkg-shlibdeps finds; the archives of the library name theirs below.
set(GEOLLOYD_PACKAGE_CONTACT "The geolloyd authors <geolloyd@example.org>" CACHE STRING
    "Who is named as maintainer of the Debian packages")
set(documents ${CMAKE_CURRENT_BINARY_DIR}/packages)
file(WRITE ${documents}/changelog.txt "geolloyd (${PROJECT_VERSION}-1) unstable; urgency=medium

  * What is new stands in the history of the repository.

 -- ${GEOLLOYD_PACKAGE_CONTACT}  Thu, 01 Jan 2026 00:00:00 +0000
")
file(WRITE ${documents}/copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: geolloyd

Files: *
Copyright: 2026 The geolloyd authors
License: Expat

License: Expat
")
file(STRINGS ${PROJECT_SOURCE_DIR}/LICENSE licence)
list(SUBLIST licence 2 -1 licence)  # without its name and the year
foreach(line IN LISTS licence)
  file(APPEND ${documents}/copyright " ${line}\n")
endforeach()
find_program(gzip gzip)
execute_process(COMMAND ${gzip} -9nc ${documents}/changelog.txt
                OUTPUT_FILE ${documents}/changelog.Debian.gz)
set(components program library)
if(GEOLLOYD_BUILD_PYTHON)
  list(APPEND components python)
endif()
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME geolloyd)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libgeolloyd-dev)
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-geolloyd)
foreach(component IN LISTS components)
  string(TOUPPER ${component} upper)
  set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  install(FILES ${documents}/copyright ${documents}/changelog.Debian.gz
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component}
          EXCLUDE_FROM_ALL)
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME geolloyd)
set(CPACK_PACKAGE_CONTACT ${GEOLLOYD_PACKAGE_CONTACT})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS python3-matplotlib)  # pictures of measurements
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
  "The program: it makes geodesic centroidal Voronoi tessellations of triangle
meshes, and regular remeshes from them.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS
  "libeigen3-dev, zlib1g-dev, libzstd-dev, libtbb-dev, libembree-dev, libcairo2-dev, pkg-config")
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION
  "The library: headers and archives for programs in C++.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3, python3-numpy")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION
  "The package geolloyd for Python.")
include(CPack)
