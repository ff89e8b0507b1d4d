# SPDX-License-Identifier: GPL-3.0-or-later
from spack_repo.builtin.build_systems.cmake import CMakePackage

from spack.package import *


class Annulus(CMakePackage):
    """Delaunay triangulations of moving points, certified after every move"""

    # There is no release to fetch yet: `spack dev-build annulus@0.1.0` in a checkout.
    version("0.1.0")

    license("GPL-3.0-or-later")

    variant("c", default=True, description="The C interface, with sources for Fortran and Julia")
    variant("tool", default=True, description="The command-line tool")
    variant("mpi", default=False, when="+tool", description="annulus sweep under mpirun")
    variant("python", default=False, description="The Python package")

    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("boost@1.74:")
    depends_on("cgal@5.5:")
    depends_on("tbb")
    depends_on("gmp+cxx")
    depends_on("mpfr")
    depends_on("mpi", when="+mpi")
    for apps in ("+tool", "+python"):
        depends_on("zlib-api", when=apps)
        depends_on("libpng", when=apps)
        depends_on("jpeg", when=apps)
        depends_on("netpbm", when=apps)
        depends_on("nlohmann-json@3.11:", when=apps)
    depends_on("cli11@2.1:", when="+tool")
    depends_on("tomlplusplus@3.3:", when="+tool")
    extends("python", when="+python")
    depends_on("python@3.9:", when="+python")
    depends_on("py-pybind11@2.10:", type="build", when="+python")
    depends_on("py-numpy@1.20:", type=("build", "run"), when="+python")

    def cmake_args(self):
        args = [
            self.define("ANNULUS_BUILD_TESTS", False),
            self.define("ANNULUS_BUILD_BENCH", False),
            self.define("ANNULUS_BUILD_EXAMPLES", False),
            self.define("ANNULUS_BUILD_APPS", self.spec.satisfies("+tool") or self.spec.satisfies("+python")),
            self.define_from_variant("ANNULUS_BUILD_C", "c"),
            self.define_from_variant("ANNULUS_BUILD_TOOL", "tool"),
            self.define_from_variant("ANNULUS_MPI", "mpi"),
            self.define_from_variant("ANNULUS_BUILD_PYTHON", "python"),
        ]
        if self.spec.satisfies("+python"):
            args.append(self.define("Python_EXECUTABLE", python.path))
            args.append(self.define("ANNULUS_PYTHON_DIR", python_platlib))
        return args
