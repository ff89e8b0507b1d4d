# SPDX-License-Identifier: GPL-3.0-or-later
# An overlay port beside the sources. A port of a registry has vcpkg_from_git or vcpkg_from_github here.
get_filename_component(SOURCE_PATH "${CURRENT_PORT_DIR}/../../.." ABSOLUTE)

vcpkg_check_features(OUT_FEATURE_OPTIONS FEATURE_OPTIONS
    FEATURES
        c ANNULUS_BUILD_C
        tool ANNULUS_BUILD_TOOL
        tool ANNULUS_BUILD_APPS
)
vcpkg_cmake_configure(
    SOURCE_PATH "${SOURCE_PATH}"
    OPTIONS
        ${FEATURE_OPTIONS}
        -DANNULUS_BUILD_TESTS=OFF
        -DANNULUS_BUILD_BENCH=OFF
        -DANNULUS_BUILD_EXAMPLES=OFF
        -DANNULUS_MPI=OFF
        -DANNULUS_NETPBM=OFF  # there is no port of Netpbm
)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/annulus)
if("c" IN_LIST FEATURES)
    vcpkg_fixup_pkgconfig()
endif()
if("tool" IN_LIST FEATURES)
    file(MAKE_DIRECTORY "${CURRENT_PACKAGES_DIR}/tools/annulus")
    # `annulus` starts the programs in ../libexec/annulus.
    file(RENAME "${CURRENT_PACKAGES_DIR}/bin" "${CURRENT_PACKAGES_DIR}/tools/annulus/bin")
    file(RENAME "${CURRENT_PACKAGES_DIR}/libexec" "${CURRENT_PACKAGES_DIR}/tools/annulus/libexec")
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share"
                    "${CURRENT_PACKAGES_DIR}/debug/bin" "${CURRENT_PACKAGES_DIR}/debug/libexec")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
