// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/arm_model/motion_limits.h"

#include <QStringList>

#include <cstdint>
#include <vector>

namespace teleta::arm_model {

/// A limit of the motion as it is called.
struct NamedLimit {
    MotionFlag flag;
    const char* name; ///< for other programs: "joint_rate", ...
    QString text;     ///< translated
};

/// The limits of which an operator is told: all but the acceleration, which acts in each motion, and demands
/// that are no numbers. Thread: any.
[[nodiscard]] std::vector<NamedLimit> namedLimits();

/// Those of them that act, in words. flags: of MotionFlag. Thread: any.
[[nodiscard]] QStringList limitTexts(std::uint32_t flags);

} // namespace teleta::arm_model
