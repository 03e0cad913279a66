// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <cstdint>
#include <vector>

namespace teleta::console {

/// Drives the whole window at 30 Hz and measures itself: how long a tick's work took, and how late the event
/// loop came to it. Views repaint what changed in a tick; between ticks nothing is drawn because of data.
/// Thread: GUI.
class GuiClock : public QObject {
    Q_OBJECT

public:
    static constexpr int kPeriod_ms = 33;

    struct Report {
        std::uint64_t ticks = 0;
        double work_p50_s = 0.0; ///< time spent in the tick's own slots
        double work_p99_s = 0.0;
        double work_max_s = 0.0;
        double stall_p99_s = 0.0; ///< time by which a tick came later than its period
        double stall_max_s = 0.0;
    };

    explicit GuiClock(QObject* parent = nullptr);

    void start();
    void stop();
    /// Statistics since the start or the last resetReport(), over at most the last hour.
    [[nodiscard]] Report report() const;
    void resetReport();

signals:
    void tick();

private:
    void onTimeout();

    QTimer m_timer;
    QElapsedTimer m_sinceTick;
    std::vector<float> m_work_s;
    std::vector<float> m_stall_s;
    std::uint64_t m_ticks = 0;
};

} // namespace teleta::console
