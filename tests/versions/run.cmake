# SPDX-License-Identifier: GPL-3.0-or-later
# The test `two-versions`: compiles a copy of SOURCE whose inline namespace `v1` is called `other`, links it and
# LIBRARY, which the build has from SOURCE itself, into one program, and runs that. No symbol of annulus may be in both
# libraries: a template or an inline function would be taken from one of them for both, without an error.
file(REMOVE_RECURSE "${SCRATCH}/second" "${SCRATCH}/build/two-versions")
file(COPY "${SOURCE}/CMakeLists.txt" "${SOURCE}/cmake" DESTINATION "${SCRATCH}/second")
file(GLOB_RECURSE sources RELATIVE "${SOURCE}" "${SOURCE}/src/annulus/*.h" "${SOURCE}/src/annulus/*.cpp")
set(renamed 0)
foreach(source IN LISTS sources)
    file(READ "${SOURCE}/${source}" text)
    string(REPLACE "annulus::inline v1" "annulus::inline other" changed "${text}")
    if(NOT changed STREQUAL text)
        math(EXPR renamed "${renamed} + 1")
    endif()
    file(WRITE "${SCRATCH}/second/${source}" "${changed}")
endforeach()
if(renamed LESS 100)
    message(FATAL_ERROR "only ${renamed} files of the library are in the inline namespace")
endif()

function(step)
    execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()
step("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${SCRATCH}/build" -G "${GENERATOR}"
     "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}" "-DCMAKE_CXX_FLAGS=${FLAGS} -O0"
     "-DFIRST=${SOURCE}" "-DFIRST_LIBRARY=${LIBRARY}" "-DSECOND=${SCRATCH}/second")
step("${CMAKE_COMMAND}" --build "${SCRATCH}/build" --target two-versions)
step("${SCRATCH}/build/two-versions")

# The global symbols of an archive that name annulus.
function(symbols_of archive result)
    execute_process(COMMAND "${NM}" -g --defined-only "${archive}" OUTPUT_VARIABLE listed ERROR_QUIET
                    COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCHALL " [A-Za-z] [^ \n]*annulus[^ \n]*" names "${listed}")
    list(TRANSFORM names REPLACE "^ [A-Za-z] " "")
    list(REMOVE_DUPLICATES names)
    set(${result} "${names}" PARENT_SCOPE)
endfunction()
symbols_of("${LIBRARY}" first)
symbols_of("${SCRATCH}/build/second/libannulus.a" second)
list(LENGTH first first_count)
list(LENGTH second second_count)
set(only_first ${first})
list(REMOVE_ITEM only_first ${second})
list(LENGTH only_first only_first_count)
if(first_count LESS 500 OR second_count LESS 500)
    message(FATAL_ERROR "only ${first_count} and ${second_count} symbols were found")
endif()
if(NOT only_first_count EQUAL first_count)
    list(REMOVE_ITEM first ${only_first})
    message(FATAL_ERROR "both versions define\n  ${first}")
endif()
message(STATUS "${first_count} and ${second_count} symbols, none in common")
