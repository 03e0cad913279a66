// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <opencv2/core.hpp>

#include <string>

namespace teleta::scene_run {

/// Writes reference.png, the tube with nothing touching it. Without a folder nothing is written. Error:
/// ioFailed.
[[nodiscard]] core::Expected<void> writeReference(const std::string& outFolder, const cv::Mat1b& image);

} // namespace teleta::scene_run
