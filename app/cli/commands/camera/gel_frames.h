// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/vision/gel/marker_gel_file.h"

#include <opencv2/core.hpp>

#include <string>
#include <vector>

namespace teleta::cli {

/// The first pictures of a gel, as many as its rest needs, from its camera or a video, without what the file
/// crops; fewer where it ends before. Error: as VideoStream::open() and MarkerGel::picture(), with the source
/// named; interrupted. Thread: one; it waits.
[[nodiscard]] core::Expected<std::vector<cv::Mat1b>> firstGelFrames(const vision::MarkerGelFile& file,
                                                                    const std::string& source);

} // namespace teleta::cli
