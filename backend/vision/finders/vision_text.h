// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/failure.h"
#include "backend/vision/camera/cylinder_projection.h"

#include <QCoreApplication>
#include <QString>

#include <opencv2/core.hpp>

#include <new>

namespace teleta::vision {

/// Translation context of the texts that the contact finders share.
struct VisionText {
    Q_DECLARE_TR_FUNCTIONS(VisionText)
};

using core::refused;

[[nodiscard]] inline core::Unexpected noReference() {
    return refused(VisionText::tr("There is no frame of the untouched skin to compare with."));
}

[[nodiscard]] inline core::Unexpected cancelledMaking() {
    return core::failed(core::ErrorKind::cancelled,
                        VisionText::tr("The camera was closed before it was ready."));
}

/// Calls work and returns its result; exceptions of OpenCV and of memory allocation become an error: refused.
template <typename Work>
[[nodiscard]] auto withoutExceptions(Work work) -> decltype(work()) {
    try {
        return work();
    } catch (const cv::Exception& error) {
        return refused(
            VisionText::tr("The image cannot be processed: %1").arg(QString::fromStdString(error.err)));
    } catch (const std::bad_alloc&) {
        return refused(VisionText::tr("There is not enough memory for images of this size."));
    }
}

/// Error: refused when a frame does not have the size of the camera's image.
[[nodiscard]] inline core::Expected<void> checkSize(int width_px, int height_px,
                                                    const CylinderCamera& camera) {
    const CameraParameters& own = camera.camera().parameters();
    if (width_px == own.width_px && height_px == own.height_px)
        return {};
    return refused(VisionText::tr("The frame has %1 x %2 pixels.").arg(width_px).arg(height_px),
                   VisionText::tr("%1 x %2 pixels, as in the camera's calibration")
                       .arg(own.width_px)
                       .arg(own.height_px));
}

} // namespace teleta::vision
