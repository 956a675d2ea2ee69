"""What pyproject.toml cannot say: the module is compiled by CMake.

Needs CMake, a C++20 compiler and the libraries of .ci/setup. OSCULO_BUILD_DIR names a CMake build
tree with OSCULO_PYTHON to take the module from, instead of compiling everything anew.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).parent.resolve()
VERSION = re.search(r"project\(osculo VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


class BuildWithCMake(build_ext):
    def build_extension(self, extension):
        build = os.environ.get("OSCULO_BUILD_DIR")
        if not build:
            build = str(Path(self.build_temp).resolve())
            options = {
                "CMAKE_BUILD_TYPE": "Release",
                "OSCULO_PYTHON": "ON",
                "OSCULO_BUILD_CLI": "OFF",
                "OSCULO_BUILD_TESTS": "OFF",
                "Python_EXECUTABLE": sys.executable,
            }
            subprocess.run(
                ["cmake", "-S", str(ROOT), "-B", build]
                + [f"-D{name}={value}" for name, value in options.items()],
                check=True,
            )
            subprocess.run(
                ["cmake", "--build", build, "--target", "osculo_python"]
                + ["--parallel", str(os.cpu_count() or 1)],
                check=True,
            )
        (module,) = Path(build, "python", "osculo").glob("_osculo.*.so")
        target = Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(module, target)


setup(
    version=VERSION,
    ext_modules=[Extension("osculo._osculo", sources=[])],
    cmdclass={"build_ext": BuildWithCMake},
    package_data={"osculo": ["py.typed", "*.pyi"]},
)
