// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qt>

class QMouseEvent;
class QWheelEvent;
class vtkRenderWindowInteractor;

namespace teleta::view3d {

/// Passes Qt's mouse events on to a VTK interactor, in device pixels with y up. Keys are not passed on: the
/// view handles them itself. Thread: GUI.
class VtkInput {
public:
    explicit VtkInput(vtkRenderWindowInteractor* interactor)
        : m_interactor(interactor) {}

    /// pixelRatio: device pixels per logical pixel of the widget.
    void mouse(const QMouseEvent& event, double pixelRatio);
    void wheel(const QWheelEvent& event, double pixelRatio);

private:
    void place(double x, double y, Qt::KeyboardModifiers modifiers, double pixelRatio, int repeat);

    vtkRenderWindowInteractor* m_interactor;
    int m_wheelRest = 0; ///< eighths of a degree left over from the last step
};

} // namespace teleta::view3d
