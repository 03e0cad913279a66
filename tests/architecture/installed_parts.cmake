# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DPROGRAM=FILE -DPARTS=FOLDER -DWORK=FOLDER -P installed_parts.cmake
# The program as it is installed finds its parts, and says which one is missing.
file(REMOVE_RECURSE "${WORK}")
get_filename_component(name "${PROGRAM}" NAME)
set(folder "${WORK}/lib/teleta-console")

# install_one(FILE DESTINATION): without the search path of the build tree, as it is installed.
function(install_one file destination)
    file(COPY "${file}" DESTINATION "${destination}")
    get_filename_component(file_name "${file}" NAME)
    file(RPATH_REMOVE FILE "${destination}/${file_name}")
endfunction()

install_one("${PROGRAM}" "${WORK}/bin")
set(command "${WORK}/bin/${name}" simulate vtacarm-bump --duration 0.1 --out)

# expect_missing(PART): the command ends with an error that names this file.
function(expect_missing part)
    execute_process(COMMAND ${command} "${WORK}/without" RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE text)
    if(result EQUAL 0 OR NOT text MATCHES "${part}\\.so")
        message(FATAL_ERROR "without ${part} the program ends with '${result}' and says: ${text}")
    endif()
endfunction()

expect_missing(teleta_commands)
install_one("${PARTS}/teleta_everyday.so" "${folder}")
expect_missing(teleta_commands)
# The everyday commands need their own module only.
foreach(everyday features contacts gains stiffness contour)
    execute_process(COMMAND "${WORK}/bin/${name}" ${everyday} --help RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
    if(NOT result EQUAL 0 OR NOT text MATCHES "teleta ${everyday} ")
        message(FATAL_ERROR "${everyday} --help ends with '${result}' and says: ${text}")
    endif()
endforeach()
install_one("${PARTS}/teleta_commands.so" "${folder}")
expect_missing(teleta_opencv_pictures)

file(GLOB parts "${PARTS}/teleta_*.so")
foreach(part IN LISTS parts)
    install_one("${part}" "${folder}")
endforeach()
execute_process(COMMAND ${command} "${WORK}/with" RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE text)
if(NOT result EQUAL 0 OR NOT EXISTS "${WORK}/with/reference.png")
    message(FATAL_ERROR "with its parts the program ends with '${result}' and says: ${text}")
endif()
file(REMOVE_RECURSE "${WORK}")
