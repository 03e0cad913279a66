// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/mark_views.h"

#include "widgets/charts/strip_chart_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::console {

MarkViews::MarkViews(charts::StripChartView& charts, QWidget* parent)
    : QObject(parent)
    , m_charts(charts)
    , m_list(new MarkList(parent)) {
    connect(&m_charts, &charts::StripChartView::markRequested, this, [this](double sourceTime_s) {
        if (m_newest)
            emit markRequested(m_newest->time_ns +
                               std::llround((sourceTime_s - m_newest->sourceTime_s) * 1e9));
    });
    connect(m_list, &MarkList::timeChosen, this, [this](double time_s) {
        if (!m_live && !m_played.empty())
            emit seekRequested(time_s);
    });
}

void MarkViews::setSource(const core::PlaybackControl* playback) {
    m_played = playback != nullptr ? playback->marks() : std::vector<core::PlaybackMark>();
    m_passed.clear();
    m_newest.reset();
    m_stale = true;
    showList();
}

void MarkViews::setRecorded(std::vector<RecordingMark> marks, bool live) {
    m_recorded = std::move(marks);
    m_live = live;
    m_stale = true;
    showList();
}

void MarkViews::take(const pipeline::FeatureSample& sample) {
    if (m_newest && !sample.discontinuity) {
        for (const core::PlaybackMark& mark : m_played) {
            if (mark.sourceTime_s <= m_newest->sourceTime_s || mark.sourceTime_s > sample.sourceTime_s)
                continue;
            m_passed.push_back(mark);
            m_stale = true;
        }
    }
    m_newest = Moment{sample.time_ns, sample.sourceTime_s};
}

void MarkViews::tick() {
    // A mark of now is shown once the charts have come to it.
    if (m_stale && m_newest && (m_recorded.empty() || m_recorded.back().time_ns <= m_newest->time_ns))
        showInCharts();
}

double MarkViews::sourceTimeOf(std::int64_t time_ns) const {
    return m_newest->sourceTime_s + static_cast<double>(time_ns - m_newest->time_ns) * 1e-9;
}

void MarkViews::showInCharts() {
    m_stale = false;
    m_charts.clearMarks();
    for (const core::PlaybackMark& mark : m_passed)
        m_charts.addMark(mark.sourceTime_s, QString::fromStdString(mark.text));
    for (const RecordingMark& mark : m_recorded)
        m_charts.addMark(sourceTimeOf(mark.time_ns), mark.text);
}

void MarkViews::showList() {
    std::vector<MarkList::Row> rows;
    if (!m_live && !m_played.empty()) {
        for (const core::PlaybackMark& mark : m_played)
            rows.push_back({0, mark.time_s, QString::fromStdString(mark.text)});
    } else {
        for (const RecordingMark& mark : m_recorded)
            rows.push_back({mark.number, mark.time_s, mark.text});
    }
    m_list->setMarks(std::move(rows), m_live);
}

} // namespace teleta::console
