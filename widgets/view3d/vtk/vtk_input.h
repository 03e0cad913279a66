// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qt>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;
class vtkRenderWindowInteractor;

namespace teleta::view3d {

/// Hands Qt's input events to a VTK interactor, in device pixels with y up.
/// Thread: GUI.
class VtkInput {
public:
    explicit VtkInput(vtkRenderWindowInteractor* interactor)
        : m_interactor(interactor) {}

    /// pixelRatio: device pixels per logical pixel of the widget.
    void mouse(const QMouseEvent& event, double pixelRatio);
    void wheel(const QWheelEvent& event, double pixelRatio);
    void key(const QKeyEvent& event);

private:
    void place(double x, double y, Qt::KeyboardModifiers modifiers, double pixelRatio, int repeat);

    vtkRenderWindowInteractor* m_interactor;
    int m_wheelRest = 0; ///< eighths of a degree that do not yet make a step
};

/// VTK's name (as in Tk) of a Qt key, for example "Left" or "a"; nullptr when VTK has none.
[[nodiscard]] const char* vtkKeyName(int qtKey);

} // namespace teleta::view3d
