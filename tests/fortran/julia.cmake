# SPDX-License-Identifier: GPL-3.0-or-later
# The test `julia`: the tests and the example of PACKAGE with LIBRARY. Skipped where there is no julia.
find_program(julia julia)
if(NOT julia)
    message("SKIPPED: there is no julia, and of its package only the declarations are checked")
    return()
endif()
set(ENV{ANNULUS_LIBRARY} "${LIBRARY}")
# No file of the user is read or written.
set(ENV{JULIA_DEPOT_PATH} "${SCRATCH}")
foreach(script IN ITEMS "${PACKAGE}/test/runtests.jl" "${EXAMPLE}")
    execute_process(COMMAND "${julia}" --startup-file=no "--project=${PACKAGE}" "${script}"
                    COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endforeach()
