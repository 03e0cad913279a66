// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "widgets/charts/time_plot.h"

#include <optional>
#include <vector>

namespace teleta::charts {

/// Columns of a history of joint samples: the torques, then the angles.
inline constexpr std::size_t kJointColumns = 2 * core::kArmJoints;

/// The joint chart: torques in mNm and optionally angles in degrees of the four joints, one lane each.
/// Thread: GUI.
class JointPlot : public TimePlot {
    Q_OBJECT
public:
    enum class Row { torque, angle }; ///< the lanes

    explicit JointPlot(QWidget* parent = nullptr);

    void setAnglesShown(bool shown);
    /// Absolute torques of the window in which a touch is evaluated; marked on both sides of zero.
    void setWindow(double low_Nm, double high_Nm);
    void setTouches(std::vector<Shade> touches) { m_touches->setShades(std::move(touches)); }
    [[nodiscard]] const std::vector<Shade>& touches() const { return m_touches->shades(); }

    [[nodiscard]] QString laneTitle(int lane) const override;

    [[nodiscard]] static QString jointName(std::size_t joint);

protected:
    [[nodiscard]] QString laneUnit(int lane) const override;
    [[nodiscard]] QString curveName(int lane, std::size_t curve) const override;
    [[nodiscard]] ValueRange automaticRange(Lane& lane, std::optional<ValueRange> extent,
                                            const SampleHistory& history, double end_s) override;
    void placeExtras(const std::vector<QCPAxisRect*>& rects) override;
    void colourExtras(const QPalette& palette) override;

private:
    void addRow(Row row, double scale, double minimumSpan);

    Shades* m_window;
    Shades* m_touches;
};

} // namespace teleta::charts
