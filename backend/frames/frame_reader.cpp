// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/frame_reader.h"

#include "backend/core/data/file_kind.h"
#include "backend/core/failure.h"
#include "backend/frames/arrays/file_apart.h"
#include "backend/frames/arrays/hdf5_file.h"
#include "backend/frames/arrays/mat_file.h"
#include "backend/frames/arrays/numpy_file.h"
#include "backend/frames/table_file.h"
#include "backend/frames/tekscan_file.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <new>
#include <utility>

namespace teleta::frames {

namespace {

struct FrameReaderText {
    Q_DECLARE_TR_FUNCTIONS(FrameReaderText)
};

using core::FileKind;

/// Whether the content can be looked at before it is read: pipes are for our own tables only.
bool isPipe(const std::string& path) {
    const QFileInfo info(QString::fromStdString(path));
    return info.exists() && !info.isFile() && !info.isDir();
}

/// Null: a file of this kind has no arrays.
core::Expected<std::unique_ptr<ArrayFile>> openArrays(FileKind kind, const std::string& path) {
    switch (kind) {
    case FileKind::npy:
        return openNpy(path);
    case FileKind::zip:
        return openNpz(path);
    case FileKind::hdf5:
        return openApart(path, openHdf5);
    case FileKind::matlab:
    case FileKind::matlab7:
        return openApart(path, openMat);
    default:
        return std::unique_ptr<ArrayFile>();
    }
}

/// All files but our own tables.
core::Expected<FrameSeries> load(FileKind kind, const FrameRequest& request, const GoOn& goOn) {
    TELETA_TRY(const auto arrays, openArrays(kind, request.path));
    if (arrays)
        return framesOf(*arrays, request, goOn);
    if (kind != FileKind::text)
        return core::failed(
            core::ErrorKind::badInput, FrameReaderText::tr("the file is %1").arg(describe(kind)),
            FrameReaderText::tr("frames as CSV, npy, npz, HDF5, MAT, or Tekscan ASCII"), {request.path});
    if (!isTekscan(request.path))
        return readTable(request, goOn);
    if (request.known)
        return core::failed(core::ErrorKind::badInput,
                            FrameReaderText::tr("the file says itself where its taxels are"),
                            FrameReaderText::tr("no layout"), {request.path});
    return readTekscan(request, goOn);
}

core::Expected<FrameSeries> loadWithinMemory(FileKind kind, const FrameRequest& request, const GoOn& goOn) {
    try {
        return load(kind, request, goOn);
    } catch (const std::bad_alloc&) {
        return core::failed(core::ErrorKind::badInput,
                            FrameReaderText::tr("the frames do not fit into the memory"), {}, {request.path});
    }
}

/// Whether a text is read as a whole: it is no table of our own, or the request says how to read it.
core::Expected<bool> isForeign(const FrameRequest& request) {
    if (isTekscan(request.path) || !request.taxelColumns.empty() || !request.timeColumn.empty() ||
        !request.timeUnit.empty())
        return true;
    if (!request.rate_Hz)
        return false;
    if (core::FrameFile::countTaxels(request.path))
        return core::failed(core::ErrorKind::badInput,
                            FrameReaderText::tr("the file has times of its own, in time_s"),
                            FrameReaderText::tr("no rate"), {request.path});
    return true;
}

/// The error of a table that is not our own, with what to say so that it is read.
core::Unexpected withOptions(core::Error error, const std::string& path, bool isPipe) {
    if (isPipe || error.kind != core::ErrorKind::badInput || core::FrameFile::countTaxels(path))
        return core::Unexpected(std::move(error));
    const QString options = tableOptions(path);
    if (!options.isEmpty())
        error.expected =
            FrameReaderText::tr("%1; of a table of another program, which columns are times and taxels (%2)")
                .arg(QString::fromStdString(error.expected), options)
                .toStdString();
    return core::Unexpected(std::move(error));
}

core::ArrayLayout rowOf(std::size_t values) {
    return {1, static_cast<int>(values)};
}

/// Puts the numbers of each frame into the order of the known array.
core::Expected<void> place(FrameSeries& series, const FrameRequest& request) {
    const KnownArray& known = *request.known;
    const std::size_t values = known.layout.values();
    if (!series.isPlaced) {
        if (values * series.frames() > kMostValues)
            return core::failed(core::ErrorKind::badInput, FrameReaderText::tr("the recording is too long"),
                                FrameReaderText::tr("at most %1 values").arg(kMostValues), {request.path});
        std::vector<float> placed(values * series.frames());
        for (std::size_t i = 0; i < series.frames(); ++i)
            known.place(series.frame(i), std::span(placed).subspan(i * values, values));
        series.values = std::move(placed);
    }
    series.layout = rowOf(values);
    series.isPlaced = true;
    series.hasPitch = true;
    if (series.unit.empty())
        series.unit = known.unit;
    return {};
}

/// "run.h5:/group/dataset" names the array of a file, unless there is a file of that name.
FrameRequest withArrayOf(FrameRequest request) {
    const std::size_t colon = request.path.rfind(":/");
    if (!request.array.empty() || colon == std::string::npos ||
        QFileInfo::exists(QString::fromStdString(request.path)) ||
        !QFileInfo(QString::fromStdString(request.path.substr(0, colon))).isFile())
        return request;
    request.array = request.path.substr(colon + 1);
    request.path.resize(colon);
    return request;
}

} // namespace

std::vector<std::string> arraysIn(const std::string& path) {
    if (isPipe(path))
        return {};
    const auto kind = core::fileKind(path);
    if (!kind)
        return {};
    const auto arrays = openArrays(*kind, path);
    return arrays && *arrays ? namesOfFrames(**arrays) : std::vector<std::string>();
}

core::Expected<FrameReader> FrameReader::open(const FrameRequest& given, const GoOn& goOn) {
    const FrameRequest request = withArrayOf(given);
    const bool fromPipe = isPipe(request.path);
    FileKind kind = FileKind::text;
    if (!fromPipe) {
        TELETA_TRY(kind, core::fileKind(request.path));
    }
    bool isLoaded = kind != FileKind::text;
    if (!isLoaded && !fromPipe) {
        TELETA_TRY(isLoaded, isForeign(request));
    }
    if (isLoaded) {
        TELETA_TRY(FrameSeries series, loadWithinMemory(kind, request, goOn));
        if (request.known)
            TELETA_CHECK(place(series, request));
        FrameReader reader{Loaded{std::move(series)}};
        const FrameSeries& read = std::get<Loaded>(reader.m_source).series;
        reader.m_layout = read.layout;
        reader.m_taxels = request.known ? request.known->layout : core::TaxelLayout(read.layout);
        reader.m_hasPitch = read.hasPitch;
        reader.m_unit = read.unit;
        reader.m_unused = read.unused;
        return reader;
    }
    if (request.known) {
        const core::TaxelLayout& known = request.known->layout;
        core::Expected<core::FrameFile> file =
            core::FrameFile::open(request.path, rowOf(known.values()), known.components());
        if (!file)
            return withOptions(file.error(), request.path, fromPipe);
        FrameReader reader{*std::move(file)};
        reader.m_layout = rowOf(known.values());
        reader.m_taxels = known;
        reader.m_hasPitch = true;
        reader.m_unit = request.known->unit;
        return reader;
    }
    core::ArrayLayout layout;
    if (request.guessesShape && !request.rows && !request.columns) {
        const core::Expected<std::size_t> taxels = core::FrameFile::countTaxels(request.path);
        if (!taxels)
            return withOptions(taxels.error(), request.path, fromPipe);
        TELETA_TRY(layout, layoutOf(request, *taxels, FrameReaderText::tr("the file")));
    }
    layout.rows = request.rows.value_or(layout.rows);
    layout.columns = request.columns.value_or(layout.columns);
    layout.setPitch_m(request.pitch_m.value_or(layout.pitchX_m));
    core::Expected<core::FrameFile> file = core::FrameFile::open(request.path, layout);
    if (!file)
        return withOptions(file.error(), request.path, fromPipe);
    FrameReader reader{*std::move(file)};
    reader.m_layout = layout;
    reader.m_taxels = layout;
    reader.m_hasPitch = request.pitch_m.has_value();
    return reader;
}

core::Expected<bool> FrameReader::next(double& time_s, std::span<float> values) {
    if (auto* file = std::get_if<core::FrameFile>(&m_source))
        return file->next(time_s, values);
    auto& loaded = std::get<Loaded>(m_source);
    if (loaded.next == loaded.series.frames())
        return false;
    time_s = loaded.series.time_s[loaded.next];
    std::ranges::copy(loaded.series.frame(loaded.next), values.begin());
    ++loaded.next;
    return true;
}

std::uint64_t FrameReader::bytesRead() const {
    if (const auto* file = std::get_if<core::FrameFile>(&m_source))
        return file->offset();
    const auto& loaded = std::get<Loaded>(m_source);
    return loaded.next * m_taxels.values() * sizeof(float);
}

std::uint64_t FrameReader::bytesTotal() const {
    if (const auto* file = std::get_if<core::FrameFile>(&m_source))
        return file->bytesTotal();
    return std::get<Loaded>(m_source).series.values.size() * sizeof(float);
}

core::Expected<FrameSeries> readFrames(const FrameRequest& request, const GoOn& goOn) {
    TELETA_TRY(FrameReader reader, FrameReader::open(request, goOn));
    if (auto* loaded = std::get_if<FrameReader::Loaded>(&reader.m_source))
        return std::move(loaded->series);
    FrameSeries series;
    series.layout = reader.layout();
    series.hasPitch = reader.hasPitch();
    series.unit = reader.unit();
    series.isPlaced = request.known.has_value();
    std::vector<float> frame(reader.taxels().values());
    for (double time_s = 0.0;;) {
        TELETA_TRY(const bool any, reader.next(time_s, frame));
        if (!any)
            return series;
        if (goOn && !goOn())
            return core::Unexpected(core::Error{core::ErrorKind::cancelled, {}, {}, {}});
        series.time_s.push_back(time_s);
        series.values.insert(series.values.end(), frame.begin(), frame.end());
    }
}

} // namespace teleta::frames
