// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/figure/picture_view.h"
#include "widgets/camera/camera_picture.h"

#include <optional>

namespace teleta::camera {

/// The image of the camera in the soft tube. Ctrl+wheel, + and - zoom, dragging moves, a double click or Home
/// shows all; Space freezes the picture; hovering names a contact. Thread: GUI.
class CameraView : public base::PictureView<CameraPicture> {
    Q_OBJECT
public:
    /// How long a bump is marked, in the camera's time.
    static constexpr double kBumpShown_s = 1.0;

    explicit CameraView(QWidget* parent = nullptr);

    /// Shows the newest snapshot unless the picture is frozen; null clears.
    void setSnapshot(const pipeline::CameraSnapshot* snapshot);
    void setArrowsShown(bool shown);
    void setPaused(bool paused);

    [[nodiscard]] base::Figure figure() override;

signals:
    void pauseRequested(bool paused);

protected:
    [[nodiscard]] QString toolTipAt(const QPointF& point) const override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void addOwnActions(QMenu& menu, const QPoint& position) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void showAll();
    void retranslate();

    std::optional<double> m_bump_s;
    QPointF m_dragged;
};

} // namespace teleta::camera
