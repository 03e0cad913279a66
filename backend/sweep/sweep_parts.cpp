// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/sweep/sweep_parts.h"

#include "backend/core/data/csv_number.h"
#include "backend/core/data/csv_reader.h"
#include "backend/core/data/csv_writer.h"
#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QString>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <unistd.h>

namespace teleta::sweep {

namespace {

constexpr std::array<std::string_view, 5> kRunColumns{"run", "status", "reason", "wall_s", "processor_s"};

struct SweepPartsText {
    Q_DECLARE_TR_FUNCTIONS(SweepParts)
};

QStringList partNames(const std::string& folder) {
    QStringList names = QDir(QString::fromStdString(folder + "/parts"))
                            .entryList({QStringLiteral("*.csv")}, QDir::Files, QDir::NoSort);
    // Numbers of four digits come before those of five.
    std::ranges::sort(names, [](const QString& a, const QString& b) {
        return a.size() != b.size() ? a.size() < b.size() : a < b;
    });
    return names;
}

/// Takes the first number that nobody has by making an empty file of its name.
core::Expected<std::string> takeNumber(const std::string& folder) {
    const QStringList names = partNames(folder);
    unsigned long long next = names.isEmpty() ? 0 : QFileInfo(names.back()).baseName().toULongLong() + 1;
    for (;; ++next) {
        const std::string number = partName(next);
        const std::string path = folder + "/parts/" + number + ".csv";
        const int file = ::open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
        if (file >= 0) {
            ::close(file);
            return number;
        }
        if (errno != EEXIST)
            return core::failed(core::ErrorKind::ioFailed,
                                SweepPartsText::tr("the file cannot be made: %1")
                                    .arg(QString::fromLocal8Bit(std::strerror(errno))),
                                {}, {path});
    }
}

core::Expected<void> readPart(const std::string& path, std::uint64_t number,
                              const std::function<void(RunRow&&)>& take, std::set<std::string>* columns) {
    TELETA_TRY(core::CsvReader reader, core::CsvReader::open(path));
    const std::vector<std::string>& header = reader.header();
    if (header.size() < kRunColumns.size() ||
        !std::equal(kRunColumns.begin(), kRunColumns.end(), header.begin()))
        return core::failed(core::ErrorKind::badInput, SweepPartsText::tr("this is no part of a sweep"),
                            QStringLiteral("run,status,reason,wall_s,processor_s"), {path, 1});
    if (columns != nullptr)
        columns->insert(header.begin() + kRunColumns.size(), header.end());
    std::vector<std::string_view> fields;
    for (;;) {
        TELETA_TRY(const bool more, reader.nextText(fields));
        if (!more)
            return {};
        RunRow row;
        std::uint64_t run = 0;
        const auto [end, error] = std::from_chars(fields[0].data(), fields[0].data() + fields[0].size(), run);
        const auto wall_s = core::numberOrNA(fields[3]);
        const auto processor_s = core::numberOrNA(fields[4]);
        if (error != std::errc() || end != fields[0].data() + fields[0].size() || !wall_s || !processor_s)
            return core::failed(core::ErrorKind::badInput, SweepPartsText::tr("this is no row of a sweep"),
                                SweepPartsText::tr("the number of a run and its times"), reader.place(0));
        row.run = run;
        row.part = number;
        row.wall_s = *wall_s;
        row.processor_s = *processor_s;
        if (fields[1] != "ok")
            row.reason = fields[2].empty() ? std::string("failed") : std::string(fields[2]);
        for (std::size_t i = kRunColumns.size(); i < fields.size(); ++i) {
            const auto value = core::numberOrNA(fields[i]);
            if (!value)
                return core::failed(core::ErrorKind::badInput, SweepPartsText::tr("this is no number"),
                                    SweepPartsText::tr("a number or NA"), reader.place(i));
            if (!std::isnan(*value))
                row.measures.emplace_back(header[i], *value);
        }
        take(std::move(row));
    }
}

} // namespace

std::string partName(std::uint64_t number) {
    return QStringLiteral("%1").arg(number, 4, 10, QLatin1Char('0')).toStdString();
}

core::Expected<std::string> PartWriter::number() {
    if (m_number.empty()) {
        TELETA_TRY(m_number, takeNumber(m_folder));
    }
    return m_number;
}

core::Expected<void> PartWriter::flush() {
    if (unwritten() == 0)
        return {};
    TELETA_TRY(const std::string own, number());
    std::ranges::sort(m_rows, {}, &RunRow::run);
    std::vector<std::string> measures;
    for (const RunRow& row : m_rows)
        for (const auto& [name, value] : row.measures)
            if (std::ranges::find(measures, name) == measures.end())
                measures.push_back(name);
    std::vector<std::string_view> columns(kRunColumns.begin(), kRunColumns.end());
    columns.insert(columns.end(), measures.begin(), measures.end());
    TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(m_folder + "/parts/" + own + ".csv", columns));
    std::vector<std::optional<double>> values(measures.size());
    for (const RunRow& row : m_rows) {
        std::ranges::fill(values, std::nullopt);
        for (const auto& [name, value] : row.measures)
            values[static_cast<std::size_t>(std::ranges::find(measures, name) - measures.begin())] = value;
        csv.row(row.run, row.failed() ? "failed" : "ok", row.reason, row.wall_s, row.processor_s, values);
    }
    TELETA_CHECK(csv.finish());
    m_written = m_rows.size();
    if (m_rows.size() >= kRowsOfPart)
        return close();
    return {};
}

core::Expected<void> PartWriter::close() {
    if (unwritten() > 0) {
        const std::size_t rows = m_rows.size();
        TELETA_CHECK(flush());
        if (rows >= kRowsOfPart)
            return {}; // closed by flush()
    }
    m_number.clear();
    m_rows.clear();
    m_written = 0;
    return {};
}

core::Expected<void> readParts(const std::string& folder, const std::function<void(RunRow&&)>& take,
                               std::set<std::string>* columns) {
    for (const QString& name : partNames(folder)) {
        const std::string path = folder + "/parts/" + name.toStdString();
        const QFileInfo info(QString::fromStdString(path));
        if (info.size() == 0)
            continue;
        TELETA_CHECK(readPart(path, info.baseName().toULongLong(), take, columns));
    }
    return {};
}

core::Expected<std::vector<bool>> finishedRuns(const std::string& folder, std::uint64_t runs) {
    std::vector<bool> finished(runs, false);
    std::uint64_t beyond = 0;
    TELETA_CHECK(readParts(folder, [&](RunRow&& row) {
        if (row.run < runs)
            finished[row.run] = true;
        else
            beyond = row.run;
    }));
    if (beyond > 0)
        return core::failed(core::ErrorKind::badInput,
                            SweepPartsText::tr("a part has the run %1").arg(beyond),
                            SweepPartsText::tr("runs from 0 to %1").arg(runs - 1), {folder + "/parts"});
    return finished;
}

} // namespace teleta::sweep
