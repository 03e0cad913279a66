// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <opencv2/core.hpp>

#include <string>

namespace teleta::scene_run {

/// Writes an image in the format that its name ends with. Error: ioFailed.
[[nodiscard]] core::Expected<void> writeImage(const std::string& path, const cv::Mat1b& image);

} // namespace teleta::scene_run
