// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/equilibration/load_calibration_file.h"

#include "backend/core/data/csv_number.h"
#include "backend/core/data/csv_reader.h"
#include "backend/core/data/csv_writer.h"
#include "backend/core/data/output_file.h"
#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace teleta::equilibration {

namespace {

struct LoadFileText {
    Q_DECLARE_TR_FUNCTIONS(LoadCalibrationFile)
};

constexpr std::size_t kNumbers = 6; ///< of a row

struct Row {
    std::size_t load = 0, signal = 0;
    std::array<double, kNumbers> numbers{}; ///< gain, gain_se, rest, least, greatest, scatter
};

QString text(std::string_view word) {
    return QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size())).left(40);
}

QString loadNames() {
    QStringList names;
    for (const std::string_view name : kLoadColumns)
        names << text(name);
    return names.join(QStringLiteral(", "));
}

std::size_t numberOf(std::string_view name, std::vector<std::string>& names) {
    const auto known = std::ranges::find(names, name);
    const auto number = static_cast<std::size_t>(known - names.begin());
    if (known == names.end())
        names.emplace_back(name);
    return number;
}

/// The first ones, if they are many.
QString signalNames(const std::vector<std::string>& known) {
    constexpr std::size_t kShown = 24;
    QStringList names;
    for (std::size_t i = 0; i < std::min(known.size(), kShown); ++i)
        names << text(known[i]);
    return names.join(QStringLiteral(", ")) +
           (known.size() > kShown ? QStringLiteral(" \u2026 ") + text(known.back()) : QString());
}

core::Expected<Row> rowOf(const core::CsvReader& csv, const std::vector<std::size_t>& columns,
                          const std::vector<std::string_view>& fields, const std::vector<std::string>& known,
                          LoadCalibration& calibration) {
    Row row;
    if (std::ranges::find(kLoadColumns, fields[columns[0]]) == kLoadColumns.end())
        return core::failed(core::ErrorKind::badInput,
                            LoadFileText::tr("\"%1\" is no load").arg(text(fields[columns[0]])), loadNames(),
                            csv.place(columns[0]));
    if (fields[columns[1]].empty())
        return core::failed(core::ErrorKind::badInput, LoadFileText::tr("the signal has no name"), {},
                            csv.place(columns[1]));
    if (!known.empty() && std::ranges::find(known, fields[columns[1]]) == known.end())
        return core::failed(core::ErrorKind::badInput,
                            LoadFileText::tr("the source has no signal \"%1\"").arg(text(fields[columns[1]])),
                            LoadFileText::tr("one of %1").arg(signalNames(known)), csv.place(columns[1]));
    row.load = numberOf(fields[columns[0]], calibration.loads);
    row.signal = numberOf(fields[columns[1]], calibration.channels);
    for (std::size_t i = 0; i < kNumbers; ++i) {
        const std::optional<double> number = core::numberOrNA(fields[columns[i + 2]]);
        if (!number || !std::isfinite(*number))
            return core::failed(core::ErrorKind::badInput,
                                LoadFileText::tr("\"%1\" is no number").arg(text(fields[columns[i + 2]])), {},
                                csv.place(columns[i + 2]));
        row.numbers[i] = *number;
    }
    for (const std::size_t i : {std::size_t{1}, std::size_t{5}}) {
        if (row.numbers[i] < 0.0)
            return core::failed(core::ErrorKind::badInput,
                                LoadFileText::tr("an error or a scatter is below 0"), {},
                                csv.place(columns[i + 2]));
    }
    if (row.numbers[3] > row.numbers[4])
        return core::failed(core::ErrorKind::badInput, LoadFileText::tr("least is above greatest"), {},
                            csv.place(columns[5]));
    return row;
}

} // namespace

core::Expected<KnownPresses> readKnownPresses(const std::string& path,
                                              const std::vector<std::string>& channels) {
    TELETA_TRY(auto csv, core::CsvReader::open(path));
    KnownPresses presses;
    presses.channels = channels;
    std::vector<std::string_view> names;
    for (const std::string_view load : kLoadColumns) {
        if (std::ranges::find(csv.header(), load) == csv.header().end())
            continue;
        presses.loads.emplace_back(load);
        names.push_back(load);
    }
    if (presses.loads.empty())
        return core::failed(core::ErrorKind::badInput, LoadFileText::tr("there is no column with a load"),
                            LoadFileText::tr("one of %1").arg(loadNames()), csv.place(0));
    names.insert(names.end(), channels.begin(), channels.end());
    TELETA_TRY(const auto columns, csv.columns(names));
    std::vector<double> values;
    std::vector<std::string_view> fields;
    Eigen::Index rows = 0;
    for (;;) {
        TELETA_TRY(const bool any, csv.nextText(fields));
        if (!any)
            break;
        for (const std::size_t column : columns) {
            const std::optional<double> number = core::numberOrNA(fields[column]);
            if (!number || !std::isfinite(*number))
                return core::failed(core::ErrorKind::badInput,
                                    LoadFileText::tr("\"%1\" is no number").arg(text(fields[column])), {},
                                    csv.place(column));
            values.push_back(*number);
        }
        ++rows;
    }
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::Map<const RowMajor> table(values.data(), rows, static_cast<Eigen::Index>(columns.size()));
    presses.load = table.leftCols(static_cast<Eigen::Index>(presses.loads.size()));
    presses.signal = table.rightCols(static_cast<Eigen::Index>(channels.size()));
    return presses;
}

core::Expected<LoadCalibration> readLoadCalibration(const std::string& path,
                                                    const std::vector<std::string>& known) {
    TELETA_TRY(auto csv, core::CsvReader::open(path));
    TELETA_TRY(const auto columns, csv.columns(kLoadCalibrationColumns));
    LoadCalibration calibration;
    std::vector<Row> rows;
    std::vector<std::string_view> fields;
    for (;;) {
        TELETA_TRY(const bool any, csv.nextText(fields));
        if (!any)
            break;
        TELETA_TRY(const Row row, rowOf(csv, columns, fields, known, calibration));
        for (const Row& other : rows) {
            if (other.load == row.load && other.numbers.back() != row.numbers.back())
                return core::failed(core::ErrorKind::badInput,
                                    LoadFileText::tr("the scatter of this load differs from another row"), {},
                                    csv.place(columns[7]));
            if (other.signal != row.signal)
                continue;
            if (other.load == row.load)
                return core::failed(core::ErrorKind::badInput,
                                    LoadFileText::tr("this load and signal are listed twice"), {},
                                    csv.place(columns[0]));
            if (!std::equal(row.numbers.begin() + 2, row.numbers.end() - 1, other.numbers.begin() + 2))
                return core::failed(core::ErrorKind::badInput,
                                    LoadFileText::tr("rest and range of this signal differ from another row"),
                                    {}, csv.place(columns[4]));
        }
        rows.push_back(row);
    }
    const auto loads = static_cast<Eigen::Index>(calibration.loads.size());
    const auto channels = static_cast<Eigen::Index>(calibration.channels.size());
    if (rows.empty() || rows.size() != calibration.loads.size() * calibration.channels.size())
        return core::failed(core::ErrorKind::badInput, LoadFileText::tr("rows are missing"),
                            LoadFileText::tr("one for each load and signal"), {path, csv.nextLine(), 1});
    calibration.gain = calibration.error = Eigen::MatrixXd::Zero(loads, channels);
    calibration.rest = calibration.least = calibration.greatest = Eigen::VectorXd::Zero(channels);
    calibration.scatter = Eigen::VectorXd::Zero(loads);
    for (const Row& row : rows) {
        const auto load = static_cast<Eigen::Index>(row.load);
        const auto signal = static_cast<Eigen::Index>(row.signal);
        calibration.gain(load, signal) = row.numbers[0];
        calibration.error(load, signal) = row.numbers[1];
        calibration.rest[signal] = row.numbers[2];
        calibration.least[signal] = row.numbers[3];
        calibration.greatest[signal] = row.numbers[4];
        calibration.scatter[load] = row.numbers[5];
    }
    return calibration;
}

core::Expected<void> writeLoadCalibration(const LoadCalibration& calibration, const std::string& path) {
    TELETA_CHECK(core::makeFolder(QFileInfo(QString::fromStdString(path)).absolutePath().toStdString()));
    TELETA_TRY(auto csv, core::CsvWriter::create(path, kLoadCalibrationColumns));
    writeLoadCalibrationRows(calibration, csv);
    return csv.finish();
}

} // namespace teleta::equilibration
