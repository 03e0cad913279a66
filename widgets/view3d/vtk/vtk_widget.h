// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/vtk/vtk_canvas.h"

#include <QImage>
#include <QWidget>

#include <vtkCallbackCommand.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkNew.h>

#include <cstdint>

class QLabel;

namespace teleta::view3d {

/// Shows a VTK render window inside Qt 6 widgets. Add renderers to renderWindow() and call requestRender()
/// whenever the scene has changed: nothing is drawn otherwise. Without OpenGL it shows a text that says so.
/// Thread: GUI.
class VtkWidget : public QWidget {
    Q_OBJECT
public:
    explicit VtkWidget(QWidget* parent = nullptr);
    ~VtkWidget() override;

    /// Never null, even without OpenGL.
    [[nodiscard]] vtkRenderWindow* renderWindow() const { return m_window; }
    [[nodiscard]] vtkRenderWindowInteractor* interactor() const { return m_interactor; }

    /// False if VTK cannot use the display's OpenGL; then fallbackText() is shown.
    [[nodiscard]] bool canRender() const { return m_canvas != nullptr; }
    [[nodiscard]] QString fallbackText() const;

    /// Draws the scene soon; views take turns (RenderTurns), and several calls make one frame.
    void requestRender();
    /// Draws over the finished 3-D picture.
    void setOverlay(VtkCanvas::Overlay overlay);
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

protected:
    void changeEvent(QEvent* event) override;

private:
    void showFallback(GlProblem problem);
    void writeFallback();

    vtkNew<GuestRenderWindow> m_window;
    vtkNew<vtkGenericRenderWindowInteractor> m_interactor;
    vtkNew<vtkCallbackCommand> m_onRender;
    VtkCanvas* m_canvas = nullptr;
    QLabel* m_fallback = nullptr;
    GlProblem m_problem = GlProblem::none;
};

} // namespace teleta::view3d
