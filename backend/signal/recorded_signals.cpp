// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/signal/recorded_signals.h"

#include "backend/core/data/json_document.h"
#include "backend/core/failure.h"
#include "backend/signal/stream_clock.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>

namespace teleta::signal {

namespace {

struct RecordedSignalsText {
    Q_DECLARE_TR_FUNCTIONS(RecordedSignalsText)
};

core::Unexpected noSuch(const std::string& path, const std::string& name) {
    return core::failed(
        core::ErrorKind::notFound,
        RecordedSignalsText::tr("The recording has no \"%1\".").arg(QString::fromStdString(name)), {},
        {path});
}

} // namespace

double valueOf(const core::TappedFrames& frames, const recording::StreamInfo& stream, std::size_t frame,
               std::size_t column) {
    return stream.type == recording::ValueType::float32
               ? static_cast<double>(recording::valuesOf<float>(frames, frame, stream.channels())[column])
               : recording::valuesOf<double>(frames, frame, stream.channels())[column];
}

core::Expected<std::vector<recording::StreamInfo>> signalStreamsOf(const std::string& path) {
    TELETA_TRY(const auto recording, recording::Recording::open(path));
    std::vector<recording::StreamInfo> streams;
    std::ranges::copy_if(recording.streams(), std::back_inserter(streams),
                         [](const recording::StreamInfo& stream) { return !columnsOf(stream).empty(); });
    return streams;
}

std::set<std::string> simulatedSourcesOf(std::span<const recording::StreamInfo> streams) {
    std::set<std::string> simulated;
    for (const recording::StreamInfo& stream : streams) {
        const auto document = core::JsonDocument::parse(stream.details, stream.name);
        if (!document)
            continue; // of events or pictures: another stream of the source tells
        core::JsonReader reader(*document);
        if (reader.boolean(reader.root(), "simulated", false))
            simulated.insert(stream.source);
    }
    return simulated;
}

core::Expected<RecordedSignals> readSignals(const std::string& path, const std::string& stream,
                                            std::span<const std::string> columns,
                                            const std::function<bool(double share)>& goOn) {
    TELETA_TRY(const auto recording, recording::Recording::open(path));
    const auto info = std::ranges::find(recording.streams(), stream, &recording::StreamInfo::name);
    if (info == recording.streams().end())
        return noSuch(path, stream);
    const std::vector<recording::Column> known = columnsOf(*info);
    std::vector<std::size_t> places;
    for (const std::string& column : columns) {
        const auto found = std::ranges::find(known, column, &recording::Column::name);
        if (found == known.end())
            return noSuch(path, stream + ", " + column);
        places.push_back(static_cast<std::size_t>(found - known.begin()));
    }
    const auto number = static_cast<std::size_t>(info - recording.streams().begin());
    TELETA_TRY(const auto extent, recording.extent(number));
    RecordedSignals read;
    read.series.resize(places.size());
    if (!extent)
        return read;
    recording::StreamReader reader = recording.reader(number);
    StreamClock clock(recording.head().start_ns, isOfEvents(*info) ? 0.0 : info->nominalRate_Hz);
    core::TappedFrames block;
    std::uint64_t frames = 0;
    for (bool damaged = false;;) {
        const core::Expected<bool> any = reader.next(block);
        if (!any && any.error().kind != core::ErrorKind::badInput)
            return core::Unexpected(any.error());
        if (!any) {
            ++read.damagedBlocks;
            damaged = true;
            if (!reader.canGoOn())
                break;
            continue;
        }
        if (!*any)
            break;
        for (std::size_t frame = 0; frame < block.frames(); ++frame) {
            const StreamClock::Step step = clock.next(block.time_ns[frame], block.sourceTime_s[frame],
                                                      frame == 0 && block.discontinuity);
            for (std::size_t i = 0; i < places.size(); ++i) {
                if (step.gap || damaged)
                    read.series[i].lift();
                read.series[i].append(step.time_s, valueOf(block, *info, frame, places[i]));
            }
            damaged = false;
        }
        frames += block.frames();
        if (goOn && !goOn(static_cast<double>(frames) / static_cast<double>(extent->frames)))
            return core::failed(core::ErrorKind::cancelled,
                                RecordedSignalsText::tr("The reading was stopped."));
    }
    return read;
}

} // namespace teleta::signal
