// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/camera/camera_image.h"

#include <QCoreApplication>
#include <QString>

#include <opencv2/imgcodecs.hpp>

namespace teleta::scene_run {

namespace {

struct CameraImageText {
    Q_DECLARE_TR_FUNCTIONS(SceneRun)
};

} // namespace

core::Expected<void> writeImage(const std::string& path, const cv::Mat1b& image) {
    bool written = false;
    try {
        written = cv::imwrite(path, image);
    } catch (const cv::Exception&) {
        written = false;
    }
    if (written)
        return {};
    return core::Unexpected(core::Error{core::ErrorKind::ioFailed,
                                        CameraImageText::tr("the image cannot be written").toStdString(),
                                        {},
                                        {path, 0, 0}});
}

} // namespace teleta::scene_run
