# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DSOURCE=FOLDER -DOUT=FILE [-DCOMMIT=HASH] -P write_commit.cmake
# Writes the header that names the commit of a source tree; a file that says so already is left as it is. COMMIT is for
# a tree without its history.
set(modified false)
if(NOT COMMIT)
    execute_process(COMMAND git -C "${SOURCE}" describe --always --dirty --abbrev=12 --exclude=* OUTPUT_VARIABLE COMMIT
                    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE result)
    # A repository around the source, as that of a package, is not its own.
    execute_process(COMMAND git -C "${SOURCE}" rev-parse --show-prefix OUTPUT_VARIABLE prefix
                    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(NOT result EQUAL 0 OR prefix)
        set(COMMIT "")
    endif()
endif()
if(COMMIT MATCHES "^([0-9a-f]+)-dirty$")
    set(COMMIT "${CMAKE_MATCH_1}")
    set(modified true)
endif()
set(content "#pragma once\n#define TELETA_COMMIT \"${COMMIT}\"\n#define TELETA_COMMIT_MODIFIED ${modified}\n")
set(before "")
if(EXISTS "${OUT}")
    file(READ "${OUT}" before)
endif()
if(NOT content STREQUAL before)
    file(WRITE "${OUT}" "${content}")
endif()
