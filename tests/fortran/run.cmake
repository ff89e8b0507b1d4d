# SPDX-License-Identifier: GPL-3.0-or-later
# The test `fortran`: compiles MODULE, the PARTS of the test program, and SOURCES, the program and the
# example, as a user would, and runs these with LIBRARY.
# The compiler is that of the environment variable FC, else gfortran; without one the test is skipped.
find_program(compiler NAMES $ENV{FC} gfortran)
if(NOT compiler)
    message("SKIPPED: there is no Fortran compiler, and nothing is known of the module annulus")
    return()
endif()
set(warnings "")
if(compiler MATCHES "gfortran")
    # Functions are not pure, and exact results are compared exactly.
    set(warnings -std=f2018 -pedantic -Wall -Wextra -Werror -Wno-function-elimination -Wno-compare-reals
        -fcheck=bounds,do,mem,pointer,recursion -ffpe-trap=invalid,zero,overflow -g -O1)
endif()
file(REMOVE_RECURSE "${SCRATCH}")
file(MAKE_DIRECTORY "${SCRATCH}")
function(step)
    execute_process(COMMAND ${ARGV} WORKING_DIRECTORY "${SCRATCH}" COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()
step("${compiler}" ${warnings} -c "${MODULE}" -o annulus.o)
set(objects "")
foreach(source IN LISTS PARTS)
    cmake_path(GET source STEM name)
    step("${compiler}" ${warnings} -c "${source}" -o "${name}.o")
    list(APPEND objects "${name}.o")
endforeach()
cmake_path(GET LIBRARY PARENT_PATH folder)
foreach(source IN LISTS SOURCES)
    cmake_path(GET source STEM name)
    step("${compiler}" ${warnings} "${source}" ${objects} annulus.o "${LIBRARY}" "-Wl,-rpath,${folder}" -o "${name}")
    step("${SCRATCH}/${name}")
endforeach()

# Without stat an error ends the program, with the reason; a mesh cannot be assigned.
foreach(case IN ITEMS "call mesh%remove([9])|unknown vertex" "other = mesh|cannot be assigned"
        "call boxed%remove([9])|unknown vertex" "another = boxed|cannot be assigned")
    string(REPLACE "|" ";" case "${case}")
    list(GET case 0 statement)
    list(GET case 1 reason)
    file(WRITE "${SCRATCH}/stops.f90" "
program stops
    use annulus
    implicit none
    type(moving_mesh) :: mesh, other
    type(periodic_mesh) :: boxed, another
    call mesh%create(reshape([0d0, 0d0, 1d0, 0d0, 0d0, 1d0], [2, 3]))
    call other%destroy()
    call boxed%create(reshape([0d0, 0d0], [2, 1]), reshape([1d0, 0d0, 0d0, 1d0], [2, 2]))
    call another%destroy()
    ${statement}
end program
")
    step("${compiler}" stops.f90 annulus.o "${LIBRARY}" "-Wl,-rpath,${folder}" -o stops)
    execute_process(COMMAND "${SCRATCH}/stops" RESULT_VARIABLE status ERROR_VARIABLE said)
    if(status EQUAL 0 OR NOT said MATCHES "${reason}")
        message(FATAL_ERROR "${statement}: status ${status}, expected an error stop with `${reason}`:\n${said}")
    endif()
endforeach()
