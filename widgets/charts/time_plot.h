// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/calm_range.h"
#include "widgets/base/controls/badge.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/charts/chart_elements.h"
#include "widgets/charts/display.h"
#include "widgets/charts/polyline.h"
#include "widgets/charts/sample_history.h"

#include <QPicture>

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace teleta::charts {

/// The picture of a chart over time: lanes of one stretch of a history, one below the other, with one time
/// axis in seconds before its right end. Knows nothing of what the user does with it. What the lanes show is
/// said by the class that derives from it, which gives each lane a number of its own. Thread: GUI.
class TimePlot : public QCustomPlot {
    Q_OBJECT
public:
    void setProvenance(base::Provenance provenance);
    void setHeaderText(const QString& text) { m_header->setText(text); }
    [[nodiscard]] QString headerText() const { return m_header->text(); }

    /// Draws the history from end - span to end into the lanes (without repainting).
    void showStretch(const SampleHistory& history, double end_s, double span_s);
    /// Writes the values of one sample beside the lanes; empty: undefined. steady: small changes are not
    /// shown.
    void showValues(const SampleHistory& history, std::optional<std::size_t> index, bool steady);
    /// A line through all lanes; empty: none.
    void setCursorLine(std::optional<double> time_s);
    /// Repaints only the cursor and the values.
    void repaintOverlay();

    /// Takes fonts and colours from the palette.
    void setColours(const QPalette& palette);
    /// The picture as it is now, on white.
    [[nodiscard]] QPicture onPaper();

    /// Ends of a lane's axis in displayed units; empty: automatic. They outlast the lane.
    void setFixedLaneRange(int lane, std::optional<ValueRange> range);
    [[nodiscard]] std::optional<ValueRange> fixedLaneRange(int lane) const;
    /// The ends in use; low = high = 0 for a lane that is not shown.
    [[nodiscard]] ValueRange laneRange(int lane) const;
    /// Lets the automatic axes close at once, after the stretch was changed by hand.
    void forgetRanges();

    /// Time of a point relative to the right end, clamped to the stretch.
    [[nodiscard]] double timeAt(double x) const;
    [[nodiscard]] double xOf(double time_s) const;
    /// The lane whose curves or axis are at a point.
    [[nodiscard]] std::optional<int> laneAt(const QPointF& point) const;
    [[nodiscard]] std::optional<int> laneAxisAt(const QPointF& point) const;
    /// Where the curves of a lane are drawn; empty when it is not shown.
    [[nodiscard]] QRect laneRect(int lane) const;
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
    /// How a column of the history is drawn.
    struct CurveStyle {
        std::size_t column = 0;
        Display display;
        int colour = 1;      ///< identity colour; 0 the colour of faint text
        bool dashed = false; ///< a reference, not a measurement
        double period = 0.0; ///< of the SI value, for angles
        bool whole = false;  ///< a count
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
    void addLane(int id, const std::vector<CurveStyle>& curves, double minimumSpan, double tickStep = 0.0);
    void clearLanes();
    /// After lanes came, went, were shown or hidden.
    void updateLanes();
    [[nodiscard]] std::vector<Lane>& lanes() { return m_lanes; }
    /// Null when there is none of that number.
    [[nodiscard]] const Lane* laneOf(int id) const;
    [[nodiscard]] const ValuePanel* lanePanel(int id) const;
    [[nodiscard]] QCPGraph* laneGraph(int id, std::size_t curve) const;
    [[nodiscard]] QCPLayoutGrid* grid() const { return m_grid; }

    [[nodiscard]] virtual QString laneUnit(int lane) const = 0;
    [[nodiscard]] virtual QString curveName(int lane, std::size_t curve) const = 0;
    /// The ends of an axis that nobody has typed. extent: of the curves, empty without any.
    [[nodiscard]] virtual ValueRange automaticRange(Lane& lane, std::optional<ValueRange> extent,
                                                    const SampleHistory& history, double end_s) = 0;
    /// Puts what is drawn besides the curves onto the lanes that are shown.
    virtual void placeExtras(const std::vector<QCPAxisRect*>& rects) = 0;
    virtual void colourExtras(const QPalette& palette) = 0;

private:
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
    std::vector<std::vector<PolylinePoint>> m_lines; ///< of one lane; kept so that drawing allocates little
};

} // namespace teleta::charts
