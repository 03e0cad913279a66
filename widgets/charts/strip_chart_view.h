// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_snapshot.h"
#include "widgets/charts/feature_history.h"
#include "widgets/charts/strips.h"
#include "widgets/charts/time_chart_view.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace teleta::charts {

class StripPlot;

/// Features over time: strips one below the other with one time axis. Beside what all charts over time can,
/// it has marks: M asks for one. Thread: GUI.
class StripChartView : public TimeChartView {
    Q_OBJECT
public:
    static constexpr double kShortestSpan_s = 0.2;

    explicit StripChartView(QWidget* parent = nullptr);

    /// Keeps samples; nothing is drawn before refresh().
    void append(const pipeline::FeatureSample& sample);
    void append(std::span<const pipeline::FeatureSample> samples);
    /// Forgets samples and marks, and goes live.
    void clear();
    /// Gives away the samples, to be shown again another time. Forgets marks, and goes live.
    [[nodiscard]] FeatureHistory takeHistory();
    /// Goes on with samples that takeHistory() gave.
    void setHistory(FeatureHistory history);

    void setLoadUnit(const QString& unit);

    /// Checkable; for menus and for remembering.
    [[nodiscard]] QAction* stripAction(Strip strip) const;
    [[nodiscard]] std::vector<Strip> shownStrips() const;

    /// A vertical line with a label where the stream was at that time of its own. False when it is no longer
    /// kept.
    bool addMark(double sourceTime_s, const QString& label);
    /// The same where the stream was at a time of the steady clock.
    bool addMarkAt(std::int64_t time_ns, const QString& label);
    void clearMarks();
    [[nodiscard]] std::size_t marks() const { return m_marks.size(); }

    void populateMenu(QMenu& menu, std::optional<Strip> strip = std::nullopt);

    [[nodiscard]] const FeatureHistory& history() const override { return m_history; }
    [[nodiscard]] StripPlot* plot() const { return m_strips; }

signals:
    /// The user wants a mark at a sample, which came at that time of the steady clock.
    void markRequested(std::int64_t time_ns);
    void stripsChanged();

protected:
    void retranslate() override;
    void prepareExtras() override;
    void fillMenu(QMenu& menu, std::optional<int> lane) override;
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
    QMenu* m_stripsMenu;
    std::array<QAction*, kStrips> m_stripActions{};
    QAction* m_mark;
    QToolButton* m_stripsButton;
};

} // namespace teleta::charts
