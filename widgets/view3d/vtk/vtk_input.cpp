// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/vtk/vtk_input.h"

#include <QMouseEvent>
#include <QWheelEvent>

#include <vtkCommand.h>
#include <vtkRenderWindowInteractor.h>

#include <cmath>

namespace teleta::view3d {

namespace {

unsigned long pressEvent(Qt::MouseButton button, bool twice) {
    switch (button) {
    case Qt::LeftButton:
        return twice ? vtkCommand::LeftButtonDoubleClickEvent : vtkCommand::LeftButtonPressEvent;
    case Qt::MiddleButton:
        return twice ? vtkCommand::MiddleButtonDoubleClickEvent : vtkCommand::MiddleButtonPressEvent;
    case Qt::RightButton:
        return twice ? vtkCommand::RightButtonDoubleClickEvent : vtkCommand::RightButtonPressEvent;
    default:
        return vtkCommand::NoEvent;
    }
}

unsigned long releaseEvent(Qt::MouseButton button) {
    switch (button) {
    case Qt::LeftButton:
        return vtkCommand::LeftButtonReleaseEvent;
    case Qt::MiddleButton:
        return vtkCommand::MiddleButtonReleaseEvent;
    case Qt::RightButton:
        return vtkCommand::RightButtonReleaseEvent;
    default:
        return vtkCommand::NoEvent;
    }
}

} // namespace

void VtkInput::place(double x, double y, Qt::KeyboardModifiers modifiers, double pixelRatio, int repeat) {
    m_interactor->SetEventInformationFlipY(static_cast<int>(std::floor(x * pixelRatio)),
                                           static_cast<int>(std::floor(y * pixelRatio)),
                                           modifiers.testFlag(Qt::ControlModifier) ? 1 : 0,
                                           modifiers.testFlag(Qt::ShiftModifier) ? 1 : 0, 0, repeat);
    m_interactor->SetAltKey(modifiers.testFlag(Qt::AltModifier) ? 1 : 0);
}

void VtkInput::mouse(const QMouseEvent& event, double pixelRatio) {
    const bool twice = event.type() == QEvent::MouseButtonDblClick;
    place(event.position().x(), event.position().y(), event.modifiers(), pixelRatio, twice ? 1 : 0);
    switch (event.type()) {
    case QEvent::MouseMove:
        m_interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
        break;
    case QEvent::MouseButtonPress:
        m_interactor->InvokeEvent(pressEvent(event.button(), false));
        break;
    case QEvent::MouseButtonDblClick:
        // The second press of a double click counts as a press: drags can start with it.
        m_interactor->InvokeEvent(pressEvent(event.button(), false));
        m_interactor->InvokeEvent(pressEvent(event.button(), true));
        break;
    case QEvent::MouseButtonRelease:
        m_interactor->InvokeEvent(releaseEvent(event.button()));
        break;
    default:
        break;
    }
}

void VtkInput::wheel(const QWheelEvent& event, double pixelRatio) {
    place(event.position().x(), event.position().y(), event.modifiers(), pixelRatio, 0);
    // Touchpads send fractions of a step; Alt turns the wheel sideways in some desktops.
    const QPoint turned = event.angleDelta();
    m_wheelRest += turned.y() != 0 ? turned.y() : turned.x();
    for (; m_wheelRest >= QWheelEvent::DefaultDeltasPerStep; m_wheelRest -= QWheelEvent::DefaultDeltasPerStep)
        m_interactor->InvokeEvent(vtkCommand::MouseWheelForwardEvent);
    for (; m_wheelRest <= -QWheelEvent::DefaultDeltasPerStep;
         m_wheelRest += QWheelEvent::DefaultDeltasPerStep)
        m_interactor->InvokeEvent(vtkCommand::MouseWheelBackwardEvent);
}

} // namespace teleta::view3d
