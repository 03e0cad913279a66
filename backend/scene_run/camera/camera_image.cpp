// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/camera/camera_image.h"

#include "backend/core/failure.h"
#include "backend/opencv/opencv_parts.h"

#include <QCoreApplication>

namespace teleta::scene_run {

namespace {

struct CameraImageText {
    Q_DECLARE_TR_FUNCTIONS(SceneRun)
};

} // namespace

core::Expected<void> writeReference(const std::string& outFolder, const cv::Mat1b& image) {
    if (outFolder.empty())
        return {};
    const std::string path = outFolder + "/reference.png";
    TELETA_TRY(const opencv::Pictures* pictures, opencv::pictures());
    try {
        if (pictures->write(path, image))
            return {};
    } catch (const cv::Exception&) {
        // Reported like an image that is not written.
    }
    return core::failed(core::ErrorKind::ioFailed, CameraImageText::tr("the image cannot be written"), {},
                        {path});
}

} // namespace teleta::scene_run
