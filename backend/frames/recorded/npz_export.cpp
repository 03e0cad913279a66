// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/recorded/npz_export.h"

#include "backend/core/device/stream_tap.h"
#include "backend/core/failure.h"
#include "backend/frames/arrays/array_file.h"
#include "backend/frames/npz_writer.h"
#include "backend/pipeline/recorded/recorded_streams.h"
#include "backend/recording/stream_columns.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>

#include <utility>
#include <vector>

namespace teleta::frames {

namespace {

struct NpzExportText {
    Q_DECLARE_TR_FUNCTIONS(NpzExportText)
};

using recording::Recording;
using recording::StreamInfo;
using recording::StreamKind;

core::Expected<std::size_t> chooseStream(const Recording& recording, const std::string& wanted) {
    QStringList arrays;
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < recording.streams().size(); ++i) {
        const StreamInfo& stream = recording.streams()[i];
        if (stream.kind != StreamKind::array || stream.type != recording::ValueType::float32)
            continue;
        arrays << QString::fromStdString(stream.name);
        if (wanted.empty() || wanted == stream.name)
            found = i;
    }
    const auto refuse = [&](const QString& message, const QString& expected) {
        return core::failed(core::ErrorKind::refused, message, expected, {recording.path()});
    };
    if (arrays.isEmpty())
        return refuse(NpzExportText::tr("the recording has no tactile array"),
                      NpzExportText::tr("frames of an array"));
    if (!found)
        return refuse(
            NpzExportText::tr("the recording has no array \"%1\"").arg(QString::fromStdString(wanted)),
            arrays.join(QStringLiteral(", ")));
    if (wanted.empty() && arrays.size() > 1)
        return refuse(
            NpzExportText::tr("the recording has several arrays"),
            NpzExportText::tr("one of them (--stream NAME): %1").arg(arrays.join(QStringLiteral(", "))));
    return *found;
}

/// Where the taxels of a stream stand: taxels x 3. Empty: on a grid of loads.
core::Expected<std::vector<double>> positionsOf(const StreamInfo& stream, const std::string& path) {
    std::vector<double> positions_m;
    if (stream.shape.size() == 2 && !recording::isVectorArray(stream))
        return positions_m;
    TELETA_TRY(const pipeline::RecordedArray array, pipeline::recordedArray(stream, path));
    const core::TaxelLayout& layout = array.description.layout;
    for (std::size_t i = 0; i < layout.taxels(); ++i)
        positions_m.insert(positions_m.end(),
                           {layout.x_m(i), layout.y_m(i), layout.isGrid() ? 0.0 : (*layout.places())[i].z_m});
    return positions_m;
}

} // namespace

core::Expected<NpzExport> exportNpz(const Recording& recording, const std::string& path,
                                    const NpzExportOptions& options) {
    if (!options.overwrite && QFileInfo::exists(QString::fromStdString(path)))
        return core::failed(core::ErrorKind::refused, NpzExportText::tr("a file of this name already exists"),
                            NpzExportText::tr("another name"), {path});
    TELETA_TRY(const std::size_t number, chooseStream(recording, options.stream));
    const StreamInfo& stream = recording.streams()[number];
    TELETA_TRY(const std::vector<double> positions_m, positionsOf(stream, recording.path()));
    const std::size_t taxels = stream.channels();
    double all = 0.0;
    if (const auto extent = recording.extent(number); extent && *extent)
        all = static_cast<double>((*extent)->frames);
    NpzExport written{.path = path, .stream = stream.name, .shape = {}};
    std::vector<double> time_s;
    std::vector<float> values;
    recording::StreamReader reader = recording.reader(number);
    core::TappedFrames block;
    for (;;) {
        if (options.goOn && !options.goOn(static_cast<double>(time_s.size()), all))
            return core::failed(core::ErrorKind::cancelled,
                                NpzExportText::tr("interrupted; nothing was written"), {},
                                {recording.path()});
        const core::Expected<bool> any = reader.next(block);
        if (!any && any.error().kind != core::ErrorKind::badInput)
            return core::Unexpected(any.error());
        if (!any) {
            ++written.damagedBlocks;
            if (!reader.canGoOn())
                break;
            continue;
        }
        if (!*any)
            break;
        if ((time_s.size() + block.frames()) * taxels > kMostValues)
            return core::failed(core::ErrorKind::refused, NpzExportText::tr("the recording is too long"),
                                NpzExportText::tr("at most %1 values").arg(kMostValues), {recording.path()});
        for (std::size_t frame = 0; frame < block.frames(); ++frame) {
            time_s.push_back(recording.time_s(block.time_ns[frame]));
            const auto frameValues = recording::valuesOf<float>(block, frame, taxels);
            values.insert(values.end(), frameValues.begin(), frameValues.end());
        }
    }
    written.shape = {time_s.size()};
    written.shape.insert(written.shape.end(), stream.shape.begin(), stream.shape.end());
    std::vector arrays{NpzArray("frames", written.shape, std::span<const float>(values)),
                       NpzArray("time_s", {time_s.size()}, std::span<const double>(time_s))};
    if (!positions_m.empty())
        arrays.emplace_back("positions_m", std::vector<std::uint64_t>{positions_m.size() / 3, 3},
                            std::span<const double>(positions_m));
    TELETA_CHECK(writeNpz(path, arrays));
    return written;
}

} // namespace teleta::frames
