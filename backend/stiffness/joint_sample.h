// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::stiffness {

/// One reading of the joint that presses: angle and torque at the same time.
struct JointSample {
    double time_s = 0.0;
    double angle_rad = 0.0;
    double torque_Nm = 0.0;

    bool operator==(const JointSample&) const = default;
};

/// The range of joint torque over which a touch is evaluated. Valid: finite, 0 <= low < high. Source of the
/// defaults: TeleTA, section 2.
struct TorqueWindow {
    double low_Nm = 0.02;
    double high_Nm = 0.05;

    [[nodiscard]] double width_Nm() const { return high_Nm - low_Nm; }
    [[nodiscard]] double middle_Nm() const { return low_Nm + 0.5 * width_Nm(); }
};

} // namespace teleta::stiffness
