# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the library, its headers, the C interface and the tool, so that find_package(annulus) works from the
# installed tree. The components are those of the packages: development, runtime, tool; python/ has the fourth,
# python.
include(CMakePackageConfigHelpers)

set(annulus_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/annulus")

install(TARGETS annulus EXPORT annulusTargets COMPONENT development)
if(TARGET annulus-c)
    install(TARGETS annulus-c EXPORT annulusCTargets
            LIBRARY COMPONENT runtime NAMELINK_COMPONENT development
            RUNTIME COMPONENT runtime ARCHIVE COMPONENT development)
    install(EXPORT annulusCTargets NAMESPACE annulus:: DESTINATION "${annulus_package_dir}" COMPONENT development)
    # For programs that are not built by CMake. (C++ programs need CGAL's flags and targets, which have no pkg-config.)
    file(RELATIVE_PATH annulus_pc_to_prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
    configure_file(cmake/annulus_c.pc.in annulus_c.pc @ONLY)
    install(FILES "${CMAKE_CURRENT_BINARY_DIR}/annulus_c.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig"
            COMPONENT development)
    # Sources, for any compiler; annulusConfig.cmake makes a target of the first.
    install(FILES "${annulus_fortran_file}" DESTINATION "${CMAKE_INSTALL_DATADIR}/annulus/fortran"
            COMPONENT development)
    install(DIRECTORY julia/Annulus DESTINATION "${CMAKE_INSTALL_DATADIR}/annulus/julia" COMPONENT development
            PATTERN "Manifest.toml" EXCLUDE)
endif()
include(annulus-headers)
foreach(header IN LISTS annulus_plain_headers annulus_view_headers)
    cmake_path(GET header PARENT_PATH folder)
    install(FILES "src/annulus/${header}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/annulus/${folder}"
            COMPONENT development)
endforeach()
install(EXPORT annulusTargets NAMESPACE annulus:: DESTINATION "${annulus_package_dir}" COMPONENT development)

configure_package_config_file(cmake/annulusConfig.cmake.in annulusConfig.cmake
                              INSTALL_DESTINATION "${annulus_package_dir}" PATH_VARS CMAKE_INSTALL_DATADIR)
write_basic_package_version_file(annulusConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/annulusConfig.cmake"
              "${CMAKE_CURRENT_BINARY_DIR}/annulusConfigVersion.cmake"
              cmake/annulus-gmp.cmake
        DESTINATION "${annulus_package_dir}" COMPONENT development)

# ---- The tool, its man pages and completion, which are made from its own --help --------------------
if(TARGET annulus-cli)
    install(TARGETS annulus-cli COMPONENT tool)
    install(TARGETS annulus-nodt DESTINATION "${CMAKE_INSTALL_LIBEXECDIR}/annulus" COMPONENT tool)
endif()
if(TARGET annulus-programs)
    install(TARGETS annulus-sweep annulus-reproduce DESTINATION "${CMAKE_INSTALL_LIBEXECDIR}/annulus" COMPONENT tool)
    find_package(Python3 COMPONENTS Interpreter QUIET)
    if(Python3_Interpreter_FOUND AND NOT CMAKE_CROSSCOMPILING AND NOT ANNULUS_BUILD_FUZZ)
        set(annulus_share "${CMAKE_CURRENT_BINARY_DIR}/share")
        add_custom_command(
            OUTPUT "${annulus_share}/man/man1/annulus.1.gz"
            COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/tools/describe-tool" "--tool=$<TARGET_FILE:annulus-cli>"
                    "--output=${annulus_share}"
            DEPENDS annulus-programs tools/describe-tool docs/tool.md
            COMMENT "Man pages and completion"
            VERBATIM)
        add_custom_target(annulus-description ALL DEPENDS "${annulus_share}/man/man1/annulus.1.gz")
        install(DIRECTORY "${annulus_share}/man/" DESTINATION "${CMAKE_INSTALL_MANDIR}" COMPONENT tool)
        install(DIRECTORY "${annulus_share}/bash-completion" "${annulus_share}/zsh"
                DESTINATION "${CMAKE_INSTALL_DATADIR}" COMPONENT tool)
    endif()
endif()
