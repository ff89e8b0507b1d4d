# SPDX-License-Identifier: GPL-3.0-or-later
# The test `consumer`: installs the build BUILD into a scratch prefix, then configures, builds and runs SOURCE against
# it with the same compiler and flags.
file(REMOVE_RECURSE "${SCRATCH}")

function(step)
    execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

step("${CMAKE_COMMAND}" --install "${BUILD}" --config "${CONFIG}" --prefix "${SCRATCH}/prefix")
step("${CMAKE_COMMAND}" -S "${SOURCE}" -B "${SCRATCH}/build" -G "${GENERATOR}"
     "-DCMAKE_PREFIX_PATH=${SCRATCH}/prefix"
     "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}"
     "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DCMAKE_BUILD_TYPE=${CONFIG}"
     -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
step("${CMAKE_COMMAND}" --build "${SCRATCH}/build" --config "${CONFIG}")
foreach(name IN ITEMS consumer mesh-consumer measure-consumer)
    unset(CONSUMER CACHE)
    find_program(CONSUMER ${name} PATHS "${SCRATCH}/build" "${SCRATCH}/build/${CONFIG}" NO_DEFAULT_PATH REQUIRED)
    step("${CONSUMER}")
endforeach()

# A project without C++: C_COMPILER is empty where the C interface is not built.
if(C_COMPILER)
    step("${CMAKE_COMMAND}" -S "${SOURCE}/c" -B "${SCRATCH}/build-c" -G "${GENERATOR}"
         "-DCMAKE_PREFIX_PATH=${SCRATCH}/prefix" "-DCMAKE_C_COMPILER=${C_COMPILER}" "-DCMAKE_BUILD_TYPE=${CONFIG}"
         -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
    step("${CMAKE_COMMAND}" --build "${SCRATCH}/build-c" --config "${CONFIG}")
    find_program(C_CONSUMER c-consumer PATHS "${SCRATCH}/build-c" "${SCRATCH}/build-c/${CONFIG}"
                 NO_DEFAULT_PATH REQUIRED)
    step("${C_CONSUMER}")
    # A project in Fortran alone.
    find_program(FORTRAN_COMPILER NAMES $ENV{FC} gfortran)
    if(FORTRAN_COMPILER)
        step("${CMAKE_COMMAND}" -S "${SOURCE}/fortran" -B "${SCRATCH}/build-fortran" -G "${GENERATOR}"
             "-DCMAKE_PREFIX_PATH=${SCRATCH}/prefix" "-DCMAKE_Fortran_COMPILER=${FORTRAN_COMPILER}"
             "-DCMAKE_BUILD_TYPE=${CONFIG}" -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
        step("${CMAKE_COMMAND}" --build "${SCRATCH}/build-fortran" --config "${CONFIG}")
        find_program(FORTRAN_CONSUMER fortran-consumer PATHS "${SCRATCH}/build-fortran"
                     "${SCRATCH}/build-fortran/${CONFIG}" NO_DEFAULT_PATH REQUIRED)
        step("${FORTRAN_CONSUMER}")
    endif()
endif()
