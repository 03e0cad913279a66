// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/contact_columns.h"

#include <gtest/gtest.h>

#include <cmath>

using teleta::contact::Contact;
using teleta::contact::contactColumns;
using teleta::contact::contactNumbers;
using teleta::contact::ShearLoad;

TEST(ContactColumns, endWithTheUnitOfTheLoads) {
    using Names = std::vector<std::string>;
    EXPECT_EQ(contactColumns("N", false),
              (Names{"contact_id", "x_m", "y_m", "force_n", "peak_n", "area_m2"}));
    EXPECT_EQ(contactColumns("counts", false)[3], "force_counts");
    EXPECT_EQ(contactColumns("N", true), (Names{"contact_id", "x_m", "y_m", "force_n", "peak_n", "area_m2",
                                                "shear_x_n", "shear_y_n", "moment_z_nm", "friction_ratio"}));
    EXPECT_EQ(contactColumns("\u00b5T", true)[8], "moment_z_ut_m");
}

TEST(ContactColumns, haveTheNumbersInTheirOrder) {
    Contact contact{
        .id = 7, .x_m = 0.1, .y_m = 0.2, .force_N = 3.0, .peak_N = 2.0, .area_m2 = 1e-4, .shear = {}};
    EXPECT_EQ(contactNumbers(contact, false), (std::vector<double>{0.1, 0.2, 3.0, 2.0, 1e-4}));
    ASSERT_EQ(contactNumbers(contact, true).size() + 1, contactColumns("N", true).size());
    EXPECT_TRUE(std::isnan(contactNumbers(contact, true)[8])) << "nobody tells the shear";
    contact.shear = ShearLoad{0.3, -0.4, 0.001, 0.5 / 3.0};
    EXPECT_EQ(contactNumbers(contact, true),
              (std::vector<double>{0.1, 0.2, 3.0, 2.0, 1e-4, 0.3, -0.4, 0.001, 0.5 / 3.0}));
}
