// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/array/contact_errors.h"

#include <gtest/gtest.h>

#include <array>

using teleta::contact::Contact;
using teleta::scene_run::ContactErrors;

namespace {

Contact at(double x_m, double y_m) {
    Contact contact;
    contact.x_m = x_m;
    contact.y_m = y_m;
    return contact;
}

} // namespace

TEST(ContactErrors, countTheDistanceToTheNearestContact) {
    ContactErrors errors;
    const std::array found{at(0.0, 0.0), at(0.1, 0.0)};
    errors.add(0.103, 0.004, found);
    nlohmann::ordered_json measures;
    errors.report(measures);
    EXPECT_NEAR(measures["contact_error_mean_m"].get<double>(), 0.005, 1e-15);
    EXPECT_EQ(errors.compared(), 1U);
}

TEST(ContactErrors, countALoadWithoutAnyContactAsMissed) {
    ContactErrors errors;
    errors.add(0.0, 0.0, {});
    EXPECT_EQ(errors.missed(), 1U);
    EXPECT_EQ(errors.compared(), 0U);
    nlohmann::ordered_json measures;
    errors.report(measures);
    EXPECT_TRUE(measures["contact_error_mean_m"].is_null());
    EXPECT_TRUE(measures["contact_error_p95_m"].is_null());
}
