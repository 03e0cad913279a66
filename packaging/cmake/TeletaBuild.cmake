# SPDX-License-Identifier: GPL-3.0-or-later
# Compiler settings, the module graph, and the functions with which every folder declares its target.
include_guard(GLOBAL)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# Everybody may read the installed folders, whatever the umask of the person who installs.
set(CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ
    OWNER_WRITE
    OWNER_EXECUTE
    GROUP_READ
    GROUP_EXECUTE
    WORLD_READ
    WORLD_EXECUTE)

find_program(TELETA_CCACHE ccache)
if(TELETA_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER "${TELETA_CCACHE}")
    set(CMAKE_C_COMPILER_LAUNCHER "${TELETA_CCACHE}")
endif()

include(TeletaLibraries)

# Parts that the programs load when they need them. In the build tree they are found by the search path of the programs,
# which is not installed.
set(TELETA_PARTS_TREE "${CMAKE_BINARY_DIR}/parts")
set(CMAKE_BUILD_RPATH "${TELETA_PARTS_TREE}")
if(TELETA_SANITIZE)
    # A sanitizer loads modules for the program: then only this kind of search path counts.
    add_link_options(LINKER:--disable-new-dtags)
endif()

# The folder in the build tree that PYTHONPATH may name: it holds the whole package.
set(TELETA_PYTHON_TREE "${CMAKE_BINARY_DIR}/app/python")

add_library(teleta_options INTERFACE)
target_include_directories(teleta_options INTERFACE "${CMAKE_SOURCE_DIR}")
target_compile_options(teleta_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
                                                -Wnull-dereference -Wdouble-promotion -Wcast-align -fno-math-errno)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # GCC warns falsely where a std::string is assigned (bug 105329).
    target_compile_options(teleta_options INTERFACE -Wno-restrict)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # By default GCC collects garbage from 128 MB on, which takes about a tenth of its time.
    target_compile_options(teleta_options INTERFACE "SHELL:--param ggc-min-heapsize=524288")
endif()
target_link_libraries(teleta_options INTERFACE Threads::Threads)
if(TELETA_WERROR)
    target_compile_options(teleta_options INTERFACE -Werror)
endif()

# Debian's hardening flags: position-independent programs, read-only relocations bound at the start, checked library
# calls, guarded stacks; and guarded branches (CET), which Debian 12 leaves to the packages. packaging/check_hardening.sh
# looks for them in programs.
include(CheckPIESupported)
check_pie_supported(LANGUAGES CXX)
add_library(teleta_hardening INTERFACE)
set(hardening_compile -fstack-protector-strong -Wformat -Werror=format-security -D_FORTIFY_SOURCE=2)
set(hardening_link -Wl,-z,relro -Wl,-z,now)
find_program(TELETA_DPKG_BUILDFLAGS dpkg-buildflags)
if(TELETA_DPKG_BUILDFLAGS)
    # Optimization, debug information and paths are the build type's business.
    set(not_hardening "^(-O.*|-g.*|-f(file|debug|macro)-prefix-map=.*|-Wdate-time)$")
    foreach(kind CPPFLAGS CXXFLAGS LDFLAGS)
        execute_process(
            COMMAND "${CMAKE_COMMAND}" -E env DEB_BUILD_MAINT_OPTIONS=hardening=+all "${TELETA_DPKG_BUILDFLAGS}" --get ${kind}
            OUTPUT_VARIABLE flags
            OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
        separate_arguments(flags)
        list(FILTER flags EXCLUDE REGEX "${not_hardening}")
        if(kind STREQUAL "LDFLAGS")
            set(hardening_link ${flags})
        else()
            list(APPEND hardening_${kind} ${flags})
        endif()
    endforeach()
    set(hardening_compile ${hardening_CPPFLAGS} ${hardening_CXXFLAGS})
endif()
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
    list(APPEND hardening_compile -fcf-protection)
endif()
target_compile_options(teleta_hardening INTERFACE ${hardening_compile})
target_link_options(teleta_hardening INTERFACE ${hardening_link})
if(TELETA_HARDENING)
    target_link_libraries(teleta_options INTERFACE teleta_hardening)
    # What is packaged does not depend on the folder in which it was built. The search path is cut out, but it takes room: it
    # counts from programs, from the Python module and from the parts themselves.
    set(CMAKE_BUILD_RPATH "$ORIGIN/../../parts" "$ORIGIN/../../../parts" "$ORIGIN")
    target_compile_options(teleta_options INTERFACE "-ffile-prefix-map=${CMAKE_BINARY_DIR}=build" "-ffile-prefix-map=${CMAKE_SOURCE_DIR}=.")
endif()
if(TELETA_SANITIZE)
    target_compile_options(teleta_options INTERFACE -fsanitize=${TELETA_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(teleta_options INTERFACE -fsanitize=${TELETA_SANITIZE})
    if(TELETA_SANITIZE MATCHES "undefined")
        target_compile_options(teleta_options INTERFACE -fno-sanitize-recover=undefined)
        if(TELETA_SANITIZE MATCHES "address" AND NOT TELETA_SANITIZE MATCHES "fuzzer")
            # They take a third of the compile time. The address sanitizer finds what null, vptr and object-size find, and the
            # fuzzer's build has them all.
            target_compile_options(teleta_options INTERFACE -fno-sanitize=null,vptr,object-size,alignment)
        endif()
    endif()
    if(TELETA_SANITIZE MATCHES "address")
        # Under this sanitizer Eigen would use an allocator of its own, in which it sees less.
        target_compile_definitions(teleta_options INTERFACE EIGEN_MALLOC_ALREADY_ALIGNED=1)
    endif()
    if(TELETA_SANITIZE MATCHES "fuzzer")
        # Divisions stay where the source has them, because their exceptions are trapped.
        target_compile_options(teleta_options INTERFACE -ffp-exception-behavior=maytrap)
    endif()
endif()

# The module graph: packaging/cmake/module_graph.txt, read into the properties teleta_modules (folders in the order of
# the table), teleta_uses_FOLDER and teleta_libraries_FOLDER.
set(TELETA_MODULE_GRAPH "${CMAKE_SOURCE_DIR}/packaging/cmake/module_graph.txt")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${TELETA_MODULE_GRAPH}")

# The target of a folder: backend/core/data -> teleta_core_data, app/cli -> teleta_cli, widgets/base -> teleta_widgets_base.
# app/site has the name of backend/site and is teleta_site_program.
function(teleta_target_of folder variable)
    string(REGEX REPLACE "^app/site$" "site_program" name "${folder}")
    string(REGEX REPLACE "^(backend|app)/" "" name "${name}")
    string(REPLACE "/" "_" name "${name}")
    set(${variable} "teleta_${name}" PARENT_SCOPE)
endfunction()

function(teleta_read_module_graph)
    file(STRINGS "${TELETA_MODULE_GRAPH}" lines)
    foreach(line IN LISTS lines)
        if(line MATCHES "^(#.*)?$")
            continue()
        elseif(line MATCHES "^library ([^ ]+)$")
            set(library "${CMAKE_MATCH_1}")
        elseif(line MATCHES "^folder ([^ ]+)$")
            set(folder "${CMAKE_MATCH_1}")
            set_property(GLOBAL APPEND PROPERTY teleta_modules "${folder}")
        elseif(line MATCHES "^    targets (.+)$")
            string(REPLACE " " ";" targets_${library} "${CMAKE_MATCH_1}")
        elseif(line MATCHES "^    headers .+$")
            continue() # for the test of includes
        elseif(line MATCHES "^    uses (.+)$")
            string(REPLACE " " ";" used "${CMAKE_MATCH_1}")
            get_property(modules GLOBAL PROPERTY teleta_modules)
            foreach(other IN LISTS used)
                if(NOT other IN_LIST modules)
                    message(FATAL_ERROR "${TELETA_MODULE_GRAPH}: ${folder} uses ${other}, which has no row above it")
                endif()
                teleta_target_of("${other}" target)
                set_property(GLOBAL APPEND PROPERTY "teleta_uses_${folder}" ${target})
            endforeach()
        elseif(line MATCHES "^    libraries (.+)$")
            string(REPLACE " " ";" names "${CMAKE_MATCH_1}")
            foreach(name IN LISTS names)
                set_property(GLOBAL APPEND PROPERTY "teleta_libraries_${folder}" ${targets_${name}})
            endforeach()
        else()
            message(FATAL_ERROR "${TELETA_MODULE_GRAPH}: '${line}' is not understood")
        endif()
    endforeach()
endfunction()
teleta_read_module_graph()

# teleta_add_modules(): builds every folder of the module graph, those of the GUI only where it is built. A folder X that
# has others below it also gets a target X_all, which stands for all of them.
function(teleta_add_modules)
    get_property(modules GLOBAL PROPERTY teleta_modules)
    foreach(folder IN LISTS modules)
        if(NOT TELETA_GUI AND folder MATCHES "^(widgets|app/console)(/|$)")
            continue()
        endif()
        if(NOT TELETA_PYTHON AND folder MATCHES "^app/python/")
            continue()
        endif()
        add_subdirectory("${CMAKE_SOURCE_DIR}/${folder}" "${CMAKE_BINARY_DIR}/${folder}")
        teleta_target_of("${folder}" target)
        set(parent "${folder}")
        while(parent MATCHES "/")
            set_property(GLOBAL APPEND PROPERTY "teleta_parts_${parent}" ${target})
            if(NOT parent IN_LIST parents)
                list(APPEND parents "${parent}")
            endif()
            get_filename_component(parent "${parent}" DIRECTORY)
        endwhile()
    endforeach()
    foreach(parent IN LISTS parents)
        get_property(parts GLOBAL PROPERTY "teleta_parts_${parent}")
        list(LENGTH parts count)
        if(count GREATER 1)
            teleta_target_of("${parent}" target)
            add_library(${target}_all INTERFACE)
            target_link_libraries(${target}_all INTERFACE ${parts})
        endif()
    endforeach()
endfunction()

# The programs spend their time in the backend and the devices, which keep -O3. The rest is optimized less, and compiles faster.
add_library(teleta_gui_options INTERFACE)
add_library(teleta_quick_options INTERFACE)
if(NOT TELETA_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(teleta_gui_options INTERFACE $<$<CONFIG:Release>:-O2>)
    # With -O1, GCC finds errors in the standard library and in Qt that are not there.
    target_compile_options(
        teleta_quick_options INTERFACE $<$<CONFIG:Release,RelWithDebInfo>:-O1> -Wno-null-dereference -Wno-array-bounds
                                       -Wno-stringop-overflow -Wno-stringop-overread -Wno-maybe-uninitialized
                                       -Wno-free-nonheap-object)
endif()

# A unity build also reads large headers only once: Qt's for the GUI, which halves its time, those of the command line, and of
# GoogleTest for the tests. For the backend that would save little, and GCC then finds errors in the standard library.
if(TELETA_UNITY)
    file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/precompiled.cpp" CONTENT "")
    add_library(teleta_precompiled_cli OBJECT "${CMAKE_BINARY_DIR}/precompiled.cpp")
    target_link_libraries(teleta_precompiled_cli PRIVATE teleta_options CLI11::CLI11 Qt6::Core teleta_quick_options)
    target_precompile_headers(teleta_precompiled_cli PRIVATE <CLI/CLI.hpp> <QtCore/QCoreApplication> <QtCore/QFileInfo> <algorithm>
                              <array> <functional> <map> <memory> <optional> <span> <string> <vector>)
endif()
if(TELETA_GUI AND TELETA_UNITY)
    add_library(teleta_precompiled_gui OBJECT "${CMAKE_BINARY_DIR}/precompiled.cpp")
    target_link_libraries(teleta_precompiled_gui PRIVATE teleta_options Qt6::Widgets teleta_gui_options)
    target_precompile_headers(teleta_precompiled_gui PRIVATE <QtWidgets/QtWidgets> <algorithm> <array> <functional> <map> <memory>
                              <optional> <string> <vector>)
endif()

# A test is compiled more often than it runs, and what takes long in it is in the libraries: so a low optimization. Precompiled
# headers want the same options everywhere, so that also those without Qt are position independent.
# Linked last, so that its options count.
add_library(teleta_test_options INTERFACE)
target_compile_options(teleta_test_options INTERFACE -fPIC)
target_link_libraries(teleta_test_options INTERFACE teleta_quick_options)
# Tests are many, and GNU's linker takes some seconds for each of those with a window.
find_program(TELETA_LLD ld.lld)
if(TELETA_LLD)
    target_link_options(teleta_test_options INTERFACE -fuse-ld=lld)
endif()
if(TELETA_TESTS AND TELETA_UNITY AND NOT TELETA_SANITIZE)
    find_package(GTest REQUIRED)
    add_library(teleta_precompiled_tests OBJECT "${CMAKE_BINARY_DIR}/precompiled.cpp")
    target_link_libraries(teleta_precompiled_tests PRIVATE teleta_options GTest::gtest teleta_test_options)
    target_precompile_headers(teleta_precompiled_tests PRIVATE <gtest/gtest.h> <algorithm> <array> <chrono> <cmath> <fstream>
                              <functional> <map> <memory> <optional> <sstream> <string> <thread> <variant> <vector>)
endif()

# teleta_use_precompiled(TARGET cli|gui): for a target that has no precompiled headers of its own; cli: one that links
# CLI11 and Qt6::Core, gui: Qt6::Widgets.
function(teleta_use_precompiled name kind)
    if(TARGET teleta_precompiled_${kind})
        target_precompile_headers(${name} REUSE_FROM teleta_precompiled_${kind})
    endif()
endfunction()

# teleta_links_widgets(USED LIBRARIES VARIABLE): whether these modules and libraries bring Qt6::Widgets.
function(teleta_links_widgets used libraries variable)
    get_property(with_widgets GLOBAL PROPERTY teleta_with_widgets)
    set(result OFF)
    foreach(one IN LISTS used libraries)
        if(one STREQUAL "Qt6::Widgets" OR one IN_LIST with_widgets)
            set(result ON)
        endif()
    endforeach()
    set(${variable} ${result} PARENT_SCOPE)
endfunction()

# teleta_moc(TARGET a.cpp a.h ...)
# Runs moc on all headers among these, and compiles its output as one source. AUTOMOC takes many times as long: it and moc also
# read every header that these include, and it keeps the output out of a unity build.
function(teleta_moc name)
    file(RELATIVE_PATH folder "${CMAKE_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}")
    teleta_target_of("${folder}" step)
    set(output "${CMAKE_CURRENT_BINARY_DIR}/moc")
    set(made "")
    set(includes "")
    foreach(source IN LISTS ARGN)
        if(source MATCHES "\\.h$")
            get_filename_component(stem "${source}" NAME_WLE)
            add_custom_command(
                OUTPUT "${output}/moc_${stem}.cpp"
                COMMAND Qt6::moc --no-notes -o "${output}/moc_${stem}.cpp" "${CMAKE_CURRENT_SOURCE_DIR}/${source}"
                DEPENDS "${source}"
                VERBATIM)
            list(APPEND made "${output}/moc_${stem}.cpp")
            string(APPEND includes "#include \"moc/moc_${stem}.cpp\"\n")
        endif()
    endforeach()
    file(MAKE_DIRECTORY "${output}")
    file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/mocs.cpp" CONTENT "${includes}" @ONLY)
    target_sources(${name} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/mocs.cpp")
    # CMake knows these commands in this folder only, and the library of a group belongs to another one.
    add_custom_target(${step}_moc DEPENDS ${made})
    add_dependencies(${name} ${step}_moc)
endfunction()

# Most of the compiler's time goes into headers, which a unity build reads once for several sources of a folder. Each of these
# folders is also compiled together with all folders below it, as one library. A folder belongs to the first that fits. What small
# programs use without the rest stays apart, and so does backend/vision, which takes longer to compile as one.
set(TELETA_GROUPS
    backend/contact
    backend/cost
    backend/pattern
    backend/pipeline
    backend/scene_run
    backend/servo
    backend/simulation
    backend/study
    devices/ros
    devices/site
    devices/taxels
    widgets/base
    widgets/view3d
    widgets
    app/cli/commands/tactile
    app/cli/commands
    app/console)
# A build with a sanitizer needs few folders, and would compile whole groups for them.
if(NOT TELETA_UNITY OR TELETA_SANITIZE)
    set(TELETA_GROUPS "")
endif()

# teleta_group_of(FOLDER VARIABLE): the target of the group of this folder, or nothing.
function(teleta_group_of folder variable)
    set(result "")
    foreach(group IN LISTS TELETA_GROUPS)
        if("${folder}/" MATCHES "^${group}/" AND NOT result)
            teleta_target_of("${group}" result)
            string(APPEND result "_group")
        endif()
    endforeach()
    set(${variable} "${result}" PARENT_SCOPE)
endfunction()

# teleta_library(SOURCES a.cpp a.h ... [ALONE b.cpp ...])
# The library of this folder: a static one, or a name for that of its group. The module graph says what it links. A unity build
# compiles the sources together, except those named ALONE. TELETA_COMPILED is the target that compiles them.
function(teleta_library)
    cmake_parse_arguments(ARG "" "" "SOURCES;ALONE" ${ARGN})
    file(RELATIVE_PATH folder "${CMAKE_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}")
    teleta_target_of("${folder}" name)
    get_property(used GLOBAL PROPERTY "teleta_uses_${folder}")
    get_property(libraries GLOBAL PROPERTY "teleta_libraries_${folder}")
    if(NOT ARG_SOURCES MATCHES "\\.cpp")
        add_library(${name} INTERFACE ${ARG_SOURCES})
        target_link_libraries(${name} INTERFACE teleta_options ${used} ${libraries})
        return()
    endif()
    teleta_group_of("${folder}" group)
    if(group)
        if(NOT TARGET ${group})
            add_library(${group} STATIC)
            set_target_properties(${group} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 64)
        endif()
        add_library(${name} INTERFACE)
        target_link_libraries(${name} INTERFACE ${group})
        get_property(members GLOBAL PROPERTY teleta_members_${group})
        list(REMOVE_ITEM used ${members})
        set_property(GLOBAL APPEND PROPERTY teleta_members_${group} ${name})
        set(compiled ${group})
        list(TRANSFORM ARG_SOURCES PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/" OUTPUT_VARIABLE sources)
        target_sources(${group} PRIVATE ${sources})
    else()
        add_library(${name} STATIC ${ARG_SOURCES})
        set_target_properties(${name} PROPERTIES UNITY_BUILD ${TELETA_UNITY} UNITY_BUILD_BATCH_SIZE 24)
        set(compiled ${name})
    endif()
    set(TELETA_COMPILED ${compiled} PARENT_SCOPE)
    if(ARG_ALONE)
        list(TRANSFORM ARG_ALONE PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
        set_source_files_properties(
            ${ARG_ALONE} TARGET_DIRECTORY ${compiled} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
    set(options "")
    if(folder MATCHES "^(widgets|app/console)(/|$)")
        teleta_moc(${compiled} ${ARG_SOURCES})
        teleta_links_widgets("${used}" "${libraries}" links)
        if(links)
            set_property(GLOBAL APPEND PROPERTY teleta_with_widgets ${name})
        endif()
        if(links AND NOT folder MATCHES "^widgets/view3d(/|$)")
            teleta_use_precompiled(${compiled} gui)
        endif()
        set(options teleta_gui_options)
    elseif(folder MATCHES "^app/cli(/|$)")
        teleta_use_precompiled(${compiled} cli)
        set(options teleta_quick_options)
    elseif(folder MATCHES "^app/python/")
        # Fewer sources at once: each takes long, and their types are hidden as those of pybind11 are.
        set_target_properties(${compiled} PROPERTIES CXX_VISIBILITY_PRESET hidden UNITY_BUILD_BATCH_SIZE 4)
    endif()
    # VTK stays private: what uses the 3-D view does not compile against it.
    if(teleta_vtk IN_LIST libraries)
        list(REMOVE_ITEM libraries teleta_vtk)
        target_link_libraries(${compiled} PRIVATE teleta_vtk)
        vtk_module_autoinit(TARGETS ${compiled} MODULES ${TELETA_VTK_MODULES})
    endif()
    target_link_libraries(${compiled} PUBLIC teleta_options ${used} ${libraries})
    if(options)
        target_link_libraries(${compiled} PRIVATE ${options}) # last, so that they override the others
    endif()
endfunction()

# teleta_module(NAME SOURCES ... LINKS ...)
# A module that core::findPart finds. It is bound at once, so that one that lacks something is refused as it is loaded.
function(teleta_module name)
    cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
    add_library(${name} MODULE ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE teleta_options ${ARG_LINKS})
    # The C library also where a small one calls none of it: packages are refused without.
    target_link_options(${name} PRIVATE LINKER:-z,now LINKER:--push-state,--no-as-needed,-lc,--pop-state)
    set_target_properties(${name} PROPERTIES PREFIX "" CXX_VISIBILITY_PRESET hidden
                                             LIBRARY_OUTPUT_DIRECTORY "${TELETA_PARTS_TREE}")
    install(TARGETS ${name} LIBRARY DESTINATION lib/teleta-console)
endfunction()

# teleta_program_part(NAME SOURCES ... LINKS ...)
# A module with code of ours that a program runs. It loads only the libraries that it uses, and exports one constant.
function(teleta_program_part name)
    teleta_module(${name} ${ARGN})
    target_link_options(${name} PRIVATE LINKER:--exclude-libs,ALL LINKER:--as-needed LINKER:--gc-sections)
endfunction()

# teleta_part(NAME SOURCES ... LINKS ...)
# A module that core::loadPart loads: it alone links libraries that take long to load. Declare it after the library of
# the folder, which then brings it along. Those of the backend go with the Python module, too.
function(teleta_part name)
    file(RELATIVE_PATH folder "${CMAKE_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}")
    teleta_module(${name} ${ARGN})
    add_dependencies(${TELETA_COMPILED} ${name})
    if(folder MATCHES "^backend/")
        set_property(GLOBAL APPEND PROPERTY teleta_parts ${name})
    endif()
endfunction()

# teleta_python_module(NAME LINKS ...)
# The extension module NAME of the Python package, from module.cpp in this folder. It hides all symbols but the one that
# Python looks for, so that two modules that hold the same library do not mix.
function(teleta_python_module name)
    cmake_parse_arguments(ARG "" "" "LINKS" ${ARGN})
    pybind11_add_module(${name} MODULE NO_EXTRAS module.cpp)
    # Python.h has fields named slots.
    target_compile_definitions(${name} PRIVATE TELETA_VERSION="${PROJECT_VERSION}" QT_NO_KEYWORDS)
    target_link_libraries(${name} PRIVATE ${ARG_LINKS})
    target_link_options(${name} PRIVATE LINKER:--exclude-libs,ALL LINKER:--as-needed LINKER:--gc-sections)
    set_target_properties(${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY "${TELETA_PYTHON_TREE}/teleta")
endfunction()

# teleta_test(NAME LABEL unit|stability|gui|gl|peer|soak SOURCES ... DEPENDS ... [ALONE ...] [TIMEOUT s])
# One GoogleTest program, registered as one CTest test. Those labelled stability run with invalid operations and
# divisions by zero trapped. A unity build compiles the sources together, except those named ALONE, which use names of
# others.
function(teleta_test name)
    cmake_parse_arguments(ARG "" "LABEL;TIMEOUT" "SOURCES;DEPENDS;ALONE" ${ARGN})
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT 300)
    endif()
    # A sanitizer takes five to fifteen times as long.
    if(TELETA_SANITIZE)
        math(EXPR ARG_TIMEOUT "${ARG_TIMEOUT} * 10")
    endif()
    add_executable(${name} ${ARG_SOURCES})
    if(ARG_LABEL STREQUAL "stability")
        target_sources(${name} PRIVATE "${CMAKE_SOURCE_DIR}/tests/support/trapped_main.cpp")
        target_link_libraries(${name} PRIVATE teleta_options ${ARG_DEPENDS} GTest::gtest teleta_test_options)
    else()
        target_link_libraries(${name} PRIVATE teleta_options ${ARG_DEPENDS} GTest::gtest_main teleta_test_options)
    endif()
    if(TARGET teleta_precompiled_tests)
        target_precompile_headers(${name} REUSE_FROM teleta_precompiled_tests)
    endif()
    # With a sanitizer a single source takes up to a minute to compile, so they are not joined.
    if(TELETA_UNITY AND NOT TELETA_SANITIZE)
        set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
        set_source_files_properties(${ARG_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
        # What a header's unnamed namespace hides, GCC takes for visible in a source that is included.
        target_compile_options(${name} PRIVATE -Wno-subobject-linkage)
    endif()
    target_compile_definitions(${name} PRIVATE TELETA_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABEL}" TIMEOUT ${ARG_TIMEOUT})
endfunction()

# teleta_gui_test(NAME LABEL gui|gl|peer SOURCES ... DEPENDS ... [WITHIN program])
# One Qt Test program; what it depends on brings Qt6::Widgets. Label gui runs offscreen; label gl runs under Xvfb, since
# offscreen has no QOpenGLWidget. WITHIN runs the test, as with_sound_session.sh does.
# QTRY_VERIFY_WITH_TIMEOUT reports a failure only after three times its timeout; the default TIMEOUT leaves time for
# that.
function(teleta_gui_test name)
    cmake_parse_arguments(ARG "" "LABEL;TIMEOUT;WITHIN" "SOURCES;DEPENDS" ${ARGN})
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT 600)
    endif()
    add_executable(${name} ${ARG_SOURCES})
    # A test includes the output of moc. teleta_moc() says why AUTOMOC does not run it.
    set(moc_folder "${CMAKE_CURRENT_BINARY_DIR}/${name}_moc")
    file(MAKE_DIRECTORY "${moc_folder}")
    foreach(source IN LISTS ARG_SOURCES)
        get_filename_component(stem "${source}" NAME_WLE)
        get_filename_component(path "${source}" ABSOLUTE)
        file(STRINGS "${path}" includes REGEX "^#include \"${stem}\\.moc\"")
        if(includes)
            add_custom_command(
                OUTPUT "${moc_folder}/${stem}.moc"
                COMMAND Qt6::moc "-D$<JOIN:$<TARGET_PROPERTY:${name},COMPILE_DEFINITIONS>,;-D>" -o "${moc_folder}/${stem}.moc" "${path}"
                DEPENDS "${path}"
                COMMAND_EXPAND_LISTS VERBATIM)
            target_sources(${name} PRIVATE "${moc_folder}/${stem}.moc")
        endif()
    endforeach()
    target_include_directories(${name} PRIVATE "${moc_folder}")
    teleta_use_precompiled(${name} gui)
    target_link_libraries(${name} PRIVATE teleta_options ${ARG_DEPENDS} Qt6::Test teleta_test_options)
    target_compile_definitions(${name} PRIVATE TELETA_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
    if(ARG_LABEL STREQUAL "gl")
        find_program(TELETA_XVFB_RUN xvfb-run REQUIRED)
        add_test(NAME ${name} COMMAND ${TELETA_XVFB_RUN} -a -s "-screen 0 1600x1000x24" $<TARGET_FILE:${name}>)
        # Two xvfb-run -a that start at once may choose the same display number.
        set_tests_properties(${name} PROPERTIES ENVIRONMENT "QT_QPA_PLATFORM=xcb;LIBGL_ALWAYS_SOFTWARE=1"
                                                RESOURCE_LOCK xvfb)
    else()
        add_test(NAME ${name} COMMAND ${ARG_WITHIN} $<TARGET_FILE:${name}>)
        set_tests_properties(${name} PROPERTIES ENVIRONMENT "QT_QPA_PLATFORM=offscreen")
    endif()
    set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABEL}" TIMEOUT ${ARG_TIMEOUT})
endfunction()
