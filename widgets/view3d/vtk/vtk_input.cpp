// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/vtk/vtk_input.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <vtkCommand.h>
#include <vtkRenderWindowInteractor.h>

#include <array>
#include <cmath>
#include <utility>

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

const char* vtkKeyName(int qtKey) {
    static constexpr std::array<const char*, 36> kAlphanumeric = {
        "0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "a", "b", "c", "d", "e", "f", "g", "h",
        "i", "j", "k", "l", "m", "n", "o", "p", "q", "r", "s", "t", "u", "v", "w", "x", "y", "z"};
    static constexpr std::array<const char*, 12> kFunction = {"F1", "F2", "F3", "F4",  "F5",  "F6",
                                                              "F7", "F8", "F9", "F10", "F11", "F12"};
    static constexpr std::array<std::pair<int, const char*>, 24> kNamed = {{
        {Qt::Key_Backspace, "BackSpace"}, {Qt::Key_Tab, "Tab"},       {Qt::Key_Return, "Return"},
        {Qt::Key_Enter, "Return"},        {Qt::Key_Escape, "Escape"}, {Qt::Key_Space, "space"},
        {Qt::Key_PageUp, "Prior"},        {Qt::Key_PageDown, "Next"}, {Qt::Key_End, "End"},
        {Qt::Key_Home, "Home"},           {Qt::Key_Left, "Left"},     {Qt::Key_Up, "Up"},
        {Qt::Key_Right, "Right"},         {Qt::Key_Down, "Down"},     {Qt::Key_Insert, "Insert"},
        {Qt::Key_Delete, "Delete"},       {Qt::Key_Shift, "Shift_L"}, {Qt::Key_Control, "Control_L"},
        {Qt::Key_Alt, "Alt_L"},           {Qt::Key_Plus, "plus"},     {Qt::Key_Minus, "minus"},
        {Qt::Key_Comma, "comma"},         {Qt::Key_Period, "period"}, {Qt::Key_Slash, "slash"},
    }};
    if (qtKey >= Qt::Key_0 && qtKey <= Qt::Key_9) {
        return kAlphanumeric[static_cast<std::size_t>(qtKey - Qt::Key_0)];
    }
    if (qtKey >= Qt::Key_A && qtKey <= Qt::Key_Z) {
        return kAlphanumeric[static_cast<std::size_t>(10 + qtKey - Qt::Key_A)];
    }
    if (qtKey >= Qt::Key_F1 && qtKey <= Qt::Key_F12) {
        return kFunction[static_cast<std::size_t>(qtKey - Qt::Key_F1)];
    }
    for (const auto& [key, name] : kNamed) {
        if (key == qtKey) {
            return name;
        }
    }
    return nullptr;
}

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
        // The second press of a double click is a press as well: drags that start with it must work.
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
    for (; m_wheelRest >= QWheelEvent::DefaultDeltasPerStep;
         m_wheelRest -= QWheelEvent::DefaultDeltasPerStep) {
        m_interactor->InvokeEvent(vtkCommand::MouseWheelForwardEvent);
    }
    for (; m_wheelRest <= -QWheelEvent::DefaultDeltasPerStep;
         m_wheelRest += QWheelEvent::DefaultDeltasPerStep) {
        m_interactor->InvokeEvent(vtkCommand::MouseWheelBackwardEvent);
    }
}

void VtkInput::key(const QKeyEvent& event) {
    const QString text = event.text();
    const char* name = vtkKeyName(event.key());
    const char code = text.isEmpty() ? '\0' : text.at(0).toLatin1();
    m_interactor->SetKeyEventInformation(event.modifiers().testFlag(Qt::ControlModifier) ? 1 : 0,
                                         event.modifiers().testFlag(Qt::ShiftModifier) ? 1 : 0, code,
                                         event.count(), name != nullptr ? name : "None");
    m_interactor->SetAltKey(event.modifiers().testFlag(Qt::AltModifier) ? 1 : 0);
    if (event.type() == QEvent::KeyRelease) {
        m_interactor->InvokeEvent(vtkCommand::KeyReleaseEvent);
        return;
    }
    m_interactor->InvokeEvent(vtkCommand::KeyPressEvent);
    if (code != '\0') {
        m_interactor->InvokeEvent(vtkCommand::CharEvent);
    }
}

} // namespace teleta::view3d
