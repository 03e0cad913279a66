// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/camera_snapshot.h"
#include "widgets/base/numbers/number_format.h"

#include <QStringList>
#include <QWidget>

#include <array>
#include <optional>

namespace teleta::camera {

/// The stages of a camera frame's processing time, as parts of a bar whose length is the time between two
/// frames, with the rates below. Times are averaged over about a second. Thread: GUI.
class StageBar : public QWidget {
    Q_OBJECT
public:
    explicit StageBar(QWidget* parent = nullptr);

    /// nominalRate_Hz: of the camera; 0: unknown. Null: no camera.
    void setSnapshot(const pipeline::CameraSnapshot* snapshot, double nominalRate_Hz);

    /// Averaged time of all stages, ms.
    [[nodiscard]] double whole_ms() const { return m_whole_ms; }
    /// All that is told; the tool tip has it too.
    [[nodiscard]] QString text() const;
    /// As much of it as there is room for, the time of a frame at least.
    [[nodiscard]] QString shownText() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {1, sizeHint().height()}; }

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] static QString nameOf(std::size_t stage);
    [[nodiscard]] QStringList parts() const;

    std::array<double, vision::kFinderStages> m_stage_ms{};
    double m_whole_ms = 0.0;
    double m_period_ms = 0.0;
    std::optional<std::string> m_rung; ///< to which the averages belong
    std::uint64_t m_passedOver = 0;
    std::uint64_t m_unusable = 0;
    base::SteadyNumber m_wholeShown{0.1};
    base::SteadyNumber m_rateShown{0.5};
};

} // namespace teleta::camera
