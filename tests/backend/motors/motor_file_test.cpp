// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/motor_file.h"
#include "tests/backend/core/temporary_folder.h"

#include <QByteArray>

#include <gtest/gtest.h>

using namespace teleta;
using motors::CalibratedMotor;
using motors::MotorCalibration;
using motors::parseMotors;

namespace {

MotorCalibration sample() {
    MotorCalibration calibration;
    calibration.bracelet = "TB-0042 \"left\"\\\t";
    CalibratedMotor& motor = calibration.motors[1];
    motor.startFrom = CalibratedMotor::Origin::answers;
    motor.lagFrom = CalibratedMotor::Origin::recording;
    motor.profile.name = "elbow side";
    motor.profile.assumed = motor.profile.rangeAssumed = false;
    motor.profile.startDrive = 0.1 + 0.2;
    motor.profile.fullDrive = 0.93;
    motor.profile.riseTime_s = 0.0551;
    motor.profile.curve = {{0.25, 61.5}, {0.6, 1.0 / 3.0 + 100.0}, {1.0, 251.0}};
    motor.startError = 0.0072;
    motor.riseError_s = 1e-5;
    return calibration;
}

std::string whyNot(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    text.replace(at, what.size(), with);
    const auto parsed = parseMotors(text, "m.toml");
    return parsed ? std::string() : core::describe(parsed.error());
}

} // namespace

TEST(MotorFile, comesBackAsItWasWritten) {
    const auto again = parseMotors(motorsText(sample()), "m.toml");
    ASSERT_TRUE(again) << core::describe(again.error());
    EXPECT_EQ(*again, sample());
    EXPECT_TRUE(again->measured());
    EXPECT_FALSE(MotorCalibration{}.measured());
}

TEST(MotorFile, isRefusedWithThePlaceOfWhatIsWrong) {
    const std::string text = motorsText(sample());
    EXPECT_NE(whyNot(text, "version = 1", "version = 2")
                  .find("m.toml:2:11: the file was written by a newer version"),
              std::string::npos)
        << whyNot(text, "version = 1", "version = 2");
    EXPECT_NE(whyNot(text, "full_drive = 0.93", "full_drvie = 0.93").find("full_drvie"), std::string::npos);
    EXPECT_NE(whyNot(text, "full_drive = 0.93", "full_drive = 1.5").find("1.5"), std::string::npos);
    EXPECT_NE(whyNot(text, "speed_Hz = 61.5", "speed_Hz = 161.5").find("inconsistent"), std::string::npos);
    EXPECT_NE(whyNot(text, "speed_Hz = 61.5", "speed_Hz = \"fast\"").find("m.toml:"), std::string::npos);
    EXPECT_NE(whyNot(text, "start_from = \"answers\"", "start_from = \"guess\"").find("answers"),
              std::string::npos);
    EXPECT_NE(whyNot(text, "[[motor]]", "[[motor]").find("m.toml:"), std::string::npos);
    EXPECT_NE(whyNot(text, "\n[[motor]]", "\n[[moto]]").find("moto"), std::string::npos);
}

TEST(MotorFile, goesToTheUsersConfigurationUnderTheSerialNumber) {
    const test::TemporaryFolder folder;
    const QByteArray before = qgetenv("XDG_CONFIG_HOME");
    qputenv("XDG_CONFIG_HOME", QByteArray::fromStdString(folder.path("")));
    MotorCalibration calibration = sample();
    calibration.bracelet = "tcp://192.168.0.20:502#1";
    const std::string path = motors::profilePath(calibration.bracelet);
    EXPECT_NE(path.find("teleta/motors/tcp%3A%2F%2F192%2E168%2E0%2E20%3A502%231.toml"), std::string::npos)
        << path;
    const auto none = motors::findMotors(calibration.bracelet);
    ASSERT_TRUE(none);
    EXPECT_FALSE(none->has_value());
    ASSERT_TRUE(motors::writeMotors(calibration, path));
    const auto found = motors::findMotors(calibration.bracelet);
    ASSERT_TRUE(found && found->has_value());
    EXPECT_EQ(**found, calibration);

    calibration.bracelet = "another";
    ASSERT_TRUE(motors::writeMotors(calibration, path));
    EXPECT_FALSE(motors::findMotors("tcp://192.168.0.20:502#1")) << "a profile of another bracelet";
    EXPECT_EQ(motors::profilePath(""), "");
    if (before.isEmpty())
        qunsetenv("XDG_CONFIG_HOME");
    else
        qputenv("XDG_CONFIG_HOME", before);
}

TEST(MotorFile, aStartBelowTheCurveCarriesTheCurveOnDownToIt) {
    const pattern::MotorProfile motor = sample().motors[1].profile;
    const pattern::MotorProfile lower = motors::withStart(motor, 0.2);
    EXPECT_TRUE(lower.valid());
    EXPECT_EQ(lower.startDrive, 0.2);
    const double slope = (1.0 / 3.0 + 100.0 - 61.5) / 0.35;
    EXPECT_NEAR(steadySpeed_Hz(lower, 0.2), 61.5 - 0.05 * slope, 1e-9);
    const pattern::MotorProfile higher = motors::withStart(motor, 0.4);
    EXPECT_TRUE(higher.valid());
    EXPECT_EQ(higher.curve, motor.curve);
}

TEST(MotorFile, aStartBelowACurveThatBeginsAtRestMovesItsBegin) {
    pattern::MotorProfile motor = sample().motors[1].profile;
    motor.curve.front().speed_Hz = 0.0;
    ASSERT_TRUE(motor.valid());
    const pattern::MotorProfile lower = motors::withStart(motor, 0.2);
    EXPECT_TRUE(lower.valid());
    EXPECT_EQ(steadySpeed_Hz(lower, 0.2), 0.0);
    ASSERT_EQ(lower.curve.size(), motor.curve.size());
    EXPECT_EQ(lower.curve[1], motor.curve[1]);
}
