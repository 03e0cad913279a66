// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/tekscan_file.h"

#include "backend/core/failure.h"
#include "backend/frames/text_lines.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace teleta::frames {

namespace {

struct TekscanText {
    Q_DECLARE_TR_FUNCTIONS(TekscanText)
};

constexpr std::string_view kData = "ASCII_DATA";
constexpr int kMostHeadLines = 400;
/// Of a calibration that the recording program has applied already, or that nothing here knows.
constexpr std::array kUnusedKeys{"NOISE_THRESHOLD", "SCALE_FACTOR", "SATURATION_PRESSURE", "SENSITIVITY"};

struct PressureUnit {
    std::string_view name; ///< in lower case
    double Pa;
};
/// Conventional values; kg stands for kilogram-force.
constexpr std::array kPressureUnits{PressureUnit{"pa", 1.0},
                                    PressureUnit{"kpa", 1e3},
                                    PressureUnit{"mpa", 1e6},
                                    PressureUnit{"bar", 1e5},
                                    PressureUnit{"mbar", 100.0},
                                    PressureUnit{"psi", 6894.757293168},
                                    PressureUnit{"mmhg", 133.322387415},
                                    PressureUnit{"kg/cm2", 98066.5},
                                    PressureUnit{"n/cm2", 1e4},
                                    PressureUnit{"n/mm2", 1e6},
                                    PressureUnit{"g/cm2", 98.0665}};

std::string lowered(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    std::erase_if(result, [](char c) { return c == '^' || c == ' '; });
    return result;
}

bool isDataLine(std::string_view line) {
    return line.starts_with(kData);
}

class TekscanReader {
public:
    explicit TekscanReader(const FrameRequest& request)
        : m_request(request)
        , m_lines(request.path) {}

    core::Expected<FrameSeries> read(const GoOn& goOn) {
        TELETA_CHECK(m_lines.open());
        TELETA_CHECK(readHead());
        TELETA_CHECK(setLayout());
        TELETA_TRY(m_factor, unitFactor());
        TELETA_TRY(m_frame_s, frameTime());
        TELETA_TRY(m_mirrorsRows, mirrors("MIRROR_ROW"));
        TELETA_TRY(m_mirrorsColumns, mirrors("MIRROR_COL"));
        for (const char* name : kUnusedKeys)
            if (m_keys.contains(name))
                m_series.unused.emplace_back(name);
        for (;;) {
            TELETA_TRY(const auto line, m_lines.next());
            if (!line)
                break;
            if (line->empty() || line->starts_with("@@"))
                continue;
            if (goOn && !goOn())
                return core::Unexpected(core::Error{core::ErrorKind::cancelled, {}, {}, {}});
            TELETA_CHECK(beginFrame(*line));
            TELETA_CHECK(readRows());
        }
        if (m_series.time_s.empty())
            return m_lines.wrong(TekscanText::tr("the recording has no frames"), QStringLiteral("Frame 1"));
        if (const auto end = key("END_FRAME"); end && m_frame < static_cast<long long>(end->number))
            return m_lines.wrong(TekscanText::tr("the file ends after frame %1 of %2")
                                     .arg(m_frame)
                                     .arg(static_cast<long long>(end->number)),
                                 TekscanText::tr("a whole file"));
        return std::move(m_series);
    }

private:
    struct Value {
        std::string text;
        double number = std::numeric_limits<double>::quiet_NaN();
        std::string unit; ///< in lower case
        long long line = 0;
    };

    core::Expected<void> readHead() {
        for (;;) {
            TELETA_TRY(const auto line, m_lines.next());
            if (!line)
                return m_lines.wrong(TekscanText::tr("the file ends within its head"),
                                     QStringLiteral("ASCII_DATA @@"));
            if (isDataLine(*line))
                return {};
            const std::size_t blank = line->find_first_of(" ,;\t");
            if (blank == std::string_view::npos || blank == 0)
                continue;
            Value value;
            value.text =
                std::string(line->substr(line->find_first_not_of(" ,;\t", blank) == std::string_view::npos
                                             ? line->size()
                                             : line->find_first_not_of(" ,;\t", blank)));
            const std::size_t end = value.text.find(' ');
            if (const auto number = fieldNumber(std::string_view(value.text).substr(0, end), true)) {
                value.number = *number;
                if (end != std::string::npos)
                    value.unit = lowered(std::string_view(value.text).substr(end + 1));
            }
            value.line = m_lines.number();
            m_keys.insert_or_assign(std::string(line->substr(0, blank)), std::move(value));
        }
    }

    [[nodiscard]] const Value* key(const char* name) const {
        const auto found = m_keys.find(name);
        return found != m_keys.end() && !std::isnan(found->second.number) ? &found->second : nullptr;
    }

    [[nodiscard]] core::Unexpected wrongKey(const char* name, const QString& expected) const {
        const auto found = m_keys.find(name);
        if (found == m_keys.end())
            return m_lines.wrong(TekscanText::tr("the head has no line %1").arg(QString::fromLatin1(name)),
                                 expected);
        return core::failed(
            core::ErrorKind::badInput,
            QStringLiteral("%1 %2").arg(QString::fromLatin1(name), shownField(found->second.text)), expected,
            {m_request.path, found->second.line, 1});
    }

    core::Expected<int> side(const char* name) const {
        constexpr int kMost = core::ArrayLayout::kMaximumSide;
        const Value* value = key(name);
        if (value == nullptr || !(value->number >= 1.0 && value->number <= kMost) ||
            value->number != std::floor(value->number))
            return wrongKey(name, TekscanText::tr("a whole number from 1 to %1").arg(kMost));
        return static_cast<int>(value->number);
    }

    /// A distance in m; empty: not told.
    core::Expected<std::optional<double>> spacing_m(const char* name) const {
        const Value* value = key(name);
        if (value == nullptr)
            return std::optional<double>();
        const double factor = value->unit == "mm" ? 1e-3 : value->unit == "cm" ? 1e-2 : 0.0;
        if (factor == 0.0 || !(value->number > 0.0) || !std::isfinite(value->number))
            return wrongKey(name, TekscanText::tr("a number above 0 in mm or cm"));
        return std::optional(value->number * factor);
    }

    core::Expected<void> setLayout() {
        core::ArrayLayout& layout = m_series.layout;
        TELETA_TRY(layout.rows, side("ROWS"));
        TELETA_TRY(layout.columns, side("COLS"));
        if ((m_request.rows && *m_request.rows != layout.rows) ||
            (m_request.columns && *m_request.columns != layout.columns))
            return wrongKey("ROWS", TekscanText::tr("%1 rows x %2 columns, as was asked for")
                                        .arg(m_request.rows.value_or(layout.rows))
                                        .arg(m_request.columns.value_or(layout.columns)));
        TELETA_TRY(const std::optional<double> row_m, spacing_m("ROW_SPACING"));
        TELETA_TRY(const std::optional<double> column_m, spacing_m("COL_SPACING"));
        if (row_m && column_m)
            m_area_m2 = *row_m * *column_m;
        if (m_request.pitch_m) {
            layout.setPitch_m(*m_request.pitch_m);
            m_series.hasPitch = true;
        } else if (row_m && column_m) {
            layout.pitchX_m = *column_m;
            layout.pitchY_m = *row_m;
            m_series.hasPitch = true;
        }
        if (const Value* area = key("SENSEL_AREA")) {
            const double factor = area->unit == "cm2" ? 1e-4 : area->unit == "mm2" ? 1e-6 : 0.0;
            if (factor == 0.0 || !(area->number > 0.0) || !std::isfinite(area->number))
                return wrongKey("SENSEL_AREA", TekscanText::tr("a number above 0 in mm2 or cm2"));
            m_area_m2 = area->number * factor;
        }
        return {};
    }

    /// From a value in the file to the unit of the series.
    core::Expected<double> unitFactor() {
        const auto units = m_keys.find("UNITS");
        const std::string unit = units == m_keys.end() ? "raw" : lowered(units->second.text);
        m_series.unit = "counts";
        if (unit.starts_with("raw"))
            return 1.0;
        const auto known = std::ranges::find_if(
            kPressureUnits, [&unit](const PressureUnit& each) { return each.name == unit; });
        if (known == kPressureUnits.end())
            return wrongKey("UNITS", TekscanText::tr("RAW, or a unit of pressure such as kPa or PSI"));
        if (m_area_m2 <= 0.0)
            return wrongKey("SENSEL_AREA", TekscanText::tr("the area with which a pressure makes a force"));
        m_series.unit = "N";
        return known->Pa * m_area_m2;
    }

    core::Expected<double> frameTime() const {
        const Value* value = key("SECONDS_PER_FRAME");
        if (m_request.rate_Hz)
            return 1.0 / *m_request.rate_Hz;
        if (value == nullptr && !m_request.needsTimes)
            return 1.0;
        if (value == nullptr || !(value->number > 0.0) || !std::isfinite(value->number))
            return wrongKey("SECONDS_PER_FRAME",
                            TekscanText::tr("a number above 0, or frames per second (--rate HZ)"));
        return value->number;
    }

    /// Whether the head says that an order is turned round.
    core::Expected<bool> mirrors(const char* name) const {
        const auto found = m_keys.find(name);
        if (found == m_keys.end() || found->second.text.empty())
            return false;
        const double number = found->second.number;
        if (number != 0.0 && number != 1.0)
            return wrongKey(name, TekscanText::tr("0 or 1"));
        return number == 1.0;
    }

    /// Turns the newest frame as the head says.
    void mirror() {
        const auto columns = static_cast<std::ptrdiff_t>(m_series.layout.columns);
        const auto begin = m_series.values.end() - static_cast<std::ptrdiff_t>(m_series.layout.taxels());
        // Both together are the whole frame from behind.
        if (m_mirrorsRows)
            std::reverse(begin, m_series.values.end());
        if (m_mirrorsRows != m_mirrorsColumns)
            for (auto row = begin; row != m_series.values.end(); row += columns)
                std::reverse(row, row + columns);
    }

    core::Expected<void> beginFrame(std::string_view line) {
        constexpr std::string_view kFrame = "Frame ";
        long long number = 0;
        if (!line.starts_with(kFrame))
            return m_lines.wrong(TekscanText::tr("the line is %1").arg(shownField(line)),
                                 QStringLiteral("Frame N"), 1);
        const char* end = line.data() + line.size();
        const auto [stop, code] = std::from_chars(line.data() + kFrame.size(), end, number);
        if (code != std::errc() || number < 0)
            return m_lines.wrong(TekscanText::tr("the frame has no number"), QStringLiteral("Frame N"),
                                 static_cast<long long>(kFrame.size()) + 1);
        if (!m_series.time_s.empty() && number <= m_frame)
            return m_lines.wrong(TekscanText::tr("frame %1 comes after frame %2").arg(number).arg(m_frame),
                                 TekscanText::tr("numbers that grow"), 1);
        if (m_series.values.size() + m_series.layout.taxels() > kMostValues)
            return m_lines.wrong(TekscanText::tr("the recording is too long"),
                                 TekscanText::tr("at most %1 values").arg(kMostValues));
        if (m_series.time_s.empty()) {
            const Value* start = key("START_FRAME");
            m_first = start != nullptr && start->number <= static_cast<double>(number)
                          ? static_cast<long long>(start->number)
                          : number;
        }
        m_frame = number;
        m_series.time_s.push_back(static_cast<double>(number - m_first) * m_frame_s);
        return {};
    }

    core::Expected<void> readRows() {
        for (int row = 0; row < m_series.layout.rows; ++row) {
            TELETA_TRY(const auto line, m_lines.next());
            if (!line || line->empty())
                return m_lines.wrong(TekscanText::tr("frame %1 ends after %2 of %3 rows")
                                         .arg(m_frame)
                                         .arg(row)
                                         .arg(m_series.layout.rows),
                                     TekscanText::tr("a whole frame"));
            const char separator = line->find(';') != std::string_view::npos ? ';' : ',';
            splitFields(*line, separator, m_fields);
            if (m_fields.size() > 1 && m_fields.back().empty())
                m_fields.pop_back(); // a separator at the end
            if (m_fields.size() != static_cast<std::size_t>(m_series.layout.columns))
                return m_lines.wrong(TekscanText::tr("the row has %1 values").arg(m_fields.size()),
                                     TekscanText::tr("%1 values").arg(m_series.layout.columns), 1);
            for (const std::string_view field : m_fields) {
                if (field == "B") {
                    m_series.values.push_back(std::numeric_limits<float>::quiet_NaN());
                    continue;
                }
                const auto value = fieldNumber(field, separator == ';');
                if (!value || !std::isfinite(*value))
                    return m_lines.wrong(TekscanText::tr("%1 is not a number").arg(shownField(field)),
                                         TekscanText::tr("a number or B"), field.data() - line->data() + 1);
                m_series.values.push_back(static_cast<float>(*value * m_factor));
            }
        }
        mirror();
        return {};
    }

    const FrameRequest& m_request;
    TextLines m_lines;
    std::map<std::string, Value> m_keys;
    std::vector<std::string_view> m_fields;
    FrameSeries m_series;
    double m_area_m2 = 0.0;
    double m_factor = 1.0;
    double m_frame_s = 1.0;
    bool m_mirrorsRows = false;
    bool m_mirrorsColumns = false;
    long long m_first = 0;
    long long m_frame = 0;
};

} // namespace

bool isTekscan(const std::string& path) {
    TextLines lines(path);
    if (!lines.open())
        return false;
    for (int i = 0; i < kMostHeadLines; ++i) {
        const auto line = lines.next();
        if (!line || !*line)
            return false;
        if (isDataLine(**line))
            return true;
    }
    return false;
}

core::Expected<FrameSeries> readTekscan(const FrameRequest& request, const GoOn& goOn) {
    return TekscanReader(request).read(goOn);
}

} // namespace teleta::frames
