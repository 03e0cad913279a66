// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view3d/vtk/gl_setup.h"
#include "widgets/view3d/vtk/guest_render_window.h"
#include "widgets/view3d/vtk/render_queue.h"

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QTimer>
#include <QWidget>

#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>

#include <cstdint>
#include <functional>
#include <optional>

class QSinglePointEvent;

namespace teleta::view3d {

/// The surface inside VtkWidget: shows what the render window draws in its own offscreen context. It is an
/// ordinary widget, because with a single OpenGL widget Qt would compose the whole window with OpenGL on
/// every repaint. The last frame stays on the screen until the driver has finished the next one; nothing
/// waits for it. The scene belongs to the render window.
class VtkCanvas : public QWidget, private RenderQueue::View {
    Q_OBJECT
public:
    /// painter: in logical pixels; size: of the widget.
    using Overlay = std::function<void(QPainter& painter, const QSizeF& size)>;

    VtkCanvas(GuestRenderWindow* window, vtkRenderWindowInteractor* interactor, QWidget* parent);
    ~VtkCanvas() override;

    /// Draws again when RenderQueue gives it a turn.
    void requestRender();
    /// The scene has changed by too little to be worth a frame on the screen. A picture that is saved shows
    /// it.
    void noteChange() { m_changed = true; }
    void setOverlay(Overlay overlay) { m_overlay = std::move(overlay); }
    /// Draws the scene again at `scale` times the widget's device pixels.
    [[nodiscard]] QImage picture(double scale, bool withOverlay);
    [[nodiscard]] std::uint64_t framesRendered() const { return m_framesRendered; }

signals:
    /// Nothing can ever be drawn.
    void contextRefused(GlProblem problem);
    void pixelScaleChanged(double devicePerLogical);
    void menuRequested(const QPoint& globalPosition);
    /// Left click without a drag.
    void clicked(const QPoint& position);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void turnHasCome() override;
    [[nodiscard]] bool makeContext();
    void beginFrame();
    /// Waits for the driver to finish the frame.
    void endFrame();
    void lookForFrame();
    /// Draws the scene at once with several samples a pixel.
    [[nodiscard]] QImage finePicture();
    [[nodiscard]] bool paintsOnScreen() const;
    void setDeviceSize(const QSize& size, double pixelScale);
    [[nodiscard]] QSize deviceSize() const;
    /// Tells VTK where the mouse is, in device pixels with y up, and the keys that are held.
    void placeMouse(const QSinglePointEvent& event, int repeat);
    void passOn(QMouseEvent* event);

    vtkSmartPointer<GuestRenderWindow> m_window;
    vtkRenderWindowInteractor* m_interactor;
    Overlay m_overlay;
    QOffscreenSurface m_surface;
    QOpenGLContext m_context;
    bool m_refused = false;
    QImage m_frame;
    int m_wheelRest = 0;                ///< eighths of a degree left over from the last step
    std::optional<QPointF> m_leftPress; ///< empty: none, or it was dragged
    QPointF m_rightPress;
    bool m_rightDragged = false;
    bool m_stale = true;    ///< the scene has changed since the last frame was started
    bool m_isFine = false;  ///< the last frame is a picture with several samples a pixel
    bool m_drawing = false; ///< a frame was started and is not finished
    std::int64_t m_begun_ns = 0;
    FrameQuality m_quality;
    QTimer m_lookAgain;
    QSize m_size;
    double m_pixelScale = 0.0;
    bool m_changed = false; ///< since the last frame was started, however little
    std::uint64_t m_framesRendered = 0;
};

} // namespace teleta::view3d
