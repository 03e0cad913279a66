// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/feature_rows.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/base/progress_bar.h"
#include "app/cli/base/tracker_rows.h"
#include "app/cli/commands/devices/devices_commands.h"
#include "backend/core/failure.h"
#include "backend/core/threads/wakeup.h"
#include "backend/pipeline/recorded/recorded_sources.h"
#include "backend/pipeline/touch/frame_loads.h"
#include "backend/pipeline/touch_channel.h"
#include "backend/recording/recording.h"
#include "backend/vision/contacts/contact_rows.h"
#include "backend/vision/finders/contact_ladder.h"
#include "backend/vision/finders/picture_view.h"
#include "backend/vision/gel/gel_contact_rows.h"
#include "backend/vision/gel/gel_follower.h"
#include "devices/replay/playback_config.h"
#include "devices/replay/recorded_device.h"

#include <QCoreApplication>
#include <QStringList>

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
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
    warn(counts.join(QStringLiteral(", ")));
}

/// Ends the output after a source has ended.
core::Expected<void> finish(RowOutput& rows, const replay::RecordedControl& source,
                            const core::DeviceStatus& status, std::uint64_t framesLost) {
    tellLosses(source.damagedBlocks(), framesLost);
    if (status.state == core::DeviceState::lost && !interrupted()) {
        rows.flush();
        return core::Unexpected(source.error());
    }
    return unlessCut(rows.finish());
}

using Source = std::variant<pipeline::RecordedSource, pipeline::RecordedCamera, pipeline::RecordedGel>;

class ReplayCommand {
public:
    void declare(CLI::App& app) {
        addOption(app, "RECORDING", m_path, ReplayText::tr("Recording of the console or of teleta simulate"),
                  "")
            ->required();
        addOption(app, "--stream", m_stream,
                  ReplayText::tr("Name of the stream of an array or a camera; otherwise the first one"),
                  "NAME");
        addOption(app, "--speed", m_speed,
                  ReplayText::tr("Times the recorded speed; otherwise as fast as possible"), "X")
            ->check(between(0.01, 100.0));
        addOption(app, "-t,--threshold", m_threshold,
                  ReplayText::tr("Load from which a taxel is in contact; otherwise as it was recorded"))
            ->check(positive());
        declareJson(app, m_output.json);
        declareOut(app, m_output.outPath);
    }

    [[nodiscard]] core::Expected<void> run() {
        TELETA_TRY(const recording::Recording recording, recording::Recording::open(m_path));
        TELETA_TRY(Source source, chooseSource(recording));
        if (const auto* camera = std::get_if<pipeline::RecordedCamera>(&source))
            return replayCamera(recording, *camera);
        if (const auto* gel = std::get_if<pipeline::RecordedGel>(&source))
            return replayGel(recording, *gel);
        auto array = std::get<pipeline::RecordedSource>(std::move(source));
        if (pipeline::settingsChanged(recording.events(), recording.streams()[array.arrayStream].name))
            warn(
                ReplayText::tr("the settings changed during the recording; those of its beginning are used"));
        return replayArray(std::move(array));
    }

private:
    [[nodiscard]] core::Expected<Source> chooseSource(const recording::Recording& recording) const {
        TELETA_TRY(auto sources, pipeline::recordedSources(recording));
        if (sources.arrays.empty() && sources.cameras.empty() && sources.gels.empty())
            return core::failed(
                core::ErrorKind::refused,
                ReplayText::tr("the recording has joints of an arm or pictures to look at, and "
                               "nothing that is computed from them"),
                ReplayText::tr("frames of an array or a camera"), {m_path});
        QStringList names;
        const auto isChosen = [&](std::size_t stream) {
            const std::string& name = recording.streams()[stream].name;
            names << QString::fromStdString(name);
            return m_stream.empty() || name == m_stream;
        };
        for (pipeline::RecordedSource& source : sources.arrays)
            if (isChosen(source.arrayStream))
                return Source(std::move(source));
        for (pipeline::RecordedCamera& source : sources.cameras)
            if (isChosen(source.stream))
                return Source(std::move(source));
        for (pipeline::RecordedGel& source : sources.gels)
            if (isChosen(source.stream))
                return Source(std::move(source));
        // What is there under that name may not be described.
        for (const recording::StreamInfo& stream : recording.streams()) {
            if (stream.name != m_stream || stream.kind != recording::StreamKind::array)
                continue;
            TELETA_CHECK(pipeline::recordedArray(stream, recording.path()));
        }
        refuse("--stream", ReplayText::tr("the recording has the arrays and cameras %1")
                               .arg(names.join(QStringLiteral(", "))));
    }

    /// Where the frames of a stream come from.
    [[nodiscard]] replay::RecordedConfig configOf(std::size_t stream) const {
        replay::RecordedConfig config;
        config.path = m_path;
        config.stream = stream;
        config.speed = m_speed.value_or(std::numeric_limits<double>::infinity());
        config.queueBlocks = kBlocksAtOnce;
        return config;
    }

    /// Plays the pictures of a stream: take(rows, frame) for each, end(frames) after the last one.
    template <typename Take, typename End>
    [[nodiscard]] core::Expected<void>
    replayPictures(const recording::Recording& recording, const pipeline::RecordedPictures& source,
                   const std::vector<std::string>& columns, Take take, End end) {
        if (m_threshold)
            refuse("--threshold", ReplayText::tr("this is for arrays, but the stream \"%1\" is a camera's")
                                      .arg(QString::fromStdString(recording.streams()[source.stream].name)));
        replay::RecordedConfig config = configOf(source.stream);
        config.camera = source.description;
        config.referenceStream = source.referenceStream;
        TELETA_TRY(const auto player, replay::RecordedPlayer::open(std::move(config)));
        TELETA_TRY(RowOutput rows, openRows(columns, m_output));

        core::Wakeup data;
        replay::RecordedCamera camera(player);
        ProgressBar progress(ProgressBar::Unit::frames, rows.onTerminal());
        camera.start(data);
        core::DeviceStatus status;
        long long done = 0;
        std::uint64_t lost = 0; // to what takes them, where it is slower than the playing
        for (bool ended = false; !ended && !interrupted() && !rows.failed();) {
            status = camera.status();
            ended = status.state == core::DeviceState::finished || status.state == core::DeviceState::lost;
            if (!ended)
                data.waitFor(kIdle);
            core::CameraFrame frame;
            while (!interrupted() && camera.pop(frame)) {
                ++done;
                lost += frame.passedOver;
                take(rows, frame);
                rows.flushIfDue();
                progress.update(static_cast<double>(done), static_cast<double>(camera.position().frames));
            }
        }
        camera.stop();
        progress.erase();
        end(done);
        return finish(rows, camera, status, lost + status.framesLost);
    }

    [[nodiscard]] core::Expected<void> replayCamera(const recording::Recording& recording,
                                                    const pipeline::RecordedCamera& source) {
        TELETA_TRY(auto finder, vision::makeContactFinder(vision::contactLadder().front(), source.camera));
        vision::CameraTracker tracker(std::move(finder), {.identities = {}, .bump = source.bump});
        TELETA_TRY(const auto reference, pipeline::firstReference(recording, source.referenceStream));
        if (!reference.isEmpty()) {
            TELETA_CHECK(tracker.next(vision::viewOf(reference), 0.0));
        }
        // The reference, wherever it is kept, is frame 0.
        const long long first = reference.isEmpty() ? 0 : 1;
        const auto take = [&](RowOutput& rows, const core::CameraFrame& frame) {
            if (frame.discontinuity && tracker.hasReference())
                tracker.forget();
            if (!frame.reference.isEmpty()) {
                tracker.renewReference();
                (void)tracker.next(vision::viewOf(frame.reference), frame.capture_s); // counted by it
            }
            // One that cannot be used is counted by the tracker.
            if (const auto contacts = tracker.next(vision::viewOf(frame.image), frame.capture_s))
                writeContacts(rows, first + static_cast<long long>(frame.number), frame.capture_s, tracker,
                              *contacts);
        };
        return replayPictures(recording, source,
                              {vision::kContactColumns.begin(), vision::kContactColumns.end()}, take,
                              [&tracker](long long) { warnOfUnusableFrames(tracker); });
    }

    [[nodiscard]] core::Expected<void> replayGel(const recording::Recording& recording,
                                                 const pipeline::RecordedGel& source) {
        TELETA_TRY(core::GreyImage reference, pipeline::firstReference(recording, source.referenceStream));
        vision::GelFollower follower(source.file);
        long long unusable = 0;
        std::string problem; // the last one
        const auto take = [&](RowOutput& rows, const core::CameraFrame& frame) {
            if (frame.discontinuity)
                follower.forget();
            if (!frame.reference.isEmpty())
                reference = frame.reference;
            if (!frame.image.isEmpty() && !reference.isEmpty())
                takeReference(follower, std::exchange(reference, {}), frame.image);
            follower.next(vision::viewOf(frame.image), frame.capture_s);
            if (follower.hasReference() && !follower.usable())
                ++unusable;
            if (!follower.problem().empty())
                problem = follower.problem();
            for (const vision::GelContactState& contact : follower.contacts())
                vision::writeGelContact(rows, static_cast<long long>(frame.number), frame.capture_s, contact,
                                        source.loads ? pipeline::loadValues(source.loads->at(contact))
                                                     : std::vector<double>());
        };
        std::vector<std::string> columns{vision::kGelContactColumns.begin(),
                                         vision::kGelContactColumns.end()};
        if (source.loads)
            for (const recording::Column& column : pipeline::loadColumns(source.loads->calibration().loads))
                columns.push_back(column.name);
        return replayPictures(recording, source, columns, take, [&](long long frames) {
            if (!follower.hasReference())
                warn(ReplayText::tr("The gel at rest could not be found, so there are no contacts. %1")
                         .arg(QString::fromStdString(problem)));
            else if (unusable > 0)
                warn(ReplayText::tr("%1 of %2 frames could not be used. The last reason: %3")
                         .arg(unusable)
                         .arg(frames)
                         .arg(QString::fromStdString(problem)));
        });
    }

    /// The recorded pictures of the gel at rest, if there are any; otherwise the first pictures show it.
    static void takeReference(vision::GelFollower& follower, const core::GreyImage& stack,
                              const core::GreyImage& picture) {
        std::vector<cv::Mat1b> parts;
        const auto pictures = pipeline::unstackedReference(stack, picture.width_px, picture.height_px);
        for (const core::GreyImage& part : pictures)
            parts.push_back(vision::viewOf(part));
        if (const auto taken = follower.setReference(parts); !taken)
            warn(QString::fromStdString(taken.error().message));
    }

    [[nodiscard]] core::Expected<void> replayArray(pipeline::RecordedSource source) {
        pipeline::ChannelSettings settings = std::move(source.array.settings);
        settings.features.threshold_N = m_threshold.value_or(settings.features.threshold_N);
        replay::RecordedConfig config = configOf(source.arrayStream);
        config.array = std::move(source.array.description);
        const bool vectors = config.array.layout.isVector();
        TELETA_TRY(const auto player, replay::RecordedPlayer::open(std::move(config)));
        TELETA_TRY(RowOutput rows, openRows(featureRowColumns(settings.loadUnit, vectors), m_output));

        core::Wakeup data;
        auto made = std::make_unique<replay::RecordedArray>(player);
        const replay::RecordedArray& array = *made;
        pipeline::TouchChannel channel(std::move(made), std::move(settings));
        ProgressBar progress(ProgressBar::Unit::frames, rows.onTerminal());
        channel.start(data);
        core::DeviceStatus status;
        for (bool ended = false; !ended && !interrupted() && !rows.failed();) {
            status = channel.status();
            ended = status.state == core::DeviceState::finished || status.state == core::DeviceState::lost;
            // Once more after the end: what was delivered before it.
            if (!ended)
                data.waitFor(kIdle);
            channel.process();
            pipeline::FeatureSample sample;
            while (channel.popSample(sample)) {
                writeFeatures(rows, sample.sourceTime_s, sample.features, vectors);
                rows.endRow();
            }
            rows.flushIfDue();
            progress.update(static_cast<double>(channel.framesProcessed()),
                            static_cast<double>(channel.playback()->position().frames));
        }
        channel.stop();
        progress.erase();
        if (channel.samplesNotShown() > 0) {
            rows.flush();
            return core::failed(core::ErrorKind::ioFailed,
                                ReplayText::tr("%n frame(s) were not printed", nullptr,
                                               static_cast<int>(channel.samplesNotShown())),
                                {}, {m_path});
        }
        return finish(rows, array, status, status.framesLost);
    }

    std::string m_path;
    std::string m_stream;
    std::optional<double> m_speed;
    std::optional<double> m_threshold;
    RowOptions m_output;
};

} // namespace

Command replayCommand() {
    return makeCommand<ReplayCommand>("replay",
                                      ReplayText::tr("Play a recording through the processing of a device "
                                                     "and print its features, or a camera's contacts"),
                                      "teleta simulate tactile-indenter --out run\n"
                                      "  teleta replay run/recording.teleta --out features.csv");
}

} // namespace teleta::cli
