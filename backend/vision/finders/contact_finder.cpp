// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/finders/contact_finder.h"

#include "backend/vision/finders/vision_text.h"

namespace teleta::vision {

core::Expected<void> ContactFinder::setReference(const cv::Mat1b& frame) {
    return withoutExceptions([&] { return takeReference(frame); });
}

core::Expected<std::vector<CameraContact>> ContactFinder::find(const cv::Mat1b& frame) {
    return withoutExceptions([&] { return findIn(frame); });
}

} // namespace teleta::vision
