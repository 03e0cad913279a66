// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/recording/mark_views.h"

#include "widgets/charts/strip_chart_view.h"

#include <algorithm>
#include <utility>

namespace teleta::console {

MarkViews::MarkViews(charts::StripChartView& charts, QWidget* parent)
    : QObject(parent)
    , m_charts(charts)
    , m_list(new MarkList(parent)) {
    connect(&m_charts, &charts::StripChartView::markRequested, this, &MarkViews::markRequested);
    connect(m_list, &MarkList::timeChosen, this, [this](double time_s) {
        const auto chosen = std::ranges::find(m_played, time_s, &core::PlaybackMark::sourceTime_s);
        if (!m_live && chosen != m_played.end())
            emit seekRequested(chosen->time_s);
    });
}

void MarkViews::setSource(pipeline::ChannelKey key, const core::PlaybackControl* playback) {
    m_source = key;
    if (m_live)
        m_recordedSources.insert(key);
    m_played = playback != nullptr ? playback->marks() : std::vector<core::PlaybackMark>();
    // Those that the charts came by before the source was left are there again.
    m_charts.clearMarks();
    m_passed.clear();
    for (const core::PlaybackMark& mark : m_played)
        m_passed.push_back(m_charts.addMark(mark.sourceTime_s, QString::fromStdString(mark.text)));
    m_newest.reset();
    m_stale = true;
    showList();
}

void MarkViews::setRecorded(std::vector<RecordingMark> marks, bool live) {
    m_recorded = std::move(marks);
    if (live && !m_live)
        m_recordedSources = {m_source};
    m_live = live;
    m_stale = true;
    showList();
}

void MarkViews::take(const pipeline::FeatureSample& sample) {
    if (m_newest && !sample.discontinuity) {
        for (std::size_t i = 0; i < m_played.size(); ++i) {
            const double mark_s = m_played[i].sourceTime_s;
            if (mark_s <= m_newest->sourceTime_s || mark_s > sample.sourceTime_s)
                continue;
            m_passed[i] = true;
            m_stale = true;
        }
    }
    // A mark of now was shown where the charts were, until they have come to it.
    if (m_newest && !m_recorded.empty() && m_recorded.back().time_ns > m_newest->time_ns &&
        m_recorded.back().time_ns <= sample.time_ns)
        m_stale = true;
    m_newest = Moment{sample.time_ns, sample.sourceTime_s};
}

void MarkViews::tick() {
    if (m_stale && m_newest)
        showInCharts();
}

void MarkViews::showInCharts() {
    m_stale = false;
    m_charts.clearMarks();
    for (std::size_t i = 0; i < m_played.size(); ++i)
        if (m_passed[i])
            m_charts.addMark(m_played[i].sourceTime_s, QString::fromStdString(m_played[i].text));
    for (const RecordingMark& mark : m_recorded)
        m_charts.addMarkAt(mark.time_ns, mark.text);
}

void MarkViews::showList() {
    std::vector<MarkList::Row> rows;
    const bool isPlayed = !m_live && !m_played.empty();
    if (isPlayed) {
        for (const core::PlaybackMark& mark : m_played)
            // From the recording's start, as while it was recorded.
            rows.push_back({0, mark.sourceTime_s, QString::fromStdString(mark.text)});
    } else if (m_live || m_recordedSources.contains(m_source)) {
        for (const RecordingMark& mark : m_recorded)
            rows.push_back({mark.number, mark.time_s, mark.text});
    }
    // Of what was recorded they can be changed after its end too.
    m_list->setMarks(std::move(rows), !isPlayed);
}

} // namespace teleta::console
