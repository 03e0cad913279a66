// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace teleta::vision {
class CameraTracker;
}

namespace teleta::cli {

/// Says on standard error how many frames a tracker could not use, and why; nothing when it used all. The
/// rows alone do not tell.
void warnOfUnusableFrames(const vision::CameraTracker& tracker);

} // namespace teleta::cli
