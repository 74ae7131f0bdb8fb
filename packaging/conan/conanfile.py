from conan import ConanFile
from conan.tools.build import stdcpp_library
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, get, rm, rmdir
from conan.tools.gnu import PkgConfigDeps

required_conan_version = ">=2.0"


class RoughcontactConan(ConanFile):
    name = "roughcontact"
    version = "@VERSION@"
    description = "Certified normal contact of rough surfaces on an elastic half-space"
    license = "BSD-3-Clause"
    url = "https://github.com/conan-io/conan-center-index"
    homepage = "@HOMEPAGE@"
    topics = ("contact-mechanics", "rough-surfaces", "tribology", "boundary-elements")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False], "formats": [True, False]}
    default_options = {"shared": True, "fPIC": True, "formats": False}
    implements = ["auto_shared_fpic"]

    def configure(self):
        # Its interface is in C: it compiles as C++20 whatever standard the profile has.
        if self.options.shared:
            self.options.rm_safe("fPIC")
        self.settings.rm_safe("compiler.cppstd")

    def layout(self):
        cmake_layout(self, src_folder="src")

    def requirements(self):
        self.requires("eigen/3.4.0", visible=False)
        if self.options.formats:
            self.requires("libzip/1.10.1")
            self.requires("pugixml/1.14")
            self.requires("zlib/[>=1.2.11 <2]")

    def source(self):
        get(self, "@ARCHIVE@", sha256="@SHA256@", strip_root=True)

    def generate(self):
        CMakeDeps(self).generate()
        PkgConfigDeps(self).generate()
        toolchain = CMakeToolchain(self)
        for part in ("RC_BUILD_TESTS", "RC_BUILD_BENCH", "RC_BUILD_EXAMPLES", "RC_BUILD_TOOLS", "RC_BUILD_SURFACE"):
            toolchain.cache_variables[part] = False
        toolchain.cache_variables["RC_BUILD_FORMATS"] = bool(self.options.formats)
        toolchain.cache_variables["RC_BUILD_MPI"] = "OFF"
        toolchain.cache_variables["RC_BUILD_FLOW"] = "OFF"
        toolchain.cache_variables["RC_CUDA"] = "OFF"
        # Without plugins under the GPL. A static library has its backends built in.
        toolchain.cache_variables["RC_BUILTIN_BACKENDS"] = "dense" if self.options.shared else "dense;fft"
        toolchain.cache_variables["RC_MODULE_BACKENDS"] = "fft" if self.options.shared else ""
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, f"{self.package_folder}/licenses")
        cmake = CMake(self)
        for component in ["runtime", "development"] + (["formats", "request"] if self.options.formats else []):
            cmake.install(component=component)
        rm(self, "*.a" if self.options.shared else "lib*.so*", f"{self.package_folder}/lib")
        rmdir(self, f"{self.package_folder}/lib/cmake")
        rmdir(self, f"{self.package_folder}/lib/pkgconfig")
        rmdir(self, f"{self.package_folder}/share")

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "roughcontact")
        core = self.cpp_info.components["core"]
        core.set_property("cmake_target_name", "roughcontact::roughcontact")
        core.set_property("pkg_config_name", "roughcontact")
        core.libs = ["roughcontact"]
        if self.settings.os in ("Linux", "FreeBSD"):
            core.system_libs = ["m", "pthread", "dl"]
        if not self.options.shared and stdcpp_library(self):
            core.system_libs.append(stdcpp_library(self))
        if self.options.formats:
            formats = self.cpp_info.components["formats"]
            formats.set_property("cmake_target_name", "roughcontact::formats")
            formats.libs = ["roughcontact-formats"]
            formats.requires = ["core", "libzip::libzip", "pugixml::pugixml", "zlib::zlib"]
