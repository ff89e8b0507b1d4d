# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the library, its headers and the tool, so that find_package(annulus) works from the installed tree.
include(CMakePackageConfigHelpers)

set(annulus_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/annulus")

install(TARGETS annulus EXPORT annulusTargets)
install(TARGETS annulus-toolkit EXPORT annulusToolkitTargets)
if(TARGET annulus-c)
    install(TARGETS annulus-c EXPORT annulusCTargets)
    install(EXPORT annulusCTargets NAMESPACE annulus:: DESTINATION "${annulus_package_dir}")
endif()
if(TARGET annulus-cli)
    install(TARGETS annulus-cli)
endif()
install(DIRECTORY src/annulus/ DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/annulus"
        FILES_MATCHING PATTERN "*.h" PATTERN cli EXCLUDE PATTERN c EXCLUDE)
install(EXPORT annulusTargets NAMESPACE annulus:: DESTINATION "${annulus_package_dir}")
install(EXPORT annulusToolkitTargets NAMESPACE annulus:: DESTINATION "${annulus_package_dir}")

configure_package_config_file(cmake/annulusConfig.cmake.in annulusConfig.cmake
                              INSTALL_DESTINATION "${annulus_package_dir}")
write_basic_package_version_file(annulusConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/annulusConfig.cmake"
              "${CMAKE_CURRENT_BINARY_DIR}/annulusConfigVersion.cmake"
              cmake/annulus-gmp.cmake
        DESTINATION "${annulus_package_dir}")
