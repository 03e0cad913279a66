// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/camera/gel_frames.h"

#include "app/cli/base/interruption.h"
#include "backend/core/failure.h"
#include "backend/vision/gel/marker_gel.h"
#include "devices/camera/video_stream.h"

namespace teleta::cli {

core::Expected<std::vector<cv::Mat1b>> firstGelFrames(const vision::MarkerGelFile& file,
                                                      const std::string& source) {
    using Outcome = camera::VideoStream::Outcome;
    TELETA_TRY(auto stream, camera::VideoStream::open(
                                source, {.width_px = file.width_px,
                                         .height_px = file.height_px,
                                         .rate_Hz = file.rate_Hz,
                                         .channel = static_cast<camera::VideoChannel>(file.channel)}));
    std::vector<cv::Mat1b> frames;
    while (frames.size() < vision::MarkerGel::kReferencePictures && !interrupted()) {
        cv::Mat1b frame;
        double time_s = 0.0;
        const Outcome outcome = stream.next(frame, time_s);
        if (outcome == Outcome::ended || outcome == Outcome::gone)
            break;
        if (outcome != Outcome::frame)
            continue;
        const auto picture = vision::MarkerGel::picture(file, frame);
        if (!picture) {
            core::Error error = picture.error();
            error.where.file = source;
            return core::Unexpected(error);
        }
        frames.push_back(picture->clone()); // the stream may use its memory again
    }
    if (interrupted())
        return core::Unexpected(interruption());
    return frames;
}

} // namespace teleta::cli
