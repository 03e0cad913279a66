// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/frames/frame_request.h"

namespace teleta::console {

/// The request with the array that the file at its knownPath describes, which also says the threshold where
/// nobody did; without such a file as it is. Error: as taxels::readLayout(). Thread: any but the GUI's.
[[nodiscard]] core::Expected<frames::FrameRequest> withKnownArray(frames::FrameRequest request);

} // namespace teleta::console
