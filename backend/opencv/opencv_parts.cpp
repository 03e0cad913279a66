// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/opencv/opencv_parts.h"

#include "backend/core/part.h"
#include "backend/opencv/exported_parts.h"

namespace teleta::opencv {

core::Expected<const Pictures*> pictures() {
    static const auto loaded = core::part<Pictures>("teleta_opencv_pictures");
    return loaded;
}

core::Expected<std::unique_ptr<cv::VideoCapture>> videoCapture() {
    static const auto loaded = core::part<Video>("teleta_opencv_video");
    TELETA_TRY(const Video* video, loaded);
    return video->capture();
}

core::Expected<cv::Ptr<cv::DISOpticalFlow>> denseFlow(int preset) {
    static const auto loaded = core::part<Flow>("teleta_opencv_flow");
    TELETA_TRY(const Flow* flow, loaded);
    return flow->dense(preset);
}

} // namespace teleta::opencv
