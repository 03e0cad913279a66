// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/column_unit.h"

#include <gtest/gtest.h>

using namespace teleta::core;

TEST(ColumnUnit, isWrittenInLettersAndDigits) {
    EXPECT_EQ(columnUnit("N"), "n");
    EXPECT_EQ(columnUnit("counts"), "counts");
    EXPECT_EQ(columnUnit("\u00b5T"), "ut") << "the micro sign";
    EXPECT_EQ(columnUnit("\u03bcT"), "ut") << "the Greek letter";
    EXPECT_EQ(columnUnit("N/m"), "n_per_m");
    EXPECT_EQ(columnUnit("\u00b0C"), "c");
    EXPECT_EQ(columnUnit(""), "counts");
}

TEST(ColumnUnit, ofAMomentIsThatOfTheLoadTimesMetres) {
    EXPECT_EQ(momentColumnUnit("N"), "nm");
    EXPECT_EQ(momentColumnUnit("counts"), "counts_m");
    EXPECT_EQ(momentColumnUnit("\u00b5T"), "ut_m");
}
