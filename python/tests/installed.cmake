# SPDX-License-Identifier: GPL-3.0-or-later
# The test `python-installed`: installs the package of the build BUILD, and nothing else, into a scratch prefix and
# uses it.
file(REMOVE_RECURSE "${SCRATCH}")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --config "${CONFIG}" --component python
                        --prefix "${SCRATCH}"
                COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE package "${SCRATCH}/__init__.py")  # wherever below it
cmake_path(GET package PARENT_PATH package)
cmake_path(GET package PARENT_PATH package)
set(ENV{PYTHONPATH} "${package}")
set(ENV{PYTHONNOUSERSITE} 1)
execute_process(COMMAND "${PYTHON}" -B -c "
import annulus, numpy, os
assert os.path.realpath(annulus.__file__).startswith(os.path.realpath('${SCRATCH}')), annulus.__file__
assert os.path.exists(os.path.join(os.path.dirname(annulus.__file__), 'py.typed'))
dt = annulus.MovingDelaunay(numpy.random.default_rng(0).random((50, 3)))
dt.move(dt.points + 1e-3)
assert dt.audit().delaunay
print(annulus.__version__, dt)
" COMMAND_ECHO NONE COMMAND_ERROR_IS_FATAL ANY)
