// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/plot/signal_sources.h"

#include "app/console/sources/source_provenance.h"
#include "backend/arm_model/serial_chain.h"
#include "backend/core/steady_time.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/recording/recording.h"
#include "backend/recording/stream_columns.h"
#include "widgets/base/background.h"
#include "widgets/touch/touch_texts.h"

#include <QDateTime>
#include <QFileInfo>

#include <algorithm>
#include <numeric>
#include <utility>

namespace teleta::console {

namespace {

/// The wanted name, or with a number that makes it another one than all that are there.
template <typename Named, typename NameOf>
std::string freeName(const std::string& wanted, const std::vector<Named>& there, NameOf nameOf) {
    std::string name = wanted;
    for (int number = 2; std::ranges::find(there, name, nameOf) != there.end(); ++number)
        name = wanted + " " + std::to_string(number);
    return name;
}

constexpr std::size_t kOwnJoints = 4; ///< of an arm that needs no description

} // namespace

SignalSources::SignalSources(SourceManager& sources, QObject* parent)
    : QObject(parent)
    , m_sources(sources) {
    connect(&m_sources, &SourceManager::opened, this, &SignalSources::watch);
    connect(&m_sources, &SourceManager::closed, this, [this](pipeline::ChannelKey key) {
        if (std::erase_if(m_live, [key](const Live& live) { return live.key == key; }) > 0)
            emit changed();
    });
}

SignalSources::~SignalSources() {
    cancelReadings();
}

void SignalSources::cancelReadings() {
    for (const auto& reading : std::exchange(m_readings, {}))
        reading->cancelled = true;
}

std::vector<QString> SignalSources::jointsOf(const recording::StreamInfo& stream, const Arm& arm) {
    const auto joints = recording::jointsOf(stream);
    if (!joints || (arm.chain ? arm.chain->joints() != *joints : !arm.isOwn || *joints != kOwnJoints))
        return {};
    std::vector<QString> names;
    for (std::size_t i = 0; i < stream.channels(); ++i)
        names.push_back(arm.chain ? QString::fromStdString(arm.chain->joint(i % *joints).name)
                                  : touch::TouchTexts::joint(i % *joints, *joints));
    return names;
}

SignalSources::Arm SignalSources::armOf(const Live& live) const {
    const SourceManager::Item* item = m_sources.find(live.key);
    const auto joints = item != nullptr && item->isOpen() ? item->joints() : nullptr;
    if (!joints)
        return {};
    return {joints->chain(), joints->chain() == nullptr};
}

core::Expected<SignalSources::Listed> SignalSources::list(const std::string& path) {
    TELETA_TRY(const auto recording, recording::Recording::open(path));
    Listed listed;
    listed.start_unix_s =
        1e-3 * static_cast<double>(recording.utcOf(recording.head().start_ns).toMSecsSinceEpoch());
    TELETA_TRY(listed.streams, signal::signalStreamsOf(path));
    for (const recording::StreamInfo& stream : listed.streams) {
        // One that is not described has no names, and is plotted all the same.
        const auto arm = pipeline::recordedArm(stream, path);
        listed.arms.push_back(arm ? Arm{arm->chain, arm->chain == nullptr} : Arm{});
    }
    return listed;
}

void SignalSources::watch(pipeline::ChannelKey key) {
    const SourceManager::Item* item = m_sources.find(key);
    if (item == nullptr || !item->channel)
        return;
    if (m_live.empty()) {
        m_origin_ns = core::steadyNow_ns();
        m_origin_unix_s = 1e-3 * static_cast<double>(QDateTime::currentMSecsSinceEpoch());
    }
    const std::string name =
        freeName(item->name.toStdString(), m_live, [](const Live& live) { return live.source->name(); });
    auto source = std::make_shared<signal::LiveSource>(name, m_origin_ns);
    item->channel->watch(pipeline::Watcher::plot, source, name);
    m_live.push_back({key, std::move(source)});
    if (const auto* recording = std::get_if<app::RecordingRequest>(&item->request))
        addRecording(QString::fromStdString(recording->path));
}

std::optional<SignalSources::Signal> SignalSources::find(const signal::SignalId& id) const {
    const auto signalOf = [&](const recording::StreamInfo& info, const Arm& arm) -> std::optional<Signal> {
        const auto columns = signal::columnsOf(info);
        const auto column = std::ranges::find(columns, id.column, &recording::Column::name);
        if (column == columns.end())
            return std::nullopt;
        const bool events = signal::isOfEvents(info);
        Signal found;
        found.unit = column->unit;
        found.rate_Hz = events ? 0.0 : info.nominalRate_Hz;
        found.isOfEvents = events;
        const std::vector<QString> joints = jointsOf(info, arm);
        if (const auto place = static_cast<std::size_t>(column - columns.begin()); place < joints.size())
            found.meaning = joints[place];
        return found;
    };
    for (const Live& live : m_live) {
        if (live.source->name() != id.source)
            continue;
        for (const signal::LiveSource::Stream& stream : live.source->streams()) {
            const auto place = std::ranges::find(stream.columns, id.column,
                                                 [](const auto& each) { return each.column.name; });
            if (stream.name != id.stream || place == stream.columns.end())
                continue;
            auto found = signalOf(stream.info, armOf(live));
            found->start_unix_s = m_origin_unix_s;
            found->series = place->series;
            found->newest = place->newest;
            if (const SourceManager::Item* item = m_sources.find(live.key))
                found->provenance = provenanceOf(*item);
            return found;
        }
    }
    for (const Recorded& recorded : m_recordings) {
        const auto& streams = recorded.listed.streams;
        const auto stream = std::ranges::find(streams, id.stream, &recording::StreamInfo::name);
        if (recorded.name != id.source || stream == streams.end())
            continue;
        auto found =
            signalOf(*stream, recorded.listed.arms[static_cast<std::size_t>(stream - streams.begin())]);
        if (found) {
            found->start_unix_s = recorded.listed.start_unix_s;
            found->isRecorded = true;
            found->provenance = recorded.simulated.contains(stream->source)
                                    ? base::Provenance::recordedSimulation
                                    : base::Provenance::recorded;
        }
        return found;
    }
    return std::nullopt;
}

std::vector<signal::SourceEntry> SignalSources::entries() const {
    std::vector<signal::SourceEntry> entries;
    for (const Live& live : m_live) {
        signal::SourceEntry entry{live.source->name(), {}, {}};
        const Arm arm = armOf(live);
        for (const signal::LiveSource::Stream& stream : live.source->streams())
            entry.streams.push_back(
                {stream.name, signal::columnsOf(stream.info), jointsOf(stream.info, arm)});
        entries.push_back(std::move(entry));
    }
    for (const Recorded& recorded : m_recordings) {
        signal::SourceEntry entry{recorded.name, tr("whole recording"), {}};
        for (std::size_t i = 0; i < recorded.listed.streams.size(); ++i) {
            const recording::StreamInfo& stream = recorded.listed.streams[i];
            entry.streams.push_back(
                {stream.name, signal::columnsOf(stream), jointsOf(stream, recorded.listed.arms[i])});
        }
        entries.push_back(std::move(entry));
    }
    return entries;
}

std::uint64_t SignalSources::lost() const {
    return std::accumulate(m_live.begin(), m_live.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const Live& live) { return sum + live.source->lost(); });
}

void SignalSources::addRecording(const QString& path) {
    const std::string file = path.toStdString();
    if (std::ranges::find(m_recordings, file, &Recorded::path) != m_recordings.end() ||
        std::ranges::find(m_adding, file) != m_adding.end())
        return;
    m_adding.push_back(file);
    base::runInBackground(
        this, [file] { return list(file); },
        [this, file, path](core::Expected<Listed> listed) {
            std::erase(m_adding, file);
            const QString shown = QFileInfo(path).fileName();
            if (!listed) {
                emit failed(shown, QString::fromStdString(core::describe(listed.error())));
                return;
            }
            std::string name = freeName(shown.toStdString(), m_recordings, &Recorded::name);
            std::set<std::string> simulated = signal::simulatedSourcesOf(listed->streams);
            m_recordings.push_back({std::move(name), file, std::move(*listed), std::move(simulated)});
            emit changed();
        });
}

void SignalSources::read(const std::vector<signal::SignalId>& signalIds) {
    if (signalIds.empty())
        return;
    const auto recorded = std::ranges::find(m_recordings, signalIds.front().source, &Recorded::name);
    if (recorded == m_recordings.end())
        return;
    std::vector<std::string> columns;
    for (const signal::SignalId& id : signalIds)
        columns.push_back(id.column);
    auto reading = std::make_shared<Reading>();
    m_readings.push_back(reading);
    base::runInBackground(
        this,
        [reading, columns, path = recorded->path, stream = signalIds.front().stream] {
            return signal::readSignals(path, stream, columns, [&reading](double share) {
                reading->share = share;
                return !reading->cancelled;
            });
        },
        [this, reading, signalIds](core::Expected<signal::RecordedSignals> read) {
            if (reading->cancelled)
                return;
            std::erase(m_readings, reading);
            for (std::size_t i = 0; i < signalIds.size(); ++i) {
                if (!read)
                    emit readFailed(signalIds[i], QString::fromStdString(core::describe(read.error())));
                else
                    emit readDone(signalIds[i],
                                  std::make_shared<const signal::Series>(std::move(read->series[i])));
            }
            if (read && read->damagedBlocks > 0)
                emit damaged(QString::fromStdString(signalIds.front().source),
                             static_cast<int>(read->damagedBlocks));
        });
}

std::optional<double> SignalSources::progress() const {
    if (m_readings.empty())
        return std::nullopt;
    return std::accumulate(m_readings.begin(), m_readings.end(), 0.0,
                           [](double sum, const auto& reading) { return sum + reading->share; }) /
           static_cast<double>(m_readings.size());
}

void SignalSources::keep(const std::vector<signal::SignalId>& signalIds, std::size_t samples) {
    for (const Live& live : m_live)
        live.source->keep(
            [&](const std::string& stream, const std::string& column) {
                const signal::SignalId id{live.source->name(), stream, column};
                return std::ranges::find(signalIds, id) != signalIds.end();
            },
            samples);
}

void SignalSources::tick() {
    bool isNew = false;
    for (const Live& live : m_live)
        isNew = live.source->take() || isNew;
    if (isNew)
        emit changed();
}

} // namespace teleta::console
