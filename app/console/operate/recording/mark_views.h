// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/operate/recording/mark_list.h"
#include "app/console/operate/recording/recording_service.h"
#include "backend/core/device/device.h"
#include "backend/pipeline/touch/touch_snapshot.h"

#include <QObject>

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

namespace teleta::charts {
class StripChartView;
}

namespace teleta::console {

/// The marks of the recording that runs, or of the one that is played, in the strip charts and in a list.
/// Thread: GUI.
class MarkViews : public QObject {
    Q_OBJECT

public:
    MarkViews(charts::StripChartView& charts, QWidget* parent);

    [[nodiscard]] MarkList& list() { return *m_list; }

    /// Another source is shown and its charts start empty. key: 0 without one. playback: null unless it is a
    /// playback.
    void setSource(pipeline::ChannelKey key, const core::PlaybackControl* playback);
    /// The marks of the recording that runs, or of the last one, which are listed beside the sources that
    /// were shown while it ran. live: it runs.
    void setRecorded(std::vector<RecordingMark> marks, bool live);
    /// Call for each sample that the charts get.
    void take(const pipeline::FeatureSample& sample);
    void tick();

    /// Marks of the playback that is shown.
    [[nodiscard]] const std::vector<core::PlaybackMark>& played() const { return m_played; }

signals:
    /// The user asks for a mark at a time in the charts.
    void markRequested(std::int64_t time_ns);
    void seekRequested(double time_s);

private:
    void showList();
    void showInCharts();

    charts::StripChartView& m_charts;
    MarkList* m_list;
    std::vector<core::PlaybackMark> m_played;
    std::vector<bool> m_passed; ///< of these, those that the charts have come to
    std::vector<RecordingMark> m_recorded;
    pipeline::ChannelKey m_source = 0;
    std::set<pipeline::ChannelKey> m_recordedSources; ///< that were shown while m_recorded were set
    bool m_live = false;
    bool m_stale = false; ///< the charts show other marks
    struct Moment {
        std::int64_t time_ns = 0;
        double sourceTime_s = 0.0;
    };
    std::optional<Moment> m_newest; ///< of the charts
};

} // namespace teleta::console
