// SPDX-License-Identifier: GPL-3.0-or-later
// Runs all tests of a program with invalid operations and divisions by zero trapped.
#include "tests/support/floating_point_traps.h"

#include <gtest/gtest.h>

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    const teleta::test::FloatingPointTraps traps;
    return RUN_ALL_TESTS();
}
