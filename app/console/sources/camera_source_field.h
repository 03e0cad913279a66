// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/camera/camera_list.h"

#include <QString>
#include <QWidget>

#include <functional>
#include <vector>

class QComboBox;

namespace teleta::console {

/// Which camera, or which video of one: the numbers of the connected cameras, a name that is typed in, and a
/// button that chooses a file. The cameras are there once their drivers have answered, on a pool thread.
/// Thread: GUI.
class CameraSourceField : public QWidget {
    Q_OBJECT

public:
    using Lister = std::function<std::vector<camera::CameraInfo>()>;

    /// last: what was taken the last time; empty: the first camera.
    explicit CameraSourceField(const QString& last, const Lister& list = camera::listCameras,
                               QWidget* parent = nullptr);

    /// A file or the number of a camera; empty: neither.
    [[nodiscard]] QString source() const;

signals:
    void changed();

private:
    void setCameras(const std::vector<camera::CameraInfo>& cameras);
    void chooseVideo();

    QComboBox* m_box;
};

} // namespace teleta::console
