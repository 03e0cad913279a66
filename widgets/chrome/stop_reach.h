// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

class QWidget;

namespace teleta::chrome {

class StopButton;

/// Keeps STOP in reach of the mouse where Qt would withhold it. A modal dialog blocks the window of the
/// button: while it is open, a second button, which belongs to the dialog, lies exactly over the first, and a
/// click anywhere else in the blocked window gives the keyboard back to the dialog. While a menu or a list is
/// open, a press on STOP closes it, and stops as well. Thread: GUI.
class StopReach : public QObject {
    Q_OBJECT

public:
    /// button outlives this.
    explicit StopReach(StopButton& button);
    ~StopReach() override;

    /// The button over a modal dialog; null without one.
    [[nodiscard]] StopButton* substitute() const { return m_substitute; }

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void follow();
    [[nodiscard]] bool covers(const QPoint& global) const;

    StopButton& m_button;
    QPointer<StopButton> m_substitute;
};

} // namespace teleta::chrome
