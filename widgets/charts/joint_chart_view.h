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

/// Torques and optionally angles of the arm's joints over time. A band marks the torque window in which a
/// touch is evaluated; each touch is shaded from its first torque to its estimate. Thread: GUI.
class JointChartView : public TimeChartView {
    Q_OBJECT
public:
    static constexpr double kShortestSpan_s = 0.05; ///< enlarges even a quick touch

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

    /// Sets the number of joints; forgets the samples of another arm.
    void setJoints(std::size_t joints);
    /// As JointPlot::setNames().
    void setJointNames(const QStringList& names);
    /// Stores samples; refresh() draws them. What a sample does not tell is a gap.
    void append(std::span<const core::JointSample> samples);
    /// The same for the history of another arm, which is not shown.
    static void append(SampleHistory& history, std::size_t joints,
                       std::span<const core::JointSample> samples);
    /// Shades a touch. Returns false if its start is no longer stored.
    bool addTouch(const pipeline::TouchRecord& touch);
    /// Clears samples and touches, and goes live.
    void clear();
    /// Moves out the content, to restore it later with setContent(), and goes live.
    [[nodiscard]] Content takeContent();
    /// Restores what takeContent() returned.
    void setContent(Content content);

    /// Angles beside the torques; the user's choice from then on.
    void setAnglesShown(bool shown) { m_angles->setChecked(shown); }
    /// Empty: touches are not evaluated.
    void setWindow(const std::optional<stiffness::TorqueWindow>& window);
    /// Pauses with a touch in the middle of the chart. Returns false if it is no longer stored.
    bool showTouch(std::uint64_t number);

    [[nodiscard]] const SampleHistory& history() const override { return m_history; }
    [[nodiscard]] JointPlot* plot() const { return m_joints; }

protected:
    void retranslate() override;
    void prepareExtras() override;
    void addOwnActions(QMenu& menu, const QPoint& position) override;
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
