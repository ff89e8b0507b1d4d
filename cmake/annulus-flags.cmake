# SPDX-License-Identifier: GPL-3.0-or-later
# Flags under which double arithmetic is not IEEE arithmetic, and compilers whose flags are not known. The proofs do not
# apply to a build with one of them, so the configuration stops. Modes that a compiler sets without one of these flags
# are found by <annulus/internal/compiler_flags.h>, macros, and <annulus/arithmetic/environment.h>, a test at run time.
#
# Flags that the library sets itself, after all flags from outside, are not in the list: -ffp-contract, -frounding-math.

# Stops if `flags`, a string or a list, has one of them. `origin` names the variable or property.
function(annulus_refuse_flags flags origin)
    string(REPLACE ";" " " words "${flags}")
    set(refused
        "-ffast-math" "-Ofast" "-funsafe-math-optimizations" "-menable-unsafe-fp-math" "-ffinite-math-only"
        "-fno-honor-nans" "-fno-honor-infinities" "-fassociative-math" "-freciprocal-math" "-fno-signed-zeros"
        "-fsingle-precision-constant" "-fapprox-func" "-mrecip[^ ]*" "-mfpmath=[^ ]*387[^ ]*" "-mpc(32|64)" "-mdaz-ftz"
        "-fdenormal-fp-math[^ ]*" "-ffp-model=(fast|aggressive)" "-ffp-eval-method=(double|extended)"
        "-fexcess-precision=fast" "-fp-model[ =]fast[^ ]*" "/fp:fast")
    list(JOIN refused "|" any)
    if(" ${words} " MATCHES "[ >:,](${any})[ >]")
        message(FATAL_ERROR "annulus proves its answers under IEEE arithmetic: build it without ${CMAKE_MATCH_1} "
                            "(in ${origin})")
    endif()
endfunction()

# All places from which a flag reaches our files: the variables for C++, those of each build type, including types that
# are not CMake's own, and add_compile_options of this and of a parent project.
function(annulus_refuse_all_flags)
    annulus_refuse_flags("${CMAKE_CXX_FLAGS}" CMAKE_CXX_FLAGS)
    string(TOUPPER "DEBUG;RELEASE;RELWITHDEBINFO;MINSIZEREL;${CMAKE_BUILD_TYPE};${CMAKE_CONFIGURATION_TYPES}" types)
    list(REMOVE_DUPLICATES types)
    foreach(type IN LISTS types)
        annulus_refuse_flags("${CMAKE_CXX_FLAGS_${type}}" "CMAKE_CXX_FLAGS_${type}")
    endforeach()
    get_directory_property(options COMPILE_OPTIONS)
    annulus_refuse_flags("${options}" add_compile_options)
endfunction()

# Stops if `id`, in the form of CMAKE_CXX_COMPILER_ID, is a compiler whose flags for IEEE arithmetic are not known here:
# it would silently get none of them.
function(annulus_refuse_compiler id)
    if(NOT id MATCHES "^(GNU|Clang|AppleClang)$")
        message(FATAL_ERROR "annulus proves its answers under IEEE arithmetic, and has the flags for it of GCC and "
                            "Clang only: build it with one of these (CMAKE_CXX_COMPILER is ${CMAKE_CXX_COMPILER}, "
                            "which CMake calls '${id}')")
    endif()
endfunction()
