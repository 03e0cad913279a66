// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>

namespace teleta::base {

/// A button that counts only while it is held: it lets go when the mouse is released or leaves it, and when
/// it is hidden or disabled. Coming back with the mouse still pressed does not hold it again. It takes no
/// keyboard focus; whoever owns it has keys for it. Thread: GUI.
class HoldButton : public QPushButton {
    Q_OBJECT
public:
    explicit HoldButton(QWidget* parent = nullptr);

    [[nodiscard]] bool isHeld() const { return m_held; }
    void letGo();

signals:
    /// modifiers: of the mouse event that began the hold; none at its end.
    void heldChanged(bool held, Qt::KeyboardModifiers modifiers);

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    bool m_held = false;
};

} // namespace teleta::base
