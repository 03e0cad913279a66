# SPDX-License-Identifier: GPL-3.0-or-later
# Compiler settings and the three functions with which every folder declares its target.
include_guard(GLOBAL)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# Everybody may look into the folders that an installation makes, whatever the umask of whoever makes it.
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

find_package(Threads REQUIRED)

add_library(teleta_options INTERFACE)
target_include_directories(teleta_options INTERFACE "${CMAKE_SOURCE_DIR}")
target_compile_options(teleta_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
                                                -Wnull-dereference -Wdouble-promotion -Wcast-align -fno-math-errno)
target_link_libraries(teleta_options INTERFACE Threads::Threads)
if(TELETA_WERROR)
    target_compile_options(teleta_options INTERFACE -Werror)
endif()
if(TELETA_SANITIZE)
    target_compile_options(teleta_options INTERFACE -fsanitize=${TELETA_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(teleta_options INTERFACE -fsanitize=${TELETA_SANITIZE})
    if(TELETA_SANITIZE MATCHES "undefined")
        target_compile_options(teleta_options INTERFACE -fno-sanitize-recover=undefined)
    endif()
    if(TELETA_SANITIZE MATCHES "address")
        # With that sanitizer Eigen would take its own allocator; what Ceres was built with is the ordinary one.
        target_compile_definitions(teleta_options INTERFACE EIGEN_MALLOC_ALREADY_ALIGNED=1)
    endif()
    if(TELETA_SANITIZE MATCHES "fuzzer")
        # Divisions stay where the source has them: their exceptions are trapped.
        target_compile_options(teleta_options INTERFACE -ffp-exception-behavior=maytrap)
    endif()
endif()

# teleta_library(NAME SOURCES a.cpp a.h ... DEPENDS targets ...)
# A static library of one folder. The dependencies named here are the allowed edges of the module graph.
function(teleta_library name)
    cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
    add_library(${name} STATIC ${ARG_SOURCES})
    target_link_libraries(${name} PUBLIC teleta_options ${ARG_DEPENDS})
    # Most of the compiler's time goes into headers, which so are read once for several sources.
    set_target_properties(${name} PROPERTIES UNITY_BUILD ${TELETA_UNITY} UNITY_BUILD_BATCH_SIZE 10)
endfunction()

# teleta_test(NAME LABEL unit|stability|gui|gl|peer|soak SOURCES ... DEPENDS ... [TIMEOUT s])
# One GoogleTest program, registered as one CTest test. Those labelled stability run with invalid operations and
# divisions by zero trapped.
function(teleta_test name)
    cmake_parse_arguments(ARG "" "LABEL;TIMEOUT" "SOURCES;DEPENDS" ${ARGN})
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
        target_link_libraries(${name} PRIVATE teleta_options ${ARG_DEPENDS} GTest::gtest)
    else()
        target_link_libraries(${name} PRIVATE teleta_options ${ARG_DEPENDS} GTest::gtest_main)
    endif()
    target_compile_definitions(${name} PRIVATE TELETA_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABEL}" TIMEOUT ${ARG_TIMEOUT})
endfunction()

# teleta_gui_test(NAME LABEL gui|gl SOURCES ... DEPENDS ...)
# One Qt Test program. Label gui runs offscreen; label gl runs under Xvfb, since offscreen has no QOpenGLWidget.
# A check that waits tells its failure after three times its patience only (QTRY_VERIFY_WITH_TIMEOUT): the default
# leaves time for that.
function(teleta_gui_test name)
    cmake_parse_arguments(ARG "" "LABEL;TIMEOUT" "SOURCES;DEPENDS" ${ARGN})
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT 600)
    endif()
    add_executable(${name} ${ARG_SOURCES})
    set_target_properties(${name} PROPERTIES AUTOMOC ON)
    target_link_libraries(${name} PRIVATE teleta_options ${ARG_DEPENDS} Qt6::Test)
    target_compile_definitions(${name} PRIVATE TELETA_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
    if(ARG_LABEL STREQUAL "gl")
        find_program(TELETA_XVFB_RUN xvfb-run REQUIRED)
        add_test(NAME ${name} COMMAND ${TELETA_XVFB_RUN} -a -s "-screen 0 1600x1000x24" $<TARGET_FILE:${name}>)
        # xvfb-run -a does not choose its display number safely when two of them start at once.
        set_tests_properties(${name} PROPERTIES ENVIRONMENT "QT_QPA_PLATFORM=xcb;LIBGL_ALWAYS_SOFTWARE=1"
                                                RESOURCE_LOCK xvfb)
    else()
        add_test(NAME ${name} COMMAND ${name})
        set_tests_properties(${name} PROPERTIES ENVIRONMENT "QT_QPA_PLATFORM=offscreen")
    endif()
    set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABEL}" TIMEOUT ${ARG_TIMEOUT})
endfunction()
