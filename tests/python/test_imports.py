# SPDX-License-Identifier: GPL-3.0-or-later
"""What the package imports, and what it exports."""

from __future__ import annotations

import re
import subprocess
import sys

import teleta


def run(code: str) -> str:
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout


def test_opencv_is_loaded_only_where_it_is_needed():
    loaded = run(
        "import teleta\n"
        "teleta.features([[1.0]])\n"
        "print(any('libopencv' in line for line in open('/proc/self/maps')))\n"
        "teleta.scenes()\n"
        "print(any('libopencv' in line for line in open('/proc/self/maps')))\n"
    )
    assert loaded.split() == ["False", "True"]


def test_no_large_package_is_imported():
    modules = run("import sys, teleta, teleta._camera; print(' '.join(sys.modules))").split()
    assert not {"pandas", "scipy", "matplotlib", "cv2"} & set(modules)


def test_no_gui_library_and_no_device_is_loaded():
    libraries = run("import teleta; teleta.scenes(); print(open('/proc/self/maps').read())")
    assert "libQt6Core" in libraries
    assert not re.search("libQt6(Gui|Widgets)|libvtk|libhidapi|libmodbus|libQt5|opencv_highgui", libraries)


def test_no_application_object_of_qt_is_made(indenter):
    # A second one would end a program that imports the module and has its own.
    found = run(
        "import ctypes, teleta\n"
        f"teleta.open({str(indenter / 'recording.teleta')!r}).close()\n"
        "qt = ctypes.CDLL('libQt6Core.so.6')\n"
        "self = ctypes.c_void_p.in_dll(qt, '_ZN16QCoreApplication4selfE')\n"
        "print(self.value)\n"
    )
    assert found.strip() == "None"


def test_all_names_exist_and_are_documented():
    assert sorted(teleta.__all__) == teleta.__all__
    assert set(teleta.__all__) <= set(dir(teleta))
    for name in teleta.__all__:
        value = getattr(teleta, name)
        assert name == "__version__" or value.__doc__, name
    assert re.fullmatch(r"\d+\.\d+\.\d+", teleta.__version__)


def test_an_unknown_name_is_an_attribute_error():
    assert not hasattr(teleta, "no_such_name")


def test_only_the_entry_of_python_is_exported():
    for module in (teleta._core, __import__("teleta._vision", fromlist=["_vision"])):
        symbols = subprocess.run(
            ["nm", "--dynamic", "--defined-only", "--format=posix", module.__file__],
            capture_output=True,
            text=True,
            check=True,
        ).stdout.splitlines()
        names = {line.split()[0] for line in symbols}
        assert any(name.startswith("PyInit_") for name in names)
        assert not {name for name in names if "teleta" in name.lower() and not name.startswith("PyInit_")}
