"""Spack's recipe of this source tree. In a repository of packages it is the file
packages/roughcontact/package.py; `spack develop --path TREE roughcontact@0.1.0` builds TREE.
"""

from spack_repo.builtin.build_systems.cmake import CMakePackage

from spack.package import *


class Roughcontact(CMakePackage):
    """Certified normal contact of rough surfaces on an elastic half-space: a C library with a
    command and bindings for Fortran, Python and Octave."""

    license("BSD-3-Clause AND GPL-2.0-or-later AND GPL-3.0-or-later")

    version("0.1.0")

    variant("tools", default=True, description="The command roughcontact")
    variant("cholmod", default=True, description="Backend cholmod, factorisations by SuiteSparse")
    variant("flow", default=True, description="The library of leaks, and leaks in the command")
    variant("python", default=True, description="The Python package")
    variant("mpi", default=False, description="Contacts shared by ranks of MPI")
    variant("cuda", default=False, description="Backend for CUDA devices")
    variant("hdf5", default=False, description="Surface files in HDF5")
    variant("pictures", default=False, description="Heights in TIFF and PNG")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("mpi", when="+mpi")
    depends_on("cuda", when="+cuda")
    depends_on("hdf5", when="+hdf5")
    depends_on("libtiff@4.5:", when="+pictures")
    depends_on("libpng", when="+pictures")
    depends_on("cmake@3.22:", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("eigen@3.4:", type="build")
    depends_on("fftw precision=double,float")
    depends_on("gsl")
    depends_on("libzip")
    depends_on("pugixml")
    depends_on("zlib-api")
    depends_on("suite-sparse", when="+cholmod")
    depends_on("suite-sparse", when="+flow")
    depends_on("cli11", when="+tools", type="build")
    depends_on("nlohmann-json", when="+tools", type="build")
    depends_on("python@3.9:", when="+python", type=("build", "run"))
    depends_on("py-numpy@1.21:", when="+python", type="run")

    extends("python", when="+python")

    def cmake_args(self):
        backends = ["fft", "split"] + (["cholmod"] if self.spec.satisfies("+cholmod") else [])
        args = [
            self.define("CMAKE_INSTALL_LIBDIR", "lib"),  # where the Python package looks
            self.define_from_variant("RC_BUILD_TOOLS", "tools"),
            self.define_from_variant("RC_BUILD_FLOW", "flow"),
            self.define_from_variant("RC_BUILD_MPI", "mpi"),
            self.define_from_variant("RC_CUDA", "cuda"),
            self.define_from_variant("RC_READ_HDF5", "hdf5"),
            self.define_from_variant("RC_READ_PICTURES", "pictures"),
            self.define("RC_BUILD_TESTS", False),
            self.define("RC_BUILD_BENCH", False),
            self.define("RC_BUILD_EXAMPLES", False),
            self.define("RC_MODULE_BACKENDS", backends),
        ]
        if self.spec.satisfies("+python"):
            args.append(self.define("RC_PYTHON_DIR", python_platlib))
        return args
