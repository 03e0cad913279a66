// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "widgets/charts/time_plot.h"

#include <QStringList>

#include <optional>
#include <utility>
#include <vector>

namespace teleta::charts {

/// The joint chart: torques in mNm and optionally angles in degrees of an arm's joints, one lane each. A
/// history has the torques first, then the angles. Thread: GUI.
class JointPlot : public TimePlot {
    Q_OBJECT
public:
    enum class Row { torque, angle }; ///< the lanes

    /// Without an arm: four joints.
    explicit JointPlot(QWidget* parent = nullptr);

    /// Of the arm; the curves start again.
    void setJoints(std::size_t joints);
    /// As a description of the arm calls them; empty: they have the usual names.
    void setNames(QStringList names) { m_names = std::move(names); }
    [[nodiscard]] std::size_t joints() const { return m_count; }
    [[nodiscard]] std::size_t columns() const { return 2 * m_count; }

    void setAnglesShown(bool shown);
    /// Absolute torques of the window in which a touch is evaluated; marked on both sides of zero. Torques
    /// are in mNm then, else in Nm.
    void setWindow(double low_Nm, double high_Nm);
    /// Touches are not evaluated.
    void clearWindow();
    void setTouches(std::vector<Shade> touches) { m_touches->setShades(std::move(touches)); }
    [[nodiscard]] const std::vector<Shade>& touches() const { return m_touches->shades(); }

    [[nodiscard]] QString laneTitle(int lane) const override;

    [[nodiscard]] QString jointName(std::size_t joint) const;

protected:
    [[nodiscard]] QString laneUnit(int lane) const override;
    [[nodiscard]] QString curveName(int lane, std::size_t curve) const override;
    [[nodiscard]] ValueRange automaticRange(Lane& lane, std::optional<ValueRange> extent,
                                            const SampleHistory& history, double end_s) override;
    void placeExtras(const std::vector<QCPAxisRect*>& rects) override;
    void colourExtras(const QPalette& palette) override;

private:
    void addRow(Row row, double scale, double minimumSpan);
    void setTorqueUnit(double perNm);

    std::size_t m_count = 0; ///< of joints
    QStringList m_names;
    double m_perNm = 1e3; ///< of the torques as drawn
    bool m_anglesShown = false;
    Shades* m_window;
    Shades* m_touches;
};

} // namespace teleta::charts
