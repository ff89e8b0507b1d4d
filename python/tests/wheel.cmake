# SPDX-License-Identifier: GPL-3.0-or-later
# Configures as scikit-build-core does, and expects the package at the root of the wheel's files: they are installed
# with the prefix SKBUILD_PLATLIB_DIR, which is absolute and another one in every build.
file(REMOVE_RECURSE "${SCRATCH}")
file(STRINGS "${SOURCE}/pyproject.toml" defines REGEX "^ANNULUS_[A-Z_]+ = ")
list(TRANSFORM defines REPLACE "^([A-Z_]+) = \"([A-Z]+)\"" "-D\\1=\\2")
execute_process(
    COMMAND "${CMAKE_COMMAND}" --no-warn-unused-cli -S "${SOURCE}" -B "${SCRATCH}" -G "${GENERATOR}"
            "-DCMAKE_CXX_COMPILER=${COMPILER}" ${defines} -DSKBUILD=2 "-DSKBUILD_PLATLIB_DIR=${SCRATCH}/platlib"
            "-DPython_EXECUTABLE=${PYTHON}"
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(READ "${SCRATCH}/python/cmake_install.cmake" script)
string(REGEX MATCH "set\\(annulus_python_dir \"([^\"]*)\"\\)" found "${script}")
if(NOT found OR NOT CMAKE_MATCH_1 STREQUAL ".")
    message(FATAL_ERROR "The wheel would have annulus/ in '${CMAKE_MATCH_1}'")
endif()
