# SPDX-License-Identifier: GPL-3.0-or-later
# cpack: one .deb for each component, from a build like that of tools/packages. Names and contents follow Debian:
#
#   runtime      libannulus-c0      the C interface that programs load, named by its soname
#   development  libannulus-dev     headers, static libraries, CMake's files, pkg-config's for C
#   tool         annulus            the tool, its man pages and completion
#   python       python3-annulus    the Python package
#
# Run-time dependencies of a package are read from its shared libraries (dpkg-shlibdeps); those of headers are listed
# here, as in tools/setup.
if(NOT PROJECT_IS_TOP_LEVEL)
    return()
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME annulus)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
# The maintainer of the packages, which Debian's tools require.
if(DEFINED ENV{DEBEMAIL})
    set(CPACK_PACKAGE_CONTACT "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
else()
    set(CPACK_PACKAGE_CONTACT "annulus developers <annulus@example.org>")
endif()
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
# The permissions of directories are Debian's, whatever the builder's umask.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL development)
if(TARGET annulus-c)
    list(APPEND CPACK_COMPONENTS_ALL runtime)
endif()
if(TARGET annulus-cli)
    list(APPEND CPACK_COMPONENTS_ALL tool)
endif()
if(TARGET annulus-python)
    list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(about "annulus keeps the Delaunay triangulation of moving points right after every\n\
move, in the plane and in space, with exact arithmetic where doubles do not\n\
do, at a small part of the price of recomputing it.\n.\n")
function(annulus_package component name section summary description depends)
    string(TOUPPER "${component}" upper)
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME "${name}" PARENT_SCOPE)
    set(CPACK_DEBIAN_${upper}_FILE_NAME DEB-DEFAULT PARENT_SCOPE)
    set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION "${section}" PARENT_SCOPE)
    set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}\n${about}${description}" PARENT_SCOPE)
    set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
    # Debian's own files, in packages and nowhere else.
    install(CODE "
        if(CMAKE_INSTALL_PREFIX MATCHES \"/usr$\")
            file(INSTALL \"${CMAKE_CURRENT_BINARY_DIR}/packages/copyright\"
                          \"${CMAKE_CURRENT_BINARY_DIR}/packages/changelog.gz\"
                 DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/doc/${name}\")
        endif()" COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()

annulus_package(runtime libannulus-c0 libs "Delaunay triangulations of moving points, C interface"
    "This package has the shared library that programs in C, Fortran, Julia or Rust\nload." "")
# Packages that are linked with it depend on it; the loader's cache is updated.
file(CONFIGURE OUTPUT packages/shlibs CONTENT "libannulus_c 0 libannulus-c0 (>= ${PROJECT_VERSION})\n")
file(CONFIGURE OUTPUT packages/triggers CONTENT "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA
    "${CMAKE_CURRENT_BINARY_DIR}/packages/shlibs;${CMAKE_CURRENT_BINARY_DIR}/packages/triggers")
annulus_package(development libannulus-dev libdevel "Delaunay triangulations of moving points, development files"
    "This package has the headers and libraries for programs in C++ and C, what\n\
CMake and pkg-config need to find them, and sources for Fortran and Julia."
    "libcgal-dev (>= 5.5), libgmp-dev, libmpfr-dev, libboost-dev, libtbb-dev")
annulus_package(tool annulus science "Delaunay triangulations of moving points, command-line tool"
    "This package has the tool: Lloyd iterations, optimisation of tetrahedral\n\
meshes, recorded motions, statistics of degeneracy, exact audits." "")
if(TARGET annulus-c)
    string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libannulus-c0 (= ${PROJECT_VERSION})")
endif()
if(TARGET annulus-python)
    # The module is for one minor version of Python, and for that interpreter alone.
    get_directory_property(annulus_python_minor DIRECTORY python DEFINITION Python_VERSION_MINOR)
    math(EXPR annulus_python_next "${annulus_python_minor} + 1")
    annulus_package(python python3-annulus python "Delaunay triangulations of moving points, Python module"
        "This package has the module annulus, whose MovingDelaunay has the attributes of\nscipy.spatial.Delaunay."
        "python3 (>= 3.${annulus_python_minor}), python3 (<< 3.${annulus_python_next}), python3-numpy")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib")
endif()

# ---- What Debian requires beside the files: a copyright and a changelog ------------------------------
find_program(ANNULUS_GZIP gzip)
mark_as_advanced(ANNULUS_GZIP)
if(ANNULUS_GZIP)
    configure_file(cmake/packages/copyright packages/copyright COPYONLY)
    string(TIMESTAMP annulus_package_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
    file(CONFIGURE OUTPUT packages/changelog @ONLY NEWLINE_STYLE UNIX CONTENT
"annulus (@PROJECT_VERSION@) unstable; urgency=medium

  * What is new is in CHANGELOG.md of the sources.

 -- @CPACK_PACKAGE_CONTACT@  @annulus_package_date@
")
    execute_process(COMMAND "${ANNULUS_GZIP}" -9nc "${CMAKE_CURRENT_BINARY_DIR}/packages/changelog"
                    OUTPUT_FILE "${CMAKE_CURRENT_BINARY_DIR}/packages/changelog.gz" COMMAND_ERROR_IS_FATAL ANY)
endif()

include(CPack)
