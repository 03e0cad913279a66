// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/base/badge.h"
#include "widgets/base/calm_range.h"
#include "widgets/base/number_format.h"
#include "widgets/charts/chart_elements.h"
#include "widgets/charts/feature_history.h"
#include "widgets/charts/polyline.h"
#include "widgets/charts/strips.h"

#include <QPicture>

#include <map>
#include <optional>
#include <vector>

namespace teleta::charts {

/// The picture of a strip chart: strips of one stretch of a history, one below the other, with one time axis
/// in seconds before its right end. Knows nothing of what the user does with it. Thread: GUI.
class StripPlot : public QCustomPlot {
    Q_OBJECT
public:
    explicit StripPlot(QWidget* parent = nullptr);

    /// The strips from top to bottom.
    void setStrips(const std::vector<Strip>& strips);
    void setLoadUnit(const QString& unit) { m_loadUnit = unit; }
    void setProvenance(base::Provenance provenance);
    void setHeaderText(const QString& text) { m_header->setText(text); }
    /// Ends of a strip's axis in displayed units; empty: automatic.
    void setFixedRange(Strip strip, std::optional<ValueRange> range);
    [[nodiscard]] std::optional<ValueRange> fixedRange(Strip strip) const;
    /// The ends in use; low = high = 0 for a strip that is not shown.
    [[nodiscard]] ValueRange rangeOf(Strip strip) const;
    /// Lets the automatic axes close at once, after the stretch was changed by hand.
    void forgetRanges();

    /// Draws the history from end - span to end into the strips (without repainting).
    void showStretch(const FeatureHistory& history, double end_s, double span_s);
    /// Writes the values of one sample beside the strips; empty: undefined. steady: small changes are not
    /// shown.
    void showValues(const FeatureHistory& history, std::optional<std::size_t> index, bool steady);
    void setMarks(std::vector<TimeLine> marks) { m_marks->setLines(std::move(marks)); }
    void setCursorLine(std::optional<TimeLine> line);
    /// Repaints only the cursor and the values.
    void repaintOverlay();

    /// Takes fonts and colours from the palette.
    void setColours(const QPalette& palette);
    /// The picture as it is now, on white.
    [[nodiscard]] QPicture onPaper();

    /// Time of a point relative to the right end, clamped to the stretch.
    [[nodiscard]] double timeAt(double x) const;
    [[nodiscard]] double xOf(double time_s) const;
    /// The strip whose curves or axis are at a point.
    [[nodiscard]] std::optional<Strip> stripAt(const QPointF& point) const;
    [[nodiscard]] std::optional<Strip> axisAt(const QPointF& point) const;
    /// Where the curves of a strip are drawn; empty when it is not shown.
    [[nodiscard]] QRect plotRect(Strip strip) const;
    [[nodiscard]] QCPGraph* graphOf(Strip strip, std::size_t series) const;
    [[nodiscard]] const ValuePanel* panelOf(Strip strip) const;
    [[nodiscard]] QString headerText() const { return m_header->text(); }

    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] QSize sizeHint() const override;

private:
    struct Row {
        const StripDefinition* definition = nullptr;
        QCPAxisRect* rect = nullptr;
        ValuePanel* panel = nullptr;
        std::vector<QCPGraph*> graphs;
        std::vector<base::SteadyNumber> numbers;
        base::CalmRange range{1.0};
    };

    Row makeRow(Strip strip);
    void arrange();
    void colourRow(Row& row, const QPalette& palette);
    void fitAxis(Row& row, std::optional<ValueRange> extent, double threshold, double time_s);
    void fillGraphs(Row& row);
    [[nodiscard]] const Row* rowOf(Strip strip) const;
    [[nodiscard]] double em() const;

    QString m_loadUnit;
    std::vector<Row> m_rows;
    std::map<Strip, ValueRange> m_fixed;
    HeaderElement* m_header = nullptr;
    QCPLayoutGrid* m_grid = nullptr;
    QCPLayoutElement* m_axisRoom = nullptr;
    TimeLines* m_marks = nullptr;
    TimeLines* m_jumps = nullptr;
    TimeLines* m_cursor = nullptr;
    QPalette m_colours;
    double m_span_s = 10.0;
    std::vector<std::vector<PolylinePoint>> m_lines; ///< of one strip; kept so that drawing allocates little
};

} // namespace teleta::charts
