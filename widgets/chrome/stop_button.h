// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QElapsedTimer>
#include <QTimer>

namespace teleta::chrome {

/// STOP. Pressing it stops at once, on the way down. While stopped, it must be held (or Space) for a second
/// to release, so that a stray click moves nothing. Thread: GUI.
class StopButton : public QAbstractButton {
    Q_OBJECT

public:
    /// Time to hold it for release.
    static constexpr int kHold_ms = 1000;
    static constexpr int kMinimumSide_px = 44;

    explicit StopButton(QWidget* parent = nullptr);

    /// Shows the state of the StopSwitch.
    void setEngaged(bool engaged);
    [[nodiscard]] bool engaged() const { return m_engaged; }

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void stopRequested();
    void releaseRequested();
    void engagedChanged(bool engaged);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void onPressed();
    void onReleased();
    void onHoldTick();
    void describe();

    bool m_engaged = false;
    QElapsedTimer m_held;
    QTimer m_holdTimer;
};

} // namespace teleta::chrome
