// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/replay_command.h"

#include "app/cli/feature_rows.h"
#include "app/cli/interruption.h"
#include "app/cli/progress_bar.h"
#include "app/cli/validators.h"
#include "backend/core/wakeup.h"
#include "backend/pipeline/touch_channel.h"
#include "devices/replay/recorded_device.h"

#include <QCoreApplication>
#include <QStringList>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <utility>
#include <vector>

namespace teleta::cli {

namespace {

struct ReplayText {
    Q_DECLARE_TR_FUNCTIONS(ReplayCommand)
};

/// So few that the samples of what waits fit into a channel's history.
constexpr std::size_t kBlocksAtOnce = 16;
constexpr std::chrono::milliseconds kIdle{50};

/// What is missing in the rows, on standard error.
void tellLosses(std::uint64_t damagedBlocks, std::uint64_t framesLost) {
    if (damagedBlocks == 0 && framesLost == 0)
        return;
    const QStringList counts{
        ReplayText::tr("%n damaged block(s) left out", nullptr, static_cast<int>(damagedBlocks)),
        ReplayText::tr("%n frame(s) lost at this speed", nullptr, static_cast<int>(framesLost))};
    std::fprintf(stderr, "teleta: %s\n", qUtf8Printable(counts.join(QStringLiteral(", "))));
}

} // namespace

QString ReplayCommand::summary() const {
    return ReplayText::tr("Play a recording through the processing of a device and print its features");
}

const char* ReplayCommand::example() const {
    return "teleta replay run/recording.teleta --out features.csv";
}

void ReplayCommand::declare(CLI::App& app) {
    app.add_option("RECORDING", m_path,
                   ReplayText::tr("Recording of the console or of teleta simulate").toStdString())
        ->type_name("")
        ->required();
    app.add_option("--stream", m_stream,
                   ReplayText::tr("Name of the array's stream; otherwise the first array").toStdString())
        ->type_name("NAME");
    app.add_option("--speed", m_speed,
                   ReplayText::tr("Times the recorded speed; otherwise as fast as possible").toStdString())
        ->type_name("X")
        ->check(between(0.01, 100.0));
    app.add_option("--threshold", m_threshold,
                   ReplayText::tr("Load from which a taxel is in contact; otherwise as it was recorded")
                       .toStdString())
        ->check(positive());
    declareJson(app, m_output.json);
    declareOut(app, m_output.outPath);
}

core::Expected<pipeline::RecordedSource>
ReplayCommand::chooseSource(const recording::Recording& recording) const {
    auto sources = pipeline::recordedSources(recording);
    if (!sources)
        return core::Unexpected(sources.error());
    const auto found = std::ranges::find_if(*sources, [&](const pipeline::RecordedSource& source) {
        return m_stream.empty() || recording.streams()[source.arrayStream].name == m_stream;
    });
    if (found != sources->end())
        return std::move(*found);
    // What is there under that name may not be described.
    for (const recording::StreamInfo& stream : recording.streams()) {
        if (stream.name != m_stream || stream.kind != recording::StreamKind::array)
            continue;
        if (const auto array = pipeline::recordedArray(stream, recording.path()); !array)
            return core::Unexpected(array.error());
    }
    QStringList names;
    for (const pipeline::RecordedSource& source : *sources)
        names << QString::fromStdString(recording.streams()[source.arrayStream].name);
    throw CLI::ValidationError("--stream", ReplayText::tr("the recording has the arrays %1")
                                               .arg(names.join(QStringLiteral(", ")))
                                               .toStdString());
}

core::Expected<void> ReplayCommand::run() {
    const core::Expected<recording::Recording> recording = recording::Recording::open(m_path);
    if (!recording)
        return core::Unexpected(recording.error());
    core::Expected<pipeline::RecordedSource> source = chooseSource(*recording);
    if (!source)
        return core::Unexpected(source.error());
    pipeline::ChannelSettings settings = std::move(source->array.settings);
    settings.features.threshold_N = m_threshold.value_or(settings.features.threshold_N);
    replay::RecordedConfig config;
    config.path = m_path;
    config.arrayStream = source->arrayStream;
    config.array = std::move(source->array.description);
    config.speed = m_speed.value_or(std::numeric_limits<double>::infinity());
    config.queueBlocks = kBlocksAtOnce;
    const auto player = replay::RecordedPlayer::open(std::move(config));
    if (!player)
        return core::Unexpected(player.error());
    core::Expected<RowOutput> rows = RowOutput::open(kFeatureColumns, m_output);
    if (!rows)
        return core::Unexpected(rows.error());

    core::Wakeup data;
    auto made = std::make_unique<replay::RecordedArray>(*player);
    const replay::RecordedArray& array = *made;
    pipeline::TouchChannel channel(std::move(made), std::move(settings));
    ProgressBar progress(ProgressBar::Unit::frames, rows->onTerminal());
    channel.source().start(data);
    core::DeviceStatus status;
    for (bool ended = false; !ended && !interrupted() && !rows->failed();) {
        status = channel.status();
        ended = status.state == core::DeviceState::finished || status.state == core::DeviceState::lost;
        // Once more after the end: what was delivered before it.
        if (!ended)
            data.waitFor(kIdle);
        channel.process();
        pipeline::FeatureSample sample;
        while (channel.popSample(sample))
            writeFeatures(*rows, sample.sourceTime_s, sample.features);
        rows->flushIfDue();
        progress.update(static_cast<double>(channel.framesProcessed()),
                        static_cast<double>(channel.playback()->position().frames));
    }
    channel.source().stop();
    progress.erase();
    tellLosses(array.damagedBlocks(), array.status().framesLost);
    if (status.state == core::DeviceState::lost && !interrupted()) {
        rows->flush();
        return core::Unexpected(array.error());
    }
    if (channel.samplesNotShown() > 0) {
        rows->flush();
        return core::Unexpected(core::Error{core::ErrorKind::ioFailed,
                                            ReplayText::tr("%n frame(s) were not printed", nullptr,
                                                           static_cast<int>(channel.samplesNotShown()))
                                                .toStdString(),
                                            {},
                                            {m_path}});
    }
    const core::Expected<void> finished = rows->finish();
    if (finished && interrupted())
        return core::Unexpected(interruption());
    return finished;
}

} // namespace teleta::cli
