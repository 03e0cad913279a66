// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/vtk/gl_setup.h"

#include <QImage>
#include <QWidget>

#include <cstdint>
#include <functional>
#include <memory>

class vtkRenderWindow;
class vtkRenderWindowInteractor;

namespace teleta::view3d {

/// Shows a VTK render window inside Qt 6 widgets. Add renderers to renderWindow() and call requestRender()
/// when the scene changed; nothing is drawn otherwise. Where OpenGL is missing a text says so and
/// everything else keeps working.
/// Thread: GUI.
class VtkWidget : public QWidget {
    Q_OBJECT
public:
    /// Draws over the finished 3-D picture, in logical pixels of a surface of `size`.
    using Overlay = std::function<void(QPainter& painter, const QSizeF& size)>;

    explicit VtkWidget(QWidget* parent = nullptr);
    ~VtkWidget() override;

    /// Never null, whether or not it can be drawn.
    [[nodiscard]] vtkRenderWindow* renderWindow() const;
    [[nodiscard]] vtkRenderWindowInteractor* interactor() const;

    /// False when the display has no OpenGL that VTK can use; then fallbackText() is shown.
    [[nodiscard]] bool canRender() const;
    [[nodiscard]] QString fallbackText() const;

    /// Draws the scene soon: slow views of one program take turns (RenderTurns). Many calls make one frame.
    void requestRender();
    void setOverlay(Overlay overlay);
    enum class PictureOverlay { with, without };
    /// The scene at `scale` (> 0) times the device pixels shown, limited by what the driver can do. Null when
    /// nothing can be drawn.
    [[nodiscard]] QImage picture(double scale = 1.0, PictureOverlay overlay = PictureOverlay::with);
    /// Frames that VTK drew on the screen so far.
    [[nodiscard]] std::uint64_t framesRendered() const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /// Sizes given in pixels (line widths, point sizes) must be multiplied with this.
    void pixelScaleChanged(double devicePerLogical);
    /// Right click without a drag, or the menu key.
    void menuRequested(const QPoint& globalPosition);
    void renderingLost();

protected:
    void changeEvent(QEvent* event) override;

private:
    void showFallback(GlProblem problem);
    void writeFallback();

    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

} // namespace teleta::view3d
