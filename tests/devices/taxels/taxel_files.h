// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/taxels/taxels_file.h"

#include <gtest/gtest.h>

#include <string>

namespace teleta::taxels::test {

inline std::string serialLink(const std::string& path) {
    return "[link]\ntype = 'serial'\npath = '" + path + "'\n";
}

inline const std::string kGrid = "[layout]\nrows = 6\ncolumns = 14\npitch_x_mm = 3.4\nunit = 'counts'\n";

/// The frames of tests/peer/taxels/board.py.
inline const std::string kCounted =
    "[frame]\nencoding = 'binary'\nsync = 'AA 55'\n"
    "length_field = { at = 2, type = 'uint16', counts = 'payload' }\n"
    "checksum = { type = 'crc16-ccitt' }\ncounter = { at = 4, type = 'uint8' }\n"
    "time = { at = 5, type = 'uint32', unit = 'us' }\nvalues = { at = 9, type = 'uint16', count = 84 }\n";
inline const std::string kCrc32 =
    "[frame]\nencoding = 'binary'\nsync = '7E'\nlength = 173\n"
    "checksum = { type = 'crc32', from = 0, order = 'big' }\n"
    "values = { at = 1, type = 'int16', order = 'big', count = 84, scale = 1.0, offset = 32768.0 }\n";
inline const std::string kCsv = "[frame]\nencoding = 'csv'\ncolumns = '2..85'\ntime_column = 1\nskip = 0\n";
inline const std::string kJson =
    "[frame]\nencoding = 'json'\nvalues = '/sensors/0/data'\ncount = 84\ntime = '/t'\n";

inline std::string head() {
    return "kind = 'taxels'\nname = 'glove'\nthreshold = 5.0\n";
}

inline TaxelsFile parsed(const std::string& text) {
    auto file = parseTaxels(text, "/files/glove.toml");
    EXPECT_TRUE(file) << core::describe(file.error());
    return file.value_or(TaxelsFile());
}

} // namespace teleta::taxels::test
