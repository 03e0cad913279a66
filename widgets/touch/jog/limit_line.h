// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDeadlineTimer>
#include <QLabel>

#include <array>
#include <cstdint>

namespace teleta::touch {

/// Which limits act on a motion, in a line that is hidden while none does. A limit stays for kHold_ms after
/// it acted last: one that acts in every other step does not flicker. Thread: GUI.
class LimitLine : public QLabel {
    Q_OBJECT
public:
    static constexpr int kHold_ms = 700;

    explicit LimitLine(QWidget* parent = nullptr);

    /// The limits that act now, arm_model::MotionFlag. Call it again and again: what acts no more leaves
    /// then.
    void setActive(std::uint32_t flags);
    /// The tip is slower than asked because the arm is near a singularity.
    void setSingular(bool singular);
    /// Of another arm.
    void forget();
    void retranslate();

private:
    void show(std::uint32_t flags);
    void refresh();

    std::array<QDeadlineTimer, 32> m_until{}; ///< of each flag
    std::uint32_t m_shown = 0;
};

} // namespace teleta::touch
