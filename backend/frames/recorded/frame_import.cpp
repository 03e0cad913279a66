// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/recorded/frame_import.h"

#include "backend/core/data/array_guess.h"
#include "backend/core/device/stream_tap.h"
#include "backend/core/failure.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/recording/new_recording.h"
#include "backend/recording/recording_writer.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QTimeZone>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace teleta::frames {

namespace {

struct FrameImportText {
    Q_DECLARE_TR_FUNCTIONS(FrameImportText)
};

using recording::RecordingWriter;

constexpr std::size_t kFramesInBlock = 256;
constexpr std::size_t kBytesInBlock = std::size_t{1} << 20U;
constexpr std::size_t kBytesInCommit = std::size_t{8} << 20U;
constexpr double kYear2000_s = 946'684'800.0;
constexpr double kYear2100_s = 4'102'444'800.0;
/// The steady clock cannot count longer.
constexpr double kLongest_s = 9e9;
constexpr double kYear_s = 365.25 * 86'400.0;

std::vector<recording::TimeAnchor> anchorsOf(double first_s) {
    if (first_s < kYear2000_s || first_s > kYear2100_s)
        return {};
    return {{0, QDateTime::fromMSecsSinceEpoch(std::llround(first_s * 1e3), QTimeZone::utc())}};
}

/// The frames on their way into a recording.
class Import {
public:
    Import(FrameReader& frames, const std::string& file, const FrameImportOptions& options)
        : m_frames(frames)
        , m_options(options)
        , m_file(QString::fromStdString(file))
        , m_row(frames.taxels().values()) {}

    [[nodiscard]] core::Expected<FrameImport> into(const std::string& part) {
        // The first ones tell the rate of the stream.
        TELETA_CHECK(readBlock());
        RecordingWriter writer(part, anchorsOf(m_first_s));
        TELETA_CHECK(writer.begin(head()));
        const recording::StreamInfo stream = streamOf();
        TELETA_CHECK(writer.addStream(stream));
        while (m_block.frames() > 0) {
            writer.take(0, std::exchange(m_block, {}));
            if (writer.waitingBytes() >= kBytesInCommit)
                TELETA_CHECK(writer.commit());
            if (m_options.goOn && !m_options.goOn(share()))
                return core::failed(core::ErrorKind::cancelled, FrameImportText::tr("interrupted"));
            TELETA_CHECK(readBlock());
        }
        writer.take({.time_ns = writer.newest_ns(), .kind = recording::kStopped, .text = {}});
        TELETA_CHECK(writer.commit());
        TELETA_CHECK(writer.finish());
        return FrameImport{{}, stream.name, m_frames.taxels(), writer.frames(), rate(writer.frames())};
    }

private:
    [[nodiscard]] double share() const {
        const auto total = static_cast<double>(m_frames.bytesTotal());
        return total > 0.0 ? std::min(1.0, static_cast<double>(m_frames.bytesRead()) / total) : 0.0;
    }
    [[nodiscard]] double rate(std::uint64_t frames) const {
        const double span_s = m_last_s - m_first_s;
        return frames > 1 && span_s > 0.0 ? static_cast<double>(frames - 1) / span_s : 0.0;
    }

    /// The next frames into m_block, which is empty; none are left: it stays so.
    [[nodiscard]] core::Expected<void> readBlock() {
        while (m_block.frames() < kFramesInBlock && m_block.values.size() < kBytesInBlock) {
            double time_s = 0.0;
            TELETA_TRY(const bool any, m_frames.next(time_s, m_row));
            if (!any)
                return {};
            if (!m_begun)
                m_first_s = time_s;
            m_begun = true;
            m_last_s = time_s;
            const double since_s = time_s - m_first_s;
            if (!(since_s < kLongest_s))
                return core::failed(core::ErrorKind::badInput,
                                    FrameImportText::tr("the frames span more than %1 years")
                                        .arg(static_cast<int>(kLongest_s / kYear_s)),
                                    FrameImportText::tr("times in seconds, or their unit (--time-unit UNIT)"),
                                    {m_file.toStdString()});
            m_block.time_ns.push_back(std::llround(since_s * 1e9));
            m_block.sourceTime_s.push_back(since_s);
            const auto bytes = std::as_bytes(std::span(m_row));
            m_block.values.insert(m_block.values.end(), bytes.begin(), bytes.end());
        }
        return {};
    }

    [[nodiscard]] recording::RecordingHead head() const {
        const nlohmann::ordered_json source{
            {"frames", {{"file", QFileInfo(m_file).fileName().toStdString()}}}};
        recording::RecordingHead head;
        head.appVersion = QCoreApplication::applicationVersion().toStdString();
        head.configuration = source.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
        return head;
    }

    [[nodiscard]] recording::StreamInfo streamOf() const {
        core::SourceDescription array;
        array.name =
            m_options.name.empty() ? QFileInfo(m_file).completeBaseName().toStdString() : m_options.name;
        array.layout = m_frames.taxels();
        array.unit = m_frames.unit();
        array.nominalRate_Hz = rate(m_block.frames());
        pipeline::ChannelSettings settings = m_options.settings;
        if (settings.loadUnit.empty())
            settings.loadUnit =
                array.unit.empty() ? core::guessArray(array.layout.taxels()).unit : array.unit;
        return pipeline::arrayStream(pipeline::framesStreamName(array.name), array, settings);
    }

    FrameReader& m_frames;
    const FrameImportOptions& m_options;
    QString m_file;
    std::vector<float> m_row;
    core::TappedFrames m_block;
    bool m_begun = false;
    double m_first_s = 0.0;
    double m_last_s = 0.0;
};

} // namespace

core::Expected<FrameImport> importFrames(FrameReader frames, const std::string& file,
                                         const std::string& recording, const FrameImportOptions& options) {
    FrameImport made;
    TELETA_CHECK(recording::makeRecording(recording, [&](const std::string& part) -> core::Expected<void> {
        TELETA_TRY(made, Import(frames, file, options).into(part));
        return {};
    }));
    made.path = recording;
    return made;
}

} // namespace teleta::frames
