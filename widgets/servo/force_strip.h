// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/servo/servo_link.h"
#include "widgets/base/numbers/calm_range.h"

#include <QWidget>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

namespace teleta::servo {

/// Measured and desired force over the last 20 s; 0 s is the newest step. Thread: GUI.
class ForceStrip : public QWidget {
    Q_OBJECT
public:
    static constexpr double kSpan_s = 20.0;

    explicit ForceStrip(QWidget* parent = nullptr);

    /// Adds the newest step. A report of the same time adds nothing; one of another run, or an empty one,
    /// clears the strip.
    void setReport(const std::optional<ServoReport>& report);

    [[nodiscard]] std::size_t steps() const { return m_steps.size(); }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Step {
        double time_s;
        double actual_N;
        double desired_N;
    };

    void describe();

    std::deque<Step> m_steps;
    std::uint64_t m_restarts = 0;
    base::CalmRange m_range{2.0};
};

} // namespace teleta::servo
