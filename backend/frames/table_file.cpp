// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/table_file.h"

#include "backend/core/failure.h"
#include "backend/frames/text_lines.h"

#include <QCoreApplication>
#include <QDateTime>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace teleta::frames {

namespace {

struct TableText {
    Q_DECLARE_TR_FUNCTIONS(TableText)
};

constexpr std::size_t kMostTaxels = std::size_t{1} << 20U;

struct TimeUnit {
    std::string_view name;
    double s;
};
constexpr std::array kTimeUnits{TimeUnit{"s", 1.0}, TimeUnit{"ms", 1e-3}, TimeUnit{"us", 1e-6},
                                TimeUnit{"ns", 1e-9}};

/// Seconds since 1970 of a date and time as ISO 8601 has them; without a zone it is taken as UTC.
std::optional<double> isoSeconds(std::string_view field) {
    QString text = QString::fromUtf8(field.data(), static_cast<qsizetype>(field.size()));
    if (text.size() < 16 || text.size() > 40 || text[4] != QLatin1Char('-'))
        return std::nullopt;
    // Qt reads milliseconds only.
    double fraction_s = 0.0;
    if (const qsizetype dot = text.indexOf(QLatin1Char('.')); dot > 0) {
        qsizetype end = dot + 1;
        while (end < text.size() && text[end].isDigit())
            ++end;
        fraction_s = (QStringLiteral("0") + text.mid(dot, end - dot)).toDouble();
        text.remove(dot, end - dot);
    }
    QDateTime time = QDateTime::fromString(text, Qt::ISODate);
    if (!time.isValid())
        return std::nullopt;
    if (time.timeSpec() == Qt::LocalTime)
        time = QDateTime(time.date(), time.time(), Qt::UTC);
    return static_cast<double>(time.toSecsSinceEpoch()) + fraction_s;
}

/// How a table is written.
struct Dialect {
    char separator = ',';
    bool hasDecimalComma = false;
    std::vector<std::string> header; ///< empty: the first row is a frame
    std::size_t columns = 0;
    long long comments = 0; ///< lines before the header
    std::vector<std::string> firstRow;
};

bool isComment(std::string_view line) {
    return line.empty() || line.front() == '#' || line.front() == '%';
}

char separatorOf(std::string_view line) {
    for (const char separator : {';', '\t', ','})
        if (line.find(separator) != std::string_view::npos)
            return separator;
    return ' ';
}

bool looksLikeValue(std::string_view field, bool hasDecimalComma) {
    return fieldNumber(field, hasDecimalComma).has_value() || isoSeconds(field).has_value();
}

/// From the first line that is no comment, and the one behind it.
core::Expected<Dialect> dialectOf(const std::string& path) {
    TextLines lines(path);
    TELETA_CHECK(lines.open());
    Dialect dialect;
    std::vector<std::string_view> fields;
    for (;;) {
        TELETA_TRY(const auto line, lines.next());
        if (!line)
            break;
        if (isComment(*line)) {
            dialect.comments += dialect.columns == 0 ? 1 : 0;
            continue;
        }
        if (dialect.columns == 0) {
            dialect.separator = separatorOf(*line);
            dialect.hasDecimalComma = dialect.separator != ',';
        }
        splitFields(*line, dialect.separator, fields);
        const bool isRow = std::ranges::all_of(fields, [&dialect](std::string_view field) {
            return looksLikeValue(field, dialect.hasDecimalComma);
        });
        if (dialect.columns == 0 && !isRow) {
            dialect.columns = fields.size();
            dialect.header.assign(fields.begin(), fields.end());
            continue;
        }
        if (dialect.columns == 0)
            dialect.columns = fields.size();
        dialect.firstRow.assign(fields.begin(), fields.end());
        return dialect;
    }
    return core::failed(core::ErrorKind::badInput, TableText::tr("the recording has no frames"),
                        TableText::tr("at least one row of numbers"), {path, lines.number(), 1});
}

/// The index of the column of the times; empty: there is none.
core::Expected<std::optional<std::size_t>> timeColumnOf(const FrameRequest& request, const Dialect& dialect) {
    const std::string& name = request.timeColumn;
    if (name.empty())
        return std::optional<std::size_t>();
    const auto found = std::ranges::find(dialect.header, name);
    if (found != dialect.header.end())
        return std::optional(static_cast<std::size_t>(found - dialect.header.begin()));
    bool isNumber = false;
    const qulonglong number = QString::fromStdString(name).toULongLong(&isNumber);
    if (isNumber && number >= 1 && number <= dialect.columns)
        return std::optional(static_cast<std::size_t>(number - 1));
    QStringList names;
    for (std::size_t i = 0; i < std::min<std::size_t>(dialect.header.size(), 12); ++i)
        names << shownField(dialect.header[i]);
    return core::failed(
        core::ErrorKind::badInput, TableText::tr("there is no column %1").arg(shownField(name)),
        names.isEmpty() ? TableText::tr("a number from 1 to %1; the table has no header").arg(dialect.columns)
                        : TableText::tr("one of %1, or a number from 1 to %2")
                              .arg(names.join(QStringLiteral(", ")))
                              .arg(dialect.columns),
        {request.path, dialect.comments + 1, 1});
}

/// The unit that the name of a column ends with: "timestamp_ms", "t [ms]", "time(ms)".
std::string_view unitInName(std::string_view name) {
    while (!name.empty() && (name.back() == ']' || name.back() == ')'))
        name.remove_suffix(1);
    for (const TimeUnit& unit : kTimeUnits)
        for (const char before : {'_', '[', '(', ' '})
            if (name.size() > unit.name.size() && name.ends_with(unit.name) &&
                name[name.size() - unit.name.size() - 1] == before)
                return unit.name;
    return {};
}

/// s, ms, us, ns or iso.
std::string unitOf(const FrameRequest& request, const Dialect& dialect, std::size_t column) {
    if (!request.timeUnit.empty())
        return request.timeUnit;
    if (column < dialect.firstRow.size() && isoSeconds(dialect.firstRow[column]))
        return "iso";
    if (column < dialect.header.size())
        if (const std::string_view unit = unitInName(dialect.header[column]); !unit.empty())
            return std::string(unit);
    return "s";
}

core::Expected<std::vector<std::size_t>> taxelColumnsOf(const FrameRequest& request, const Dialect& dialect,
                                                        std::optional<std::size_t> time) {
    std::vector<std::size_t> columns;
    const auto refuse = [&](const QString& message, const QString& expected) {
        return core::failed(core::ErrorKind::badInput, message, expected,
                            {request.path, dialect.comments + 1, 1});
    };
    for (const ColumnRange& range : request.taxelColumns) {
        if (range.first < 1 || range.last > dialect.columns)
            return refuse(TableText::tr("the table has %1 columns, %2..%3 are asked for")
                              .arg(dialect.columns)
                              .arg(range.first)
                              .arg(range.last),
                          TableText::tr("columns from 1 to %1").arg(dialect.columns));
        for (std::size_t i = range.first - 1; i < range.last; ++i)
            columns.push_back(i);
    }
    for (std::size_t i = 0; request.taxelColumns.empty() && i < dialect.columns; ++i)
        if (i != time)
            columns.push_back(i);
    if (columns.empty() || columns.size() > kMostTaxels)
        return refuse(TableText::tr("the table has %1 columns of taxels").arg(columns.size()),
                      TableText::tr("from 1 to %1").arg(kMostTaxels));
    if (time && std::ranges::find(columns, *time) != columns.end())
        return refuse(TableText::tr("column %1 is that of the times, and one of the taxels").arg(*time + 1),
                      TableText::tr("either"));
    return columns;
}

/// Reads rows.
class TableReader {
public:
    TableReader(const FrameRequest& request, Dialect dialect)
        : m_request(request)
        , m_dialect(std::move(dialect))
        , m_lines(request.path) {}

    core::Expected<FrameSeries> read(const GoOn& goOn) {
        TELETA_TRY(m_time, timeColumnOf(m_request, m_dialect));
        TELETA_TRY(m_taxels, taxelColumnsOf(m_request, m_dialect, m_time));
        FrameSeries series;
        auto layout = layoutOf(m_request, m_taxels.size(), TableText::tr("a row of the table"));
        if (!layout) {
            layout.error().where = {m_request.path, m_dialect.comments + 1, 1};
            return core::Unexpected(layout.error());
        }
        series.layout = *layout;
        series.isPlaced = m_request.known && m_taxels.size() != m_request.known->numbers;
        series.hasPitch = m_request.pitch_m.has_value();
        series.layout.setPitch_m(m_request.pitch_m.value_or(series.layout.pitchX_m));
        TELETA_CHECK(setUnit());
        if (m_time && m_request.rate_Hz)
            return core::failed(core::ErrorKind::badInput, TableText::tr("a column of times and a rate"),
                                TableText::tr("either"), {m_request.path});
        TELETA_CHECK(m_lines.open());
        std::size_t frames = 0;
        for (bool isHeader = !m_dialect.header.empty();;) {
            TELETA_TRY(const auto line, m_lines.next());
            if (!line)
                break;
            if (isComment(*line))
                continue;
            if (std::exchange(isHeader, false))
                continue;
            if (goOn && !goOn())
                return core::Unexpected(core::Error{core::ErrorKind::cancelled, {}, {}, {}});
            TELETA_CHECK(readRow(*line, series));
            ++frames;
        }
        if (!m_time) {
            auto times_s = timesAt(m_request.needsTimes ? m_request.rate_Hz
                                                        : std::optional(m_request.rate_Hz.value_or(1.0)),
                                   frames, m_request.path);
            if (!times_s) {
                times_s.error().expected =
                    TableText::tr("the column of the times (--time-column NAME), or frames per second "
                                  "(--rate HZ)")
                        .toStdString();
                return core::Unexpected(times_s.error());
            }
            series.time_s = *std::move(times_s);
        }
        return series;
    }

private:
    core::Expected<void> setUnit() {
        if (!m_time)
            return {};
        const std::string unit = unitOf(m_request, m_dialect, *m_time);
        m_isIso = unit == "iso";
        const auto known =
            std::ranges::find_if(kTimeUnits, [&unit](const TimeUnit& each) { return each.name == unit; });
        if (known == kTimeUnits.end() && !m_isIso)
            return core::failed(core::ErrorKind::badInput,
                                TableText::tr("the unit %1 of the times").arg(shownField(unit)),
                                QStringLiteral("s, ms, us, ns, iso"), {m_request.path});
        m_unit_s = m_isIso ? 1.0 : known->s;
        return {};
    }

    /// An error at a field of the last row.
    core::Unexpected wrongField(std::size_t column, const QString& message, const QString& expected) const {
        const auto begin = m_fields[column].data() - m_line.data();
        return m_lines.wrong(message, expected, begin + 1);
    }

    core::Expected<void> readRow(std::string_view line, FrameSeries& series) {
        m_line = line;
        splitFields(line, m_dialect.separator, m_fields);
        if (m_fields.size() != m_dialect.columns)
            return m_lines.wrong(TableText::tr("the row has %1 values").arg(m_fields.size()),
                                 TableText::tr("one value per column: %1").arg(m_dialect.columns), 1);
        if (series.values.size() + m_taxels.size() > kMostValues)
            return m_lines.wrong(TableText::tr("the table is too long"),
                                 TableText::tr("at most %1 values").arg(kMostValues));
        if (m_time) {
            TELETA_TRY(const double time_s, timeOf(*m_time));
            if (!series.time_s.empty() && time_s < series.time_s.back())
                return wrongField(*m_time, TableText::tr("the time goes back"),
                                  TableText::tr("times that do not decrease"));
            series.time_s.push_back(time_s);
        }
        for (const std::size_t column : m_taxels) {
            const auto value = fieldNumber(m_fields[column], m_dialect.hasDecimalComma);
            if (!value)
                return wrongField(column,
                                  TableText::tr("%1 is not a number").arg(shownField(m_fields[column])),
                                  TableText::tr("a number, nan, inf or NA"));
            series.values.push_back(static_cast<float>(*value));
        }
        return {};
    }

    core::Expected<double> timeOf(std::size_t column) {
        const std::string_view field = m_fields[column];
        if (!m_isIso) {
            const auto value = fieldNumber(field, m_dialect.hasDecimalComma);
            if (!value || !std::isfinite(*value))
                return wrongField(column, TableText::tr("%1 is not a time").arg(shownField(field)),
                                  isoSeconds(field)
                                      ? TableText::tr("a number, or iso as the unit (--time-unit iso)")
                                      : TableText::tr("a finite number"));
            return *value * m_unit_s;
        }
        const auto seconds = isoSeconds(field);
        if (!seconds)
            return wrongField(column, TableText::tr("%1 is not a time").arg(shownField(field)),
                              TableText::tr("a date and time such as 2026-05-01T12:00:00.5"));
        if (!m_first_s)
            m_first_s = *seconds;
        return *seconds - *m_first_s;
    }

    const FrameRequest& m_request;
    Dialect m_dialect;
    TextLines m_lines;
    std::optional<std::size_t> m_time;
    std::vector<std::size_t> m_taxels;
    bool m_isIso = false;
    double m_unit_s = 1.0;
    std::optional<double> m_first_s;
    std::string_view m_line;
    std::vector<std::string_view> m_fields;
};

/// Whether a name is one that programs give to times.
bool isTimeName(const std::string& name) {
    const QString text = QString::fromStdString(name).toLower();
    return text == QLatin1String("t") || text.contains(QLatin1String("time")) ||
           text.contains(QLatin1String("stamp")) || text.startsWith(QLatin1String("sec")) ||
           text == QLatin1String("date");
}

} // namespace

core::Expected<FrameSeries> readTable(const FrameRequest& request, const GoOn& goOn) {
    TELETA_TRY(Dialect dialect, dialectOf(request.path));
    return TableReader(request, std::move(dialect)).read(goOn);
}

QString tableOptions(const std::string& path) {
    const auto dialect = dialectOf(path);
    if (!dialect || dialect->columns < 2 || dialect->firstRow.size() != dialect->columns ||
        !std::ranges::all_of(dialect->firstRow, [&](const std::string& field) {
            return looksLikeValue(field, dialect->hasDecimalComma);
        }))
        return {};
    std::optional<std::size_t> time;
    for (std::size_t i = 0; !time && i < dialect->columns; ++i)
        if ((i < dialect->header.size() && isTimeName(dialect->header[i])) ||
            isoSeconds(dialect->firstRow[i]))
            time = i;
    if (!time)
        return QStringLiteral("--columns 1..%1 --rate HZ").arg(dialect->columns);
    QStringList ranges;
    const auto add = [&ranges](std::size_t first, std::size_t last) {
        if (first <= last)
            ranges << QStringLiteral("%1..%2").arg(first).arg(last);
    };
    add(1, *time);
    add(*time + 2, dialect->columns);
    const QString name =
        *time < dialect->header.size() && dialect->header[*time].find(' ') == std::string::npos
            ? QString::fromStdString(dialect->header[*time]).left(40)
            : QString::number(*time + 1);
    FrameRequest request;
    return QStringLiteral("--columns %1 --time-column %2 --time-unit %3")
        .arg(ranges.join(QLatin1Char(',')), name, QString::fromStdString(unitOf(request, *dialect, *time)));
}

} // namespace teleta::frames
