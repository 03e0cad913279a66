// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/unit_names.h"

#include <gtest/gtest.h>

using teleta::core::lowerCaseUnit;
using teleta::core::unitOf;
using teleta::core::unitOfColumn;
using teleta::core::withoutUnit;

TEST(UnitNames, aKeyHasItsUnitInEitherLetterCase) {
    EXPECT_EQ(unitOf("stiffness_N_per_m"), "N/m");
    EXPECT_EQ(unitOf("stiffness_n_per_m"), "N/m");
    EXPECT_EQ(unitOf("rate_Hz"), "Hz");
    EXPECT_EQ(unitOf("rate_hz"), "Hz");
    EXPECT_EQ(unitOf("duration_s"), "s");
    EXPECT_EQ(unitOf("name"), "");
    EXPECT_EQ(unitOf("mm_per_px"), "mm/px");
    EXPECT_EQ(unitOf("_s"), "") << "a unit of nothing";
    EXPECT_EQ(withoutUnit("highest_torque_Nm"), "highest_torque");
    EXPECT_EQ(lowerCaseUnit("highest_torque_Nm"), "highest_torque_nm");
    EXPECT_EQ(lowerCaseUnit("A_rate_Hz"), "A_rate_hz") << "the name itself stays";
    EXPECT_EQ(lowerCaseUnit("name"), "name");
    EXPECT_EQ(lowerCaseUnit(""), "");
}

TEST(UnitNames, aColumnIsInLowerCaseAndNmIsTheNewtonMetre) {
    EXPECT_EQ(unitOfColumn("joint_torque_nm"), "N m");
    EXPECT_EQ(unitOfColumn("force_n"), "N");
    EXPECT_EQ(unitOfColumn("object_stiffness_n_per_m"), "N/m");
    EXPECT_EQ(unitOfColumn("object_stiffness_lower_95"), "N/m");
    EXPECT_EQ(unitOfColumn("lambda1_m2"), "m²");
    EXPECT_EQ(unitOfColumn("field_ut"), "µT");
    EXPECT_EQ(unitOfColumn("pressure_pa"), "Pa");
    EXPECT_EQ(unitOfColumn("time_ns"), "ns");
    EXPECT_EQ(unitOfColumn("force_N"), std::nullopt);
    EXPECT_EQ(unitOfColumn("torque_Nm"), std::nullopt);
    EXPECT_EQ(unitOfColumn("temperature"), std::nullopt);
    EXPECT_EQ(unitOfColumn(""), std::nullopt);
    EXPECT_EQ(unitOfColumn("42"), std::nullopt);
}

TEST(UnitNames, aColumnWithoutAUnitAndANumberedOneAreKnown) {
    EXPECT_EQ(unitOfColumn("contact_id"), "");
    EXPECT_EQ(unitOfColumn("qw"), "");
    EXPECT_EQ(unitOfColumn("n"), "") << "a count";
    EXPECT_EQ(unitOfColumn("t83"), "");
    EXPECT_EQ(unitOfColumn("q4"), "rad");
    EXPECT_EQ(unitOfColumn("tau4"), "N m");
}
