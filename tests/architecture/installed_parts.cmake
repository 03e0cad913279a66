# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DPROGRAM=FILE -DPARTS=FOLDER -DWORK=FOLDER -P installed_parts.cmake
# The program as it is installed finds its parts, and says which one is missing.
file(REMOVE_RECURSE "${WORK}")
file(COPY "${PROGRAM}" DESTINATION "${WORK}/bin")
get_filename_component(name "${PROGRAM}" NAME)
file(RPATH_REMOVE FILE "${WORK}/bin/${name}")
set(command "${WORK}/bin/${name}" simulate vtacarm-bump --duration 0.1 --out)

execute_process(COMMAND ${command} "${WORK}/without" RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE text)
if(result EQUAL 0 OR NOT text MATCHES "teleta_opencv_pictures\\.so")
    message(FATAL_ERROR "without its parts the program ends with '${result}' and says: ${text}")
endif()

file(COPY "${PARTS}/" DESTINATION "${WORK}/lib/teleta-console")
execute_process(COMMAND ${command} "${WORK}/with" RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE text)
if(NOT result EQUAL 0 OR NOT EXISTS "${WORK}/with/reference.png")
    message(FATAL_ERROR "with its parts the program ends with '${result}' and says: ${text}")
endif()
file(REMOVE_RECURSE "${WORK}")
