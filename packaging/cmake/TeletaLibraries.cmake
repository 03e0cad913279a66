# SPDX-License-Identifier: GPL-3.0-or-later
# Finds every library that the module graph names.
include_guard(GLOBAL)

find_package(Threads REQUIRED)
find_package(Qt6 6.4 REQUIRED COMPONENTS Core LinguistTools Network Sql WebSockets)
find_package(Boost 1.74 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(SQLite3 3.31 REQUIRED)
find_package(tomlplusplus 3.3 CONFIG REQUIRED)
# Never highgui: Debian's links Qt 5.
find_package(OpenCV 4.6 REQUIRED COMPONENTS core imgcodecs imgproc video videoio)
find_path(TELETA_EXPECTED tl/expected.hpp REQUIRED)
find_path(TELETA_READERWRITERQUEUE readerwriterqueue/readerwritercircularbuffer.h REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(HIDAPI REQUIRED IMPORTED_TARGET hidapi-hidraw)
pkg_check_modules(LIBMODBUS REQUIRED IMPORTED_TARGET libmodbus)
pkg_check_modules(ALSA REQUIRED IMPORTED_TARGET alsa)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
pkg_check_modules(CYCLONEDDS REQUIRED IMPORTED_TARGET CycloneDDS>=0.10)
find_program(TELETA_IDLC idlc REQUIRED)
pkg_check_modules(URDFDOM REQUIRED IMPORTED_TARGET urdfdom)
pkg_check_modules(ASSIMP REQUIRED IMPORTED_TARGET assimp)
pkg_check_modules(LIBLZ4 REQUIRED IMPORTED_TARGET liblz4)
pkg_check_modules(HDF5 REQUIRED IMPORTED_TARGET hdf5-serial)
pkg_check_modules(MATIO REQUIRED IMPORTED_TARGET matio)
# Only a part of the program links them.
add_library(teleta_array_headers INTERFACE)
target_include_directories(teleta_array_headers SYSTEM INTERFACE ${HDF5_INCLUDE_DIRS} ${MATIO_INCLUDE_DIRS})
pkg_check_modules(LIBZIP REQUIRED IMPORTED_TARGET libzip)
pkg_check_modules(LIBZSTD REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(RSVG REQUIRED IMPORTED_TARGET librsvg-2.0 cairo cairo-pdf cairo-png)
pkg_check_modules(ZLIB REQUIRED IMPORTED_TARGET zlib)
# librsvg asks for -pthread, which glibc 2.34 no longer needs, and with which no precompiled headers of others fit.
get_target_property(rsvg_options PkgConfig::RSVG INTERFACE_COMPILE_OPTIONS)
list(REMOVE_ITEM rsvg_options -pthread)
set_target_properties(PkgConfig::RSVG PROPERTIES INTERFACE_COMPILE_OPTIONS "${rsvg_options}")

# Debian's Python, never another one that comes first in PATH and may lack numpy or the headers.
if(NOT DEFINED TELETA_PYTHON OR TELETA_PYTHON)
    if(NOT Python_ROOT_DIR)
        set(Python_ROOT_DIR /usr)
    endif()
    if(NOT Python_FIND_STRATEGY)
        set(Python_FIND_STRATEGY LOCATION)
    endif()
    find_package(Python 3.11 QUIET COMPONENTS Interpreter Development.Module)
    if(Python_FOUND)
        find_package(pybind11 2.10 CONFIG QUIET)
    endif()
endif()
# A sanitizer would have to be loaded before the interpreter.
set(python_default OFF)
if(pybind11_FOUND AND NOT TELETA_SANITIZE)
    set(python_default ON)
endif()
option(TELETA_PYTHON "Build the Python module teleta" ${python_default})
if(TELETA_PYTHON AND NOT pybind11_FOUND)
    message(FATAL_ERROR "TELETA_PYTHON needs Python 3.11 with its headers and pybind11 2.10 (python3-dev, pybind11-dev)")
endif()

if(TELETA_GUI)
    find_package(Qt6 6.4 REQUIRED COMPONENTS DBus Multimedia OpenGL OpenGLWidgets PrintSupport Svg Widgets)

    find_library(TELETA_QCUSTOMPLOT QCustomPlotQt6 REQUIRED)
    find_path(TELETA_QCUSTOMPLOT_INCLUDE qcustomplot.h REQUIRED)
    add_library(teleta_qcustomplot INTERFACE)
    target_include_directories(teleta_qcustomplot SYSTEM INTERFACE "${TELETA_QCUSTOMPLOT_INCLUDE}")
    target_link_libraries(teleta_qcustomplot INTERFACE "${TELETA_QCUSTOMPLOT}" Qt6::PrintSupport)

    # Debian's VTK widgets are Qt 5, so GUISupportQt is never named here and VtkWidget takes its place.
    find_package(
        VTK 9.1 REQUIRED
        COMPONENTS CommonCore
                   CommonDataModel
                   CommonExecutionModel
                   CommonMath
                   CommonTransforms
                   FiltersCore
                   FiltersGeneral
                   IOGeometry
                   IOPLY
                   IOXML
                   RenderingCore
                   RenderingOpenGL2)
    # Only a part writes files (widgets/view3d/mesh), whose modules bring many libraries of pictures.
    set(TELETA_VTK_MODULES ${VTK_LIBRARIES})
    list(FILTER TELETA_VTK_MODULES EXCLUDE REGEX "^VTK::IO")
    add_library(teleta_vtk INTERFACE)
    target_link_libraries(teleta_vtk INTERFACE ${TELETA_VTK_MODULES})
endif()
