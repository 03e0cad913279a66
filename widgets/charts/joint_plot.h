// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "widgets/charts/time_plot.h"

#include <optional>
#include <vector>

namespace teleta::charts {

/// Columns of a history of joint samples: the torques, then the angles.
inline constexpr std::size_t kJointColumns = 2 * core::kArmJoints;

/// The picture of the joint chart: torques in mNm and, if wanted, angles in degrees of the four joints.
/// Thread: GUI.
class JointPlot : public TimePlot {
    Q_OBJECT
public:
    enum class Row { torque, angle };

    explicit JointPlot(QWidget* parent = nullptr);

    void setAnglesShown(bool shown);
    /// Size of the torques between which a touch is evaluated; marked on both sides of zero.
    void setWindow(double low_Nm, double high_Nm);
    void setTouches(std::vector<Shade> touches) { m_touches->setShades(std::move(touches)); }
    [[nodiscard]] const std::vector<Shade>& touches() const { return m_touches->shades(); }

    /// Ends of a row's axis in displayed units; empty: automatic.
    void setFixedRange(Row row, std::optional<ValueRange> range);
    [[nodiscard]] std::optional<ValueRange> fixedRange(Row row) const;
    /// The ends in use; low = high = 0 for a row that is not shown.
    [[nodiscard]] ValueRange rangeOf(Row row) const;

    /// Where the curves of a row are drawn; empty when it is not shown.
    [[nodiscard]] QRect plotRect(Row row) const;
    /// Height in the picture of a torque.
    [[nodiscard]] double yOfTorque(double torque_Nm) const;
    [[nodiscard]] const ValuePanel* panelOf(Row row) const;
    [[nodiscard]] QCPGraph* graphOf(Row row, std::size_t joint) const;
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
