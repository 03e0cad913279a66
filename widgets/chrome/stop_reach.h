// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

class QWidget;

namespace teleta::chrome {

class StopButton;

/// Keeps STOP in reach of the mouse while something else takes the mouse of its window. Over a modal dialog's
/// blocked window a second button lies in the same place, which belongs to the dialog and so is not blocked;
/// the keys go back to the dialog when somebody clicks elsewhere in the window. A press on STOP that closes a
/// menu or a list stops as well. Thread: GUI.
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
    QPointer<QWidget> m_dialog;
    QPointer<StopButton> m_substitute;
};

} // namespace teleta::chrome
