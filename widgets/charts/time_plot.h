// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/controls/badge.h"
#include "widgets/base/numbers/calm_range.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/charts/chart_elements.h"
#include "widgets/charts/polyline.h"
#include "widgets/charts/sample_history.h"

#include <QPicture>

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace teleta::charts {

/// A chart over time: lanes of one part of a history below each other, with one time axis in seconds before
/// its right end. It handles no input. The derived class says what the lanes show and gives each a number.
/// Thread: GUI.
class TimePlot : public QCustomPlot {
    Q_OBJECT
public:
    /// A lane: its number, or an enumerator of the derived class.
    struct LaneId {
        template <typename Id>
        LaneId(Id id)
            : number(static_cast<int>(id)) {}
        int number;
    };

    void setProvenance(base::Provenance provenance);
    void setHeaderText(const QString& text) { m_header->setText(text); }
    [[nodiscard]] QString headerText() const { return m_header->text(); }

    /// Draws the history from end - span to end into the lanes (without repainting).
    void showStretch(const SampleHistory& history, double end_s, double span_s);
    /// Writes the values of a sample beside the lanes; empty: undefined. steady: small changes are not shown.
    void showValues(const SampleHistory& history, std::optional<std::size_t> index, bool steady);
    /// A line through all lanes; empty: none.
    void setCursorLine(std::optional<double> time_s);
    /// Repaints only the cursor and the values.
    void repaintOverlay();

    /// Takes fonts and colours from the palette.
    void setColours(const QPalette& palette);
    /// The picture as it is now, on white.
    [[nodiscard]] QPicture onPaper();

    /// Range of a lane's axis in displayed units; empty: automatic. Kept when lanes are replaced.
    void setFixedLaneRange(LaneId lane, std::optional<ValueRange> range);
    [[nodiscard]] std::optional<ValueRange> fixedLaneRange(LaneId lane) const;
    /// The range in use; low = high = 0 for a lane that is not shown.
    [[nodiscard]] ValueRange laneRange(LaneId lane) const;
    /// Lets automatic axes narrow at once, after the user changed the time range.
    void forgetRanges();

    /// Time of a point relative to the right end, clamped to the range shown.
    [[nodiscard]] double timeAt(double x) const;
    [[nodiscard]] double xOf(double time_s) const;
    /// The lane with its curves or axis at a point.
    [[nodiscard]] std::optional<int> laneAt(const QPointF& point) const;
    [[nodiscard]] std::optional<int> laneAxisAt(const QPointF& point) const;
    /// Where the curves of a lane are drawn; empty when it is not shown.
    [[nodiscard]] QRect laneRect(LaneId lane) const;
    /// Null when there is no such lane or curve.
    [[nodiscard]] const ValuePanel* lanePanel(LaneId lane) const;
    [[nodiscard]] QCPGraph* laneGraph(LaneId lane, std::size_t curve) const;
    [[nodiscard]] virtual QString laneTitle(int lane) const = 0;

    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] QSize sizeHint() const override;

protected:
    /// Sizes in heights of a line of text.
    struct Shape {
        double width_em = 0.0;      ///< of the whole picture, at least
        double laneHeight_em = 0.0; ///< at least: the title and all values
        double panelWidth_em = 0.0;
        QString widestTick; ///< usual label on a value axis
    };
    struct Curve {
        CurveStyle style;
        QCPGraph* graph = nullptr;
        base::SteadyNumber number;
    };
    struct Lane {
        int id = 0;
        QCPAxisRect* rect = nullptr;
        ValuePanel* panel = nullptr;
        std::vector<Curve> curves;
        base::CalmRange range{1.0};
        bool shown = true;
    };

    TimePlot(const Shape& shape, QWidget* parent);

    /// minimumSpan: of the automatic axis, in displayed units. tickStep: 0 chooses a round one.
    void addLane(LaneId id, const std::vector<CurveStyle>& curves, double minimumSpan, double tickStep = 0.0);
    void clearLanes();
    /// Call after adding, removing, showing or hiding lanes.
    void updateLanes();
    [[nodiscard]] std::vector<Lane>& lanes() { return m_lanes; }
    [[nodiscard]] QCPLayoutGrid* grid() const { return m_grid; }

    [[nodiscard]] virtual QString laneUnit(int lane) const = 0;
    [[nodiscard]] virtual QString curveName(int lane, std::size_t curve) const = 0;
    /// Automatic range of an axis. extent: of the curves, empty without any.
    [[nodiscard]] virtual ValueRange automaticRange(Lane& lane, std::optional<ValueRange> extent,
                                                    const SampleHistory& history, double end_s) = 0;
    /// Places the other elements onto the visible lanes.
    virtual void placeExtras(const std::vector<QCPAxisRect*>& rects) = 0;
    virtual void colourExtras(const QPalette& palette) = 0;

private:
    /// Null if there is no lane of that number.
    [[nodiscard]] const Lane* laneOf(LaneId id) const;
    void arrange();
    void colourLane(Lane& lane);
    void fillLane(Lane& lane, const SampleHistory& history, double end_s, double bucket_s);
    [[nodiscard]] std::size_t shownLanes() const;
    [[nodiscard]] double em() const;

    Shape m_shape;
    std::vector<Lane> m_lanes;
    std::map<int, ValueRange> m_fixed;
    HeaderElement* m_header;
    QCPLayoutGrid* m_grid;
    QCPLayoutElement* m_axisRoom;
    TimeLines* m_jumps;
    TimeLines* m_cursor;
    QPalette m_colours;
    double m_span_s = 10.0;
    std::vector<std::vector<PolylinePoint>> m_lines; ///< of one lane; reused to avoid allocations
};

} // namespace teleta::charts
