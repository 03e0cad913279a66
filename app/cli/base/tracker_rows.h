// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/base/command_io.h"
#include "backend/vision/contacts/camera_tracker.h"

#include <span>

namespace teleta::cli {

/// Writes one row for each contact of a frame that is seen or has just ended.
void writeContacts(RowOutput& rows, long long frame, double time_s, const vision::CameraTracker& tracker,
                   std::span<const vision::FollowedContact> contacts);

/// Says on standard error how many frames a tracker could not use, and why; nothing when it used all. The
/// rows alone do not tell.
void warnOfUnusableFrames(const vision::CameraTracker& tracker);

} // namespace teleta::cli
