# SPDX-License-Identifier: GPL-3.0-or-later
# The test `subproject`: what a parent project gets, seen in its compile commands; nothing is compiled. Flags that
# break the arithmetic are refused, wherever they stand.
file(REMOVE_RECURSE "${SCRATCH}")

function(refused flags expected)
    execute_process(COMMAND "${CMAKE_COMMAND}" "-DFLAGS=${flags}" -P "${CMAKE_CURRENT_LIST_DIR}/refuse.cmake"
                    RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
    if((status EQUAL 0) EQUAL expected)
        message(SEND_ERROR "flags '${flags}': refused should be ${expected}")
    endif()
endfunction()
foreach(flag IN ITEMS -ffast-math -Ofast -funsafe-math-optimizations -ffinite-math-only -fno-honor-nans
        -fno-honor-infinities -fassociative-math -freciprocal-math -fno-signed-zeros -fsingle-precision-constant
        -fapprox-func -mrecip -mrecip=all -mfpmath=387 -mfpmath=sse+387 -mpc32 -mpc64 -mdaz-ftz
        -fdenormal-fp-math=preserve-sign -ffp-model=fast -ffp-model=aggressive
        -ffp-eval-method=extended -fexcess-precision=fast /fp:fast)
    refused("${flag}" 1)
    refused("-O2 ${flag} -g" 1)
    refused("-O2;$<$<CONFIG:Release>:${flag}>" 1)
endforeach()
foreach(flags IN ITEMS "" -O3 "-O2 -march=native -flto" -fno-fast-math -fno-math-errno -ffp-contract=fast -mfpmath=sse
        -ffp-model=strict -fno-finite-math-only "-DPATH=/opt/x-Ofast/y")
    refused("${flags}" 0)
endforeach()

# Nor are compilers of which no such flags are known. (nvc++ is NVHPC, icpx IntelLLVM.)
function(compiler id expected)
    execute_process(COMMAND "${CMAKE_COMMAND}" "-DCOMPILER_ID=${id}" -P "${CMAKE_CURRENT_LIST_DIR}/refuse.cmake"
                    RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE said)
    if((status EQUAL 0) EQUAL expected OR (expected AND NOT said MATCHES "CMake[ \n]+calls[ \n]+'${id}'"))
        message(SEND_ERROR "compiler '${id}': refused should be ${expected}\n${said}")
    endif()
endfunction()
foreach(id IN ITEMS GNU Clang AppleClang)
    compiler("${id}" 0)
endforeach()
foreach(id IN ITEMS MSVC Intel IntelLLVM NVHPC NVIDIA PGI XLClang GNUlike "")
    compiler("${id}" 1)
endforeach()

# Nor do the headers take them, or an older standard, where a build has no CMake. The first error says so, before
# those about what an older standard has not; tools/check-modules looks that no header is left out.
function(header name flags expected words)
    separate_arguments(flags)
    set(ENV{LC_ALL} C)
    execute_process(COMMAND "${COMPILER}" ${flags} -Wfatal-errors "-I${SOURCE}/src" -x c++ -fsyntax-only
                            "${SOURCE}/src/annulus/${name}"
                    RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE said)
    string(REGEX MATCH "(fatal )?error: [^\n]*" first "${said}")
    if((status EQUAL 0) EQUAL expected OR (expected AND NOT first MATCHES "annulus: .*${words}"))
        message(SEND_ERROR "${name} with '${flags}': refused should be ${expected}\n${first}")
    endif()
endfunction()
set(environment internal/compiler_flags.h)
header(${environment} "-std=c++20" 0 "")
foreach(flag IN ITEMS -ffast-math -ffinite-math-only -fassociative-math\ -fno-signed-zeros\ -fno-trapping-math)
    header(${environment} "-std=c++20 ${flag}" 1 "compile (it )?without")
endforeach()
foreach(name IN ITEMS ${environment} error.h types.h moving_mesh.h moving_delaunay_2.h
        moving_delaunay_3.h voronoi.h degeneracy.h)
    header(${name} "-std=c++17" 1 "-std=c[+][+]20")
endforeach()

function(configure status_variable)
    execute_process(COMMAND "${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${SCRATCH}/build" -G "${GENERATOR}"
                            "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DANNULUS_SOURCE=${SOURCE}" ${ARGN}
                    RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
    set(${status_variable} "${status}" PARENT_SCOPE)
    set(said "${said}" PARENT_SCOPE)
endfunction()

# zlib, libpng, libjpeg, Netpbm and JSON are not looked for: as if they were not there.
configure(status -DCMAKE_POSITION_INDEPENDENT_CODE=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
          -DCMAKE_DISABLE_FIND_PACKAGE_ZLIB=ON -DCMAKE_DISABLE_FIND_PACKAGE_PNG=ON
          -DCMAKE_DISABLE_FIND_PACKAGE_JPEG=ON -DCMAKE_DISABLE_FIND_PACKAGE_Netpbm=ON
          -DCMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "the parent project does not configure:\n${said}")
endif()
file(READ "${SCRATCH}/build/compile_commands.json" commands)
string(JSON count LENGTH "${commands}")
math(EXPR last "${count} - 1")
set(engine 0)
foreach(k RANGE ${last})
    string(JSON command GET "${commands}" ${k} command)
    string(JSON file GET "${commands}" ${k} file)
    if(command MATCHES " -W(all|extra|shadow|conversion|error)")
        message(SEND_ERROR "${file}: warnings of ours in a parent project")
    endif()
    if(NOT command MATCHES " -fPIC")
        message(SEND_ERROR "${file}: not position-independent")
    endif()
    if(file MATCHES "/src/apps/")
        message(SEND_ERROR "${file}: more than the core")
    elseif(file MATCHES "/engine/")
        math(EXPR engine "${engine} + 1")
    endif()
endforeach()
if(engine EQUAL 0)
    message(SEND_ERROR "no file of the engine in the compile commands")
endif()
file(READ "${SCRATCH}/build/annulus/cmake_install.cmake" install)
if(install MATCHES "libannulus|/include")
    message(SEND_ERROR "the parent's installation has annulus in it")
endif()

configure(status -DUNSAFE=-ffinite-math-only)
if(status EQUAL 0 OR NOT said MATCHES "-ffinite-math-only")
    message(SEND_ERROR "add_compile_options(-ffinite-math-only) of a parent is not refused:\n${said}")
endif()
configure(status -DUNSAFE= -DCMAKE_CXX_FLAGS_RELEASE=-Ofast)
if(status EQUAL 0 OR NOT said MATCHES "-Ofast")
    message(SEND_ERROR "CMAKE_CXX_FLAGS_RELEASE=-Ofast is not refused:\n${said}")
endif()
# A build type of one's own, which CMake has in capitals.
configure(status -DCMAKE_CXX_FLAGS_RELEASE=-O2 -DCMAKE_BUILD_TYPE=Own -DCMAKE_CXX_FLAGS_OWN=-ffast-math)
if(status EQUAL 0 OR NOT said MATCHES "-ffast-math[ \n]+\\(in[ \n]+CMAKE_CXX_FLAGS_OWN\\)")
    message(SEND_ERROR "CMAKE_CXX_FLAGS_OWN=-ffast-math is not refused:\n${said}")
endif()
configure(status -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CONFIGURATION_TYPES=Debug\;Other" -DCMAKE_CXX_FLAGS_OTHER=-Ofast)
if(status EQUAL 0 OR NOT said MATCHES "-Ofast[ \n]+\\(in[ \n]+CMAKE_CXX_FLAGS_OTHER\\)")
    message(SEND_ERROR "CMAKE_CXX_FLAGS_OTHER=-Ofast is not refused:\n${said}")
endif()
