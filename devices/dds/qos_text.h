// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/ros/qos_profile.h"

#include <QString>

namespace teleta::dds {

/// Why a publisher and a subscriber of one topic do not find each other, for people, translated. Thread: any.
[[nodiscard]] QString describe(ros::QosMismatch mismatch);

} // namespace teleta::dds
