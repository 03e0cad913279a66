// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_snapshot.h"
#include "widgets/charts/feature_history.h"
#include "widgets/charts/strips.h"
#include "widgets/charts/time_chart_view.h"

#include <QMenu>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace teleta::charts {

class StripPlot;

/// Features over time: strips below each other with one time axis. In addition to TimeChartView it has marks:
/// M asks for one. Thread: GUI.
class StripChartView : public TimeChartView {
    Q_OBJECT
public:
    static constexpr double kShortestSpan_s = 0.2;

    explicit StripChartView(QWidget* parent = nullptr);

    /// Stores samples; refresh() draws them.
    void append(const pipeline::FeatureSample& sample);
    void append(std::span<const pipeline::FeatureSample> samples);
    /// Clears samples and marks, and goes live.
    void clear();
    /// Moves out the samples, to restore them later. Clears the marks, and goes live.
    [[nodiscard]] FeatureHistory takeHistory();
    /// Restores samples that takeHistory() returned.
    void setHistory(FeatureHistory history);

    void setLoadUnit(const QString& unit);
    /// The array tells three components: it has shear.
    void setVectors(bool vectors);

    /// Checkable; for menus and for remembering.
    [[nodiscard]] QAction* stripAction(Strip strip) const;
    [[nodiscard]] std::vector<Strip> shownStrips() const;

    /// Draws a labelled line at a time of the stream. Returns false if that time is no longer stored.
    bool addMark(double sourceTime_s, const QString& label);
    /// The same at a time of the steady clock.
    bool addMarkAt(std::int64_t time_ns, const QString& label);
    void clearMarks();
    [[nodiscard]] std::size_t marks() const { return m_marks.size(); }

    [[nodiscard]] const FeatureHistory& history() const override { return m_history; }
    [[nodiscard]] StripPlot* plot() const { return m_strips; }

signals:
    /// The user asks for a mark at a sample that arrived at this time of the steady clock.
    void markRequested(std::int64_t time_ns);

protected:
    void retranslate() override;
    void prepareExtras() override;
    void addOwnActions(QMenu& menu, const QPoint& position) override;
    [[nodiscard]] QString cursorText(const QString& time, const QString& sourceTime) const override;
    [[nodiscard]] QString figureName() const override { return tr("charts"); }
    [[nodiscard]] QString csv(std::size_t first, std::size_t last) const override;
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Mark {
        double time_s = 0.0; ///< chart time
        QString label;
    };

    StripChartView(StripPlot* plot, QWidget* parent);
    void makeActions();
    void takeStrips();
    void requestMark();

    FeatureHistory m_history;
    std::vector<Mark> m_marks;
    StripPlot* m_strips;
    QMenu* m_stripsMenu = new QMenu(this);
    std::array<QAction*, kStrips> m_stripActions{};
    bool m_vectors = false;
    QAction* m_mark;
    QToolButton* m_stripsButton;
};

} // namespace teleta::charts
