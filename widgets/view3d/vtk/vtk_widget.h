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
/// whenever the scene has changed: nothing is drawn otherwise. Without OpenGL it shows a text that says so.
/// Thread: GUI.
class VtkWidget : public QWidget {
    Q_OBJECT
public:
    /// Draws over the finished 3-D picture, in logical pixels of a surface of `size`.
    using Overlay = std::function<void(QPainter& painter, const QSizeF& size)>;

    explicit VtkWidget(QWidget* parent = nullptr);
    ~VtkWidget() override;

    /// Never null, even without OpenGL.
    [[nodiscard]] vtkRenderWindow* renderWindow() const;
    [[nodiscard]] vtkRenderWindowInteractor* interactor() const;

    /// False if VTK cannot use the display's OpenGL; then fallbackText() is shown. The first painting finds
    /// out, but for a platform that has none.
    [[nodiscard]] bool canRender() const;
    [[nodiscard]] QString fallbackText() const;

    /// Draws the scene soon; views take turns (RenderTurns), and several calls make one frame.
    void requestRender();
    /// The scene has changed by too little to be worth a frame: the next one shows it, and so does a picture
    /// that is saved.
    void noteChange();
    void setOverlay(Overlay overlay);
    enum class PictureOverlay { with, without };
    /// The scene at `scale` (> 0) times the device pixels shown, limited by the driver. Null if nothing can
    /// be drawn.
    [[nodiscard]] QImage picture(double scale = 1.0, PictureOverlay overlay = PictureOverlay::with);
    /// Number of frames drawn on the screen so far.
    [[nodiscard]] std::uint64_t framesRendered() const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /// Factor for sizes in pixels (line widths, point sizes).
    void pixelScaleChanged(double devicePerLogical);
    /// Right click without a drag, or the menu key.
    void menuRequested(const QPoint& globalPosition);
    /// Left click without a drag.
    void clicked(const QPoint& position);

protected:
    void changeEvent(QEvent* event) override;

private:
    void showFallback(GlProblem problem);
    void writeFallback();

    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

} // namespace teleta::view3d
