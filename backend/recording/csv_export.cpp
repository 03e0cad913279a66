// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/recording/csv_export.h"

#include "backend/core/data/csv_writer.h"
#include "backend/core/data/output_file.h"
#include "backend/core/failure.h"
#include "backend/core/number_text.h"
#include "backend/recording/export_description.h"
#include "backend/recording/stream_columns.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace teleta::recording {

namespace {

struct CsvExportText {
    Q_DECLARE_TR_FUNCTIONS(RecordingExport)
};

/// Of the four-joint arm, the last joint: its torque tells an object's stiffness.
constexpr std::size_t kElbow = 3;

bool hasElbow(const StreamInfo& stream) {
    return jointsOf(stream) == kElbow + 1;
}

std::vector<std::string> columnNames(const StreamInfo& stream) {
    std::vector<std::string> names{"time_s"};
    if (stream.kind == StreamKind::camera) {
        names.insert(names.end(), {"frame_time_s", "width_px", "height_px"});
        return names;
    }
    if (hasElbow(stream))
        names.insert(names.end(), {"joint_angle_rad", "joint_torque_nm"});
    for (const Column& column : stream.columns)
        names.push_back(column.name);
    for (std::size_t i = 0; stream.columns.empty() && i < stream.channels(); ++i)
        names.push_back(std::string("t").append(core::NumberText(i).view()));
    return names;
}

template <typename Number>
void writeNumbers(core::CsvWriter& csv, std::span<const Number> values) {
    for (const Number value : values)
        csv.number(value);
}

void writeFeatures(core::CsvWriter& csv, std::span<const double> values) {
    const double type = values.front();
    const bool known = type >= 0.0 && type < static_cast<double>(kContactTypes.size());
    csv.text(known ? kContactTypes[static_cast<std::size_t>(type)] : "NA");
    writeNumbers(csv, values.subspan(1));
}

void writeFrame(core::CsvWriter& csv, const StreamInfo& stream, const core::TappedFrames& block,
                std::size_t frame) {
    const std::size_t channels = stream.channels();
    if (stream.kind == StreamKind::camera) {
        csv.number(block.sourceTime_s[frame]);
        csv.integer(isColour(stream) ? block.image.width_px / 3 : block.image.width_px);
        csv.integer(block.image.height_px);
    } else if (stream.type == ValueType::float32) {
        writeNumbers(csv, valuesOf<float>(block, frame, channels));
    } else {
        const auto values = valuesOf<double>(block, frame, channels);
        if (hasElbow(stream)) {
            csv.number(values[kElbow]);
            csv.number(values[kElbow + 1 + kElbow]);
        }
        if (stream.kind == StreamKind::features && channels > 0)
            writeFeatures(csv, values);
        else
            writeNumbers(csv, values);
    }
}

/// All rows are written; finish() gives the file its name.
struct WrittenFile {
    DescribedTable table;
    core::CsvWriter csv;
};

core::Expected<core::CsvWriter> createTable(DescribedTable& table, bool utc) {
    if (utc)
        table.columns.emplace_back("utc_s");
    const std::vector<std::string_view> columns(table.columns.begin(), table.columns.end());
    return core::CsvWriter::create(table.path, columns);
}

core::Expected<WrittenFile> exportEvents(const Recording& recording, const std::string& path, bool utc) {
    DescribedTable table{.path = path,
                         .columns = {"time_s", "utc", "event", "text", "value"},
                         .rows = recording.events().size()};
    TELETA_TRY(auto csv, createTable(table, utc));
    for (const RecordingEvent& event : recording.events()) {
        csv.number(recording.time_s(event.time_ns));
        csv.text(recording.utcOf(event.time_ns).toString(Qt::ISODateWithMs).toStdString());
        csv.text(event.kind);
        csv.text(event.text);
        csv.number(event.value);
        if (utc)
            csv.text(unixSeconds(recording, event.time_ns));
        csv.endRow();
    }
    return WrittenFile{std::move(table), std::move(csv)};
}

/// Counts frames over all streams.
class Progress {
public:
    Progress(const Recording& recording, const ExportOptions& options)
        : m_options(options) {
        for (std::size_t i = 0; options.goOn && i < recording.streams().size(); ++i) {
            if (const auto extent = recording.extent(i); extent && *extent)
                m_all += static_cast<double>((*extent)->frames);
        }
    }
    void add(std::size_t frames) {
        m_done += static_cast<double>(frames);
        m_stopped = m_stopped || (m_options.goOn && !m_options.goOn(m_done, m_all));
    }
    [[nodiscard]] bool stopped() const { return m_stopped; }
    /// Asks once more, without new frames.
    [[nodiscard]] bool goesOn() {
        add(0);
        return !m_stopped;
    }

private:
    const ExportOptions& m_options;
    double m_done = 0.0;
    double m_all = 0.0;
    bool m_stopped = false;
};

core::Expected<WrittenFile> exportStream(const Recording& recording, std::size_t index,
                                         const std::string& path, bool utc, Progress& progress) {
    const StreamInfo& stream = recording.streams()[index];
    DescribedTable table{.path = path, .stream = &stream, .columns = columnNames(stream)};
    TELETA_TRY(auto csv, createTable(table, utc));
    StreamReader reader = recording.reader(index);
    core::TappedFrames block;
    while (!csv.failed() && !progress.stopped()) {
        const core::Expected<bool> any = reader.next(block);
        if (!any && any.error().kind != core::ErrorKind::badInput)
            return core::Unexpected(any.error());
        if (!any) {
            // Where not even the index can be read the stream ends.
            ++table.damagedBlocks;
            if (!reader.canGoOn())
                break;
            progress.add(0);
            continue;
        }
        if (!*any)
            break;
        for (std::size_t frame = 0; frame < block.frames(); ++frame) {
            csv.number(recording.time_s(block.time_ns[frame]));
            writeFrame(csv, stream, block, frame);
            if (utc)
                csv.text(unixSeconds(recording, block.time_ns[frame]));
            csv.endRow();
        }
        table.rows += block.frames();
        progress.add(block.frames());
    }
    if (csv.failed())
        return core::Unexpected(csv.finish().error());
    return WrittenFile{std::move(table), std::move(csv)};
}

/// The name of a stream as that of a file.
std::string fileName(const std::string& stream) {
    std::string name = stream;
    std::ranges::replace_if(
        name, [](char c) { return c == '/' || c == '\\' || static_cast<unsigned char>(c) < ' '; }, '_');
    return name.empty() || name.front() == '.' ? "_" + name : name;
}

constexpr char kEvents[] = "events";

/// The files of the streams, in their order, that of the events, and recording.json.
std::vector<std::string> filePaths(const Recording& recording, const std::string& folder) {
    // Some file systems ignore case.
    std::set<QString> taken{QString::fromLatin1(kEvents)};
    std::vector<std::string> paths;
    for (const StreamInfo& stream : recording.streams()) {
        const std::string wanted = fileName(stream.name);
        std::string name = wanted;
        for (int number = 2; !taken.insert(QString::fromStdString(name).toLower()).second; ++number)
            name = wanted + "-" + std::to_string(number);
        paths.push_back(folder + "/" + name + ".csv");
    }
    paths.push_back(folder + "/" + kEvents + ".csv");
    paths.push_back(folder + "/recording.json");
    return paths;
}

core::Expected<std::vector<WrittenFile>> writeAll(const Recording& recording,
                                                  const std::vector<std::string>& paths,
                                                  const ExportOptions& options, Progress& progress) {
    std::vector<WrittenFile> files;
    for (std::size_t i = 0; i < recording.streams().size(); ++i) {
        TELETA_TRY(auto file, exportStream(recording, i, paths[i], options.utc, progress));
        if (progress.stopped() && !options.finishesWhenEnded)
            return core::failed(core::ErrorKind::cancelled,
                                CsvExportText::tr("interrupted; nothing was written"), {},
                                {recording.path()});
        files.push_back(std::move(file));
        if (progress.stopped())
            break;
    }
    TELETA_TRY(auto events, exportEvents(recording, paths[recording.streams().size()], options.utc));
    files.push_back(std::move(events));
    return files;
}

} // namespace

core::Expected<std::vector<ExportedFile>> exportCsv(const Recording& recording, const std::string& folder,
                                                    const ExportOptions& options) {
    const QString path = QString::fromStdString(folder);
    const bool isNew = !QFileInfo::exists(path);
    if (!QDir().mkpath(path) || !QFileInfo(path).isWritable())
        return core::failed(core::ErrorKind::ioFailed,
                            CsvExportText::tr("the folder cannot be created or written to"), {}, {folder});
    const std::vector<std::string> paths = filePaths(recording, folder);
    const auto there = std::ranges::find_if(
        paths, [](const std::string& file) { return QFileInfo::exists(QString::fromStdString(file)); });
    if (!options.overwrite && there != paths.end())
        return core::failed(core::ErrorKind::refused, CsvExportText::tr("a file of this name already exists"),
                            CsvExportText::tr("another folder"), {*there});
    std::vector<ExportedFile> files;
    const auto leaveNothing = [&](const core::Error& error) {
        for (const ExportedFile& file : files)
            QFile::remove(QString::fromStdString(file.path));
        if (isNew)
            QDir().rmdir(path);
        return core::Unexpected(error);
    };
    Progress progress(recording, options);
    auto written = writeAll(recording, paths, options, progress);
    if (!written)
        return leaveNothing(written.error());
    std::vector<DescribedTable> tables;
    for (WrittenFile& each : *written) {
        if (const core::Expected<void> done = each.csv.finish(); !done) {
            written->clear(); // with what has no name yet
            return leaveNothing(done.error());
        }
        files.push_back({each.table.path, each.table.rows, each.table.damagedBlocks});
        tables.push_back(std::move(each.table));
    }
    const auto described = exportDescription(recording, tables, [&progress] { return progress.goesOn(); });
    if (!described)
        return leaveNothing(described.error());
    if (const auto done = core::writeFile(paths.back(), *described); !done)
        return leaveNothing(done.error());
    files.push_back({paths.back(), 0, 0});
    return files;
}

} // namespace teleta::recording
