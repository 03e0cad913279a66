// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/pipeline/touch/touch_record.h"
#include "backend/stiffness/joint_sample.h"
#include "widgets/charts/joint_plot.h"
#include "widgets/charts/time_chart_view.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace teleta::charts {

/// Torques and, if wanted, angles of the arm's joints over time. The torques between which a touch is
/// evaluated are marked as a band, each touch is shaded from its first torque to its estimate. Thread: GUI.
class JointChartView : public TimeChartView {
    Q_OBJECT
public:
    static constexpr double kShortestSpan_s = 0.05; ///< a quick touch fills the picture

    struct Touch {
        std::uint64_t number = 0;
        double from_s = 0.0, to_s = 0.0; ///< chart times
    };
    /// Samples and touches of an arm.
    struct Content {
        SampleHistory history;
        std::vector<Touch> touches;
    };

    explicit JointChartView(QWidget* parent = nullptr);

    /// Keeps samples; nothing is drawn before refresh().
    void append(std::span<const core::JointSample> samples);
    /// Shades a touch. False when its start is no longer kept.
    bool addTouch(const pipeline::TouchRecord& touch);
    /// Forgets samples and touches, and goes live.
    void clear();
    /// Gives away what is shown, to be shown again another time, and goes live.
    [[nodiscard]] Content takeContent();
    /// Goes on with what takeContent() gave.
    void setContent(Content content);

    void setWindow(const stiffness::TorqueWindow& window);
    [[nodiscard]] QAction* anglesAction() const { return m_angles; }
    /// Pauses so that a touch lies in the middle. False when it is no longer kept.
    bool showTouch(std::uint64_t number);

    void populateMenu(QMenu& menu, std::optional<JointPlot::Row> row = std::nullopt);
    [[nodiscard]] const SampleHistory& history() const override { return m_history; }
    [[nodiscard]] JointPlot* plot() const { return m_joints; }

signals:
    void anglesChanged(bool shown);

protected:
    void retranslate() override;
    void prepareExtras() override;
    void fillMenu(QMenu& menu, std::optional<int> lane) override;
    [[nodiscard]] QString cursorText(const QString& time, const QString& sourceTime) const override;
    [[nodiscard]] QString figureName() const override { return tr("joints"); }
    [[nodiscard]] QString csv(std::size_t first, std::size_t last) const override;

private:
    JointChartView(JointPlot* plot, QWidget* parent);

    SampleHistory m_history;
    std::vector<Touch> m_touches;
    JointPlot* m_joints;
    QAction* m_angles;
};

} // namespace teleta::charts
