// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/vision/cylinder_projection.h"

#include <QCoreApplication>
#include <QString>

namespace teleta::vision {

/// Texts and errors that the contact finders share.
struct VisionText {
    Q_DECLARE_TR_FUNCTIONS(VisionText)
};

[[nodiscard]] inline core::Unexpected refused(const QString& message, const QString& expected = {}) {
    return core::Unexpected(
        core::Error{core::ErrorKind::refused, message.toStdString(), expected.toStdString(), {}});
}

[[nodiscard]] inline core::Error noReference() {
    return {core::ErrorKind::refused,
            VisionText::tr("There is no frame of the untouched skin to compare with.").toStdString(),
            {},
            {}};
}

/// Error: refused when a frame is not as large as the camera's image.
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
