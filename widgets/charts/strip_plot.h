// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/charts/feature_history.h"
#include "widgets/charts/strips.h"
#include "widgets/charts/time_plot.h"

#include <optional>
#include <vector>

namespace teleta::charts {

/// The strip chart: each strip is a lane with columns of a FeatureHistory. Thread: GUI.
class StripPlot : public TimePlot {
    Q_OBJECT
public:
    explicit StripPlot(QWidget* parent = nullptr);

    /// The strips from top to bottom.
    void setStrips(const std::vector<Strip>& strips);
    void setLoadUnit(const QString& unit) { m_loadUnit = unit; }
    [[nodiscard]] const QString& loadUnit() const { return m_loadUnit; }
    void setMarks(std::vector<TimeLine> marks) { m_marks->setLines(std::move(marks)); }
    [[nodiscard]] QString laneTitle(int lane) const override;

protected:
    [[nodiscard]] QString laneUnit(int lane) const override;
    [[nodiscard]] QString curveName(int lane, std::size_t curve) const override;
    [[nodiscard]] ValueRange automaticRange(Lane& lane, std::optional<ValueRange> extent,
                                            const SampleHistory& history, double end_s) override;
    void placeExtras(const std::vector<QCPAxisRect*>& rects) override { m_marks->setRects(rects); }
    void colourExtras(const QPalette& palette) override;

private:
    QString m_loadUnit;
    TimeLines* m_marks;
};

} // namespace teleta::charts
