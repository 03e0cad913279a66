// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/frames/line_decoder.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace teleta::taxels {

namespace {

/// A JSON text nested deeper than this is no frame; a parser that follows it would run out of stack.
constexpr int kDeepest = 64;

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlank = " \t\r\n";
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

bool readField(std::string_view text, double& number) {
    text = trimmed(text);
    if (text.starts_with('+') && !text.starts_with("+-"))
        text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(number);
}

bool append(double number, const Scaling& scaling, std::vector<float>& values) {
    const auto value = static_cast<float>(scaling.scale * number + scaling.offset);
    values.push_back(value);
    return std::isfinite(value);
}

bool isShallow(std::string_view text) {
    int depth = 0;
    for (const char c : text) {
        depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
        if (depth > kDeepest)
            return false;
    }
    return true;
}

/// The text with null in place of NaN, Infinity and -Infinity, where they stand outside of quotes.
std::string withoutNaN(std::string_view text) {
    constexpr std::array<std::string_view, 3> kNoNumbers{"NaN", "-Infinity", "Infinity"};
    std::string result;
    bool isQuoted = false;
    while (!text.empty()) {
        const auto found = std::ranges::find_if(
            kNoNumbers, [&](std::string_view name) { return !isQuoted && text.starts_with(name); });
        if (found != kNoNumbers.end()) {
            result += "null";
            text.remove_prefix(found->size());
            continue;
        }
        if (text.front() == '"')
            isQuoted = !isQuoted;
        const std::size_t letters = isQuoted && text.front() == '\\' && text.size() > 1 ? 2 : 1;
        result += text.substr(0, letters);
        text.remove_prefix(letters);
    }
    return result;
}

} // namespace

LineDecoder::LineDecoder(CsvFormat format, Framing framing)
    : m_format(format)
    , m_datagrams(framing == Framing::datagrams)
    , m_toSkip(m_datagrams ? 0 : format.skip) {
}

LineDecoder::LineDecoder(JsonFormat format, Framing framing)
    : m_values(format.values)
    , m_time(format.time)
    , m_otherTime(format.otherTime)
    , m_counter(format.counter)
    , m_sensor(format.sensor ? format.sensor->place : std::string())
    , m_model(format.sensor ? format.sensor->model : std::string())
    , m_datagrams(framing == Framing::datagrams) {
    m_format = std::move(format);
}

bool LineDecoder::next(DecodedFrame& frame, Rest rest) {
    while (pendingBytes() > 0) {
        const std::span<const std::uint8_t> bytes = pending();
        std::size_t size = bytes.size();
        bool isCut = false;
        if (!m_datagrams) {
            const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(std::min(m_searched, bytes.size()));
            const auto end = std::find(from, bytes.end(), std::uint8_t{'\n'});
            if (end == bytes.end() && rest == Rest::mayCome && bytes.size() <= kLongestFrame) {
                m_searched = bytes.size();
                return false;
            }
            if (end != bytes.end())
                size = static_cast<std::size_t>(end - bytes.begin()) + 1;
            isCut = end == bytes.end() && rest != Rest::ended && std::holds_alternative<CsvFormat>(m_format);
            const bool isDropped = m_begunLine || size > kLongestFrame;
            m_begunLine = isDropped && end == bytes.end();
            if (isDropped) {
                m_searched = 0;
                drop(size);
                continue;
            }
        }
        m_searched = 0;
        const std::string_view line = trimmed({reinterpret_cast<const char*>(bytes.data()), size});
        m_begunLine = isCut && !line.empty();
        if (m_toSkip > 0 || line.empty()) {
            m_toSkip -= m_toSkip > 0 ? 1 : 0;
            drop(size);
            continue;
        }
        frame.values.clear();
        frame.counter.reset();
        frame.ticks.reset();
        frame.time_s.reset();
        const Problem before = std::exchange(m_problem, {});
        const Verdict verdict = std::holds_alternative<JsonFormat>(m_format) ? readJson(line, frame)
                                : !isCut && readCsv(line, frame)             ? Verdict::frame
                                                                             : Verdict::wrong;
        if (verdict == Verdict::other)
            m_problem = before;
        if (verdict != Verdict::wrong) {
            take(size, verdict == Verdict::other);
            if (verdict == Verdict::frame)
                return true;
            continue;
        }
        ++m_counters.badValues;
        if (m_problem.kind == Problem::Kind::none)
            m_problem.kind = Problem::Kind::other;
        drop(size);
    }
    return false;
}

bool LineDecoder::readCsv(std::string_view line, DecodedFrame& frame) const {
    const auto& format = std::get<CsvFormat>(m_format);
    std::vector<float> others;
    std::size_t column = 0;
    for (bool isLast = false; !isLast;) {
        const std::size_t end = line.find(format.separator);
        isLast = end == std::string_view::npos;
        const std::string_view field = line.substr(0, end);
        line.remove_prefix(isLast ? line.size() : end + 1);
        ++column;
        double number = 0.0;
        if (column == format.timeColumn) {
            if (!readField(field, number))
                return false;
            frame.time_s = number * format.timeUnit_s;
        }
        if (column < format.firstColumn || column > format.lastColumn)
            continue;
        const bool isValue = (column - format.firstColumn) % format.groupColumns < format.perGroup;
        if (!readField(field, number) ||
            !append(number, isValue ? format.scaling : Scaling(), isValue ? frame.values : others))
            return false;
    }
    frame.values.insert(frame.values.end(), others.begin(), others.end());
    return column >= format.lastColumn && column >= format.timeColumn;
}

LineDecoder::Verdict LineDecoder::readJson(std::string_view line, DecodedFrame& frame) {
    const auto& format = std::get<JsonFormat>(m_format);
    if (!isShallow(line))
        return Verdict::wrong;
    nlohmann::json document = nlohmann::json::parse(line, nullptr, false);
    if (document.is_discarded())
        document = nlohmann::json::parse(withoutNaN(line), nullptr, false);
    if (document.is_discarded())
        return Verdict::wrong;
    try {
        if (!document.contains(format.sensor ? m_sensor : m_values))
            return Verdict::other;
        if (format.sensor && !isOurSensor(document.at(m_sensor)))
            return Verdict::wrong;
        if (!document.contains(m_values) || document.at(m_values).is_null()) {
            m_problem.kind = Problem::Kind::noValues;
            return Verdict::wrong;
        }
        if (!readValues(document.at(m_values), frame))
            return Verdict::wrong;
        readTime(document, frame);
        if (!format.time.empty() && !frame.time_s && !format.mayLackTime)
            return Verdict::wrong;
        if (!format.counter.empty()) {
            if (!document.contains(m_counter) || !document.at(m_counter).is_number_unsigned())
                return Verdict::wrong;
            frame.counter = static_cast<std::uint32_t>(document.at(m_counter).get<std::uint64_t>());
        }
    } catch (const nlohmann::json::exception&) {
        return Verdict::wrong; // a pointer into what has no such place
    }
    return frame.values.size() == format.count && (!frame.time_s || std::isfinite(*frame.time_s))
               ? Verdict::frame
               : Verdict::wrong;
}

bool LineDecoder::isOurSensor(const nlohmann::json& sensor) {
    const JsonSensor& wanted = *std::get<JsonFormat>(m_format).sensor;
    const auto model = sensor.find("model");
    if (model != sensor.end() && model->is_string()) {
        const auto& told = model->get_ref<const std::string&>();
        if (m_model.empty())
            m_model = told;
        if (told != m_model) {
            m_problem = {Problem::Kind::model, told, m_model};
            return false;
        }
    }
    const auto taxels = sensor.find("taxels");
    if (taxels != sensor.end() && taxels->is_number() &&
        taxels->get<double>() != static_cast<double>(wanted.taxels)) {
        m_problem = {Problem::Kind::taxels, taxels->dump(), std::to_string(wanted.taxels)};
        return false;
    }
    return true;
}

void LineDecoder::readTime(const nlohmann::json& document, DecodedFrame& frame) const {
    const auto& format = std::get<JsonFormat>(m_format);
    const auto read = [&](const std::string& name, const nlohmann::json::json_pointer& place) {
        if (!frame.time_s && !name.empty() && document.contains(place) && document.at(place).is_number())
            frame.time_s = document.at(place).get<double>() * format.timeUnit_s;
    };
    read(format.time, m_time);
    read(format.otherTime, m_otherTime);
}

bool LineDecoder::readValues(const nlohmann::json& values, DecodedFrame& frame) const {
    const auto& format = std::get<JsonFormat>(m_format);
    if (format.hex)
        return values.is_string() && readHex(values.get_ref<const std::string&>(), frame);
    return values.is_array() && std::ranges::all_of(values, [&](const nlohmann::json& value) {
               return value.is_number() && append(value.get<double>(), format.scaling, frame.values);
           });
}

bool LineDecoder::readHex(std::string_view text, DecodedFrame& frame) const {
    const Scaling& scaling = std::get<JsonFormat>(m_format).scaling;
    for (bool isLast = false; !isLast;) {
        const std::size_t comma = text.find(',');
        isLast = comma == std::string_view::npos;
        const std::string_view field = trimmed(text.substr(0, comma));
        text.remove_prefix(isLast ? text.size() : comma + 1);
        std::uint16_t number = 0;
        const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), number, 16);
        if (error != std::errc() || end != field.data() + field.size() ||
            !append(number, scaling, frame.values))
            return false;
    }
    return true;
}

} // namespace teleta::taxels
