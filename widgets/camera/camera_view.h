// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/figure_export.h"
#include "widgets/camera/camera_picture.h"

#include <QWidget>

#include <optional>

namespace teleta::camera {

/// What the camera in the soft tube sees. Ctrl+wheel, + and - zoom, dragging moves, a double click or Home
/// shows all; Space pauses the picture, Ctrl+C copies it; hovering names a contact. Thread: GUI.
class CameraView : public QWidget {
    Q_OBJECT
public:
    /// How long a bump is pointed at, in the camera's time.
    static constexpr double kBumpShown_s = 1.0;

    explicit CameraView(QWidget* parent = nullptr);

    /// Shows the newest snapshot, unless the picture is paused; null clears.
    void setSnapshot(const pipeline::CameraSnapshot* snapshot);
    void setProvenance(base::Provenance provenance);
    void setArrowsShown(bool shown);
    void setPaused(bool paused);

    [[nodiscard]] const CameraPicture& picture() const { return m_picture; }
    [[nodiscard]] base::Figure figure() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void pauseRequested(bool paused);
    void exported(const QString& path);
    void exportFailed(const QString& message);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void showAll();
    void retranslate();

    CameraPicture m_picture;
    std::optional<double> m_bump_s;
    QPointF m_dragged;
    base::FigureExport* m_export;
};

} // namespace teleta::camera
