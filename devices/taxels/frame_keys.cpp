// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/frame_keys.h"

#include "devices/link/link_address.h"
#include "devices/taxels/taxels_text.h"

#include <QString>

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <optional>
#include <utility>

namespace teleta::taxels {

namespace {

using core::Keys;
using core::Need;
using core::NumberRange;
using core::WholeRange;

constexpr long long kMostBytes = static_cast<long long>(kLongestFrame);
constexpr std::size_t kMostMarkBytes = 64; ///< that a key may give
constexpr WholeRange kPlaces{-kMostBytes, kMostBytes};

constexpr std::array kTypes{
    std::pair{NumberType::int8, "int8"},       std::pair{NumberType::uint8, "uint8"},
    std::pair{NumberType::int16, "int16"},     std::pair{NumberType::uint16, "uint16"},
    std::pair{NumberType::int24, "int24"},     std::pair{NumberType::uint24, "uint24"},
    std::pair{NumberType::int32, "int32"},     std::pair{NumberType::uint32, "uint32"},
    std::pair{NumberType::float32, "float32"}, std::pair{NumberType::float64, "float64"}};

constexpr std::array kTimeUnits{std::pair{1.0, "s"}, std::pair{1e-3, "ms"}, std::pair{1e-6, "us"},
                                std::pair{1e-9, "ns"}};

/// A key whose value is one of those that accept() takes, among pairs of value and name.
template <typename Pairs, typename Value, typename Accept>
void describeNamed(Keys& keys, std::string_view key, const Pairs& pairs, Value& value, Accept accept,
                   std::string_view about, Need need) {
    core::KeyNames names;
    std::vector<Value> values;
    std::size_t index = 0;
    for (const auto& [known, name] : pairs) {
        if (!accept(known))
            continue;
        if (known == value)
            index = values.size();
        names.emplace_back(name);
        values.push_back(known);
    }
    keys.choose(key, index, names, about, need,
                [&value, values](Keys&, std::size_t chosen) { value = values[chosen]; });
}

template <typename Accept>
void describeType(Keys& keys, NumberType& type, Accept accept) {
    describeNamed(keys, "type", kTypes, type, accept, "How a number stands in the bytes", Need::required);
}

void describeOrder(Keys& keys, ByteOrder& order) {
    keys.choice("order", order, {"little", "big"}, "Whether the lowest or the highest byte comes first",
                Need::optional);
}

void describeTimeUnit(Keys& keys, std::string_view key, double& unit_s) {
    describeNamed(
        keys, key, kTimeUnits, unit_s, [](double) { return true; }, "Unit of the sensor's time",
        Need::optional);
}

/// What is known of the length while the fields are read.
struct Length {
    std::size_t bytes = 0; ///< 0: as the length field says

    /// The place of a field; a long frame stands for one of unknown length.
    [[nodiscard]] std::optional<std::size_t> placeOf(long long at, std::size_t size) const {
        return positionOf(at, size, bytes > 0 ? bytes : kLongestFrame);
    }

    void check(Keys& keys, std::string_view key, long long at, std::size_t size) const {
        if (placeOf(at, size))
            return;
        if (bytes > 0)
            refuse(
                keys, key,
                TaxelsText::tr("%n byte(s) from %1 on are not in the frame", nullptr, static_cast<int>(size))
                    .arg(at),
                TaxelsText::tr("a place in a frame of %n byte(s)", nullptr, static_cast<int>(bytes)));
        else
            refuse(keys, key,
                   TaxelsText::tr("%n byte(s) from %1 on are in no frame", nullptr, static_cast<int>(size))
                       .arg(at),
                   TaxelsText::tr("a place in the frame; a negative one counts from its end"));
    }
};

void describePlace(Keys& keys, NumberField& field) {
    keys.whole("at", field.at, kPlaces, "Offset of its first byte from 0; negative: from the frame's end");
}

void describeLengthField(Keys& keys, LengthField& length) {
    keys.whole("at", length.field.at, {0, 255}, "Offset of its first byte from 0");
    describeType(keys, length.field.type, isUnsigned);
    describeOrder(keys, length.field.order);
    keys.choice("counts", length.counts,
                {{"payload", "The bytes between it and the checksum, or else the closing bytes"},
                 {"rest", "All bytes behind it"},
                 {"frame", "All bytes of the frame"}},
                "What it counts");
}

void describeChecksum(Keys& keys, ChecksumField& checksum, const Length& length, std::size_t endBytes) {
    keys.choice("type", checksum.type,
                {"none", "sum8", "xor8", "crc8", "crc16-ccitt", "crc16-modbus", "crc32", "crc16-wts"},
                "How it is computed; `crc16-wts` is that of Weiss arrays", Need::required);
    const std::size_t size = sizeOf(checksum.type);
    std::optional<long long> first;
    keys.whole("at", first, kPlaces,
               "Offset of its first byte from 0; negative: from the frame's end; otherwise right before the "
               "closing bytes");
    checksum.at = first.value_or(-static_cast<long long>(size + endBytes));
    keys.whole("from", checksum.from, kPlaces, "First byte that it covers", Need::optional);
    std::optional<long long> behind;
    keys.whole("to", behind, kPlaces, "First byte after the covered ones; otherwise the checksum itself");
    checksum.to = behind.value_or(checksum.at);
    describeOrder(keys, checksum.order);
    std::optional<std::uint32_t> init;
    keys.whole("init", init, {0, 0xFFFF'FFFF},
               "What the computation starts with; otherwise as usual for its type");
    checksum.init = init.value_or(usualInit(checksum.type));
    std::optional<std::uint32_t> xorOut;
    keys.whole("xor", xorOut, {0, 0xFFFF'FFFF},
               "What the result is combined with by exclusive or; otherwise as usual for its type");
    checksum.xorOut = xorOut.value_or(usualXor(checksum.type));
    if (size == 0)
        return;
    length.check(keys, "at", checksum.at, size);
    const auto at = length.placeOf(checksum.at, size);
    const auto from = length.placeOf(checksum.from, 0);
    const auto to = length.placeOf(checksum.to, 0);
    if (!from || !to || *from >= *to)
        refuse(keys, "from", TaxelsText::tr("the checksum covers no byte of the frame"),
               TaxelsText::tr("\"from\" before \"to\""));
    else if (at && *from<*at + size&& * to> * at)
        refuse(keys, "to", TaxelsText::tr("the checksum covers itself"),
               TaxelsText::tr("bytes before or behind it"));
}

void describeScaling(Keys& keys, Scaling& scaling) {
    keys.number("scale", scaling.scale, NumberRange::any(), "Scale factor", Need::optional);
    keys.number("offset", scaling.offset, NumberRange::any(), "Added after scaling", Need::optional);
    if (scaling.scale == 0.0)
        refuse(keys, "scale", TaxelsText::tr("with a factor of 0 every value is the same"),
               TaxelsText::tr("another number"));
}

void describeValues(Keys& keys, BinaryFormat& format, const Length& length, std::size_t perGroup) {
    ValueField& values = format.values;
    values.perGroup = perGroup;
    describePlace(keys, values.field);
    describeType(keys, values.field.type, [](NumberType) { return true; });
    describeOrder(keys, values.field.order);
    keys.whole("count", values.count, {1, kMostBytes}, "Numbers in a frame, all components counted");
    keys.whole("stride", values.stride, {0, kMostBytes},
               "Bytes from a taxel to the next; 0: they touch. The components of a taxel always touch",
               Need::optional);
    describeScaling(keys, format.scaling);
    if (values.count % perGroup != 0)
        refuse(keys, "count",
               TaxelsText::tr("%1 numbers are not %2 for each taxel").arg(values.count).arg(perGroup),
               TaxelsText::tr("a multiple of %1").arg(perGroup));
    if (values.stride > 0 && values.stride < perGroup * sizeOf(values.field.type))
        refuse(keys, "stride", TaxelsText::tr("a taxel has more bytes than that"),
               TaxelsText::tr("at least %1, or 0").arg(perGroup * sizeOf(values.field.type)));
    else
        length.check(keys, "at", values.field.at, values.bytes());
}

void describeBinary(Keys& keys, BinaryFormat& format, std::size_t perGroup) {
    describeBytes(keys, "sync", format.sync, "First bytes of each frame, hexadecimal, as `AA 55`");
    std::optional<std::size_t> bytes;
    keys.whole("length", bytes, {1, kMostBytes}, "Bytes of the whole frame; otherwise `length_field`");
    format.length = bytes.value_or(0);
    keys.table("length_field", format.lengthField, "Number in the frame that says how long it is",
               describeLengthField);
    keys.oneOf("length", "length_field", TaxelsText::tr("the length of a frame is not clear").toStdString(),
               TaxelsText::tr("either length or length_field").toStdString());
    describeBytes(keys, "end", format.end, "Last bytes of each frame, hexadecimal");
    const bool tooShort =
        !format.lengthField && format.length > 0 && format.length < format.sync.size() + format.end.size();
    const Length length{format.lengthField || tooShort ? 0 : format.length};
    if (tooShort)
        refuse(keys, "length", TaxelsText::tr("the first and last bytes are longer than the frame"),
               TaxelsText::tr("at least %1").arg(format.sync.size() + format.end.size()));
    keys.table("checksum", "Number by which a frame is checked", Need::optional,
               [&](Keys& table) { describeChecksum(table, format.checksum, length, format.end.size()); });
    keys.table("counter", format.counter, "Number that counts the frames, by which lost ones are known",
               [&](Keys& table, NumberField& counter) {
                   describePlace(table, counter);
                   describeType(table, counter.type, isUnsigned);
                   describeOrder(table, counter.order);
                   length.check(table, "at", counter.at, sizeOf(counter.type));
               });
    keys.table("time", format.time, "The sensor's time", [&](Keys& table, TimeField& time) {
        describePlace(table, time.field);
        describeType(table, time.field.type,
                     [](NumberType type) { return isUnsigned(type) || isFloat(type); });
        describeOrder(table, time.field.order);
        describeTimeUnit(table, "unit", time.unit_s);
        length.check(table, "at", time.field.at, sizeOf(time.field.type));
    });
    keys.table("values", "What the taxels read", Need::required,
               [&](Keys& table) { describeValues(table, format, length, perGroup); });
    if (format.sync.empty() && format.end.empty() && format.checksum.type == ChecksumType::none)
        refuse(keys, "encoding", TaxelsText::tr("nothing shows where a frame begins"),
               TaxelsText::tr("sync, end or a checksum"));
}

/// "2..85" or "3"; false for anything else.
bool readColumns(const std::string& text, CsvFormat& format) {
    const std::size_t dots = text.find("..");
    const auto number = [](std::string_view part, std::size_t& value) {
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
        return error == std::errc() && end == part.data() + part.size() && value > 0 &&
               value <= kLongestFrame;
    };
    if (!number(std::string_view(text).substr(0, dots), format.firstColumn))
        return false;
    if (dots == std::string::npos)
        format.lastColumn = format.firstColumn;
    else if (!number(std::string_view(text).substr(dots + 2), format.lastColumn))
        return false;
    return format.firstColumn <= format.lastColumn;
}

void describeCsv(Keys& keys, CsvFormat& format) {
    std::string separator(1, format.separator);
    keys.text("separator", separator, "One character between two numbers; `\\t` for a tab", Need::optional);
    if (separator.size() != 1 || std::string_view("0123456789+-.eE\r\n").find(separator) != std::string::npos)
        refuse(keys, "separator",
               TaxelsText::tr("\"%1\" cannot separate numbers").arg(QString::fromStdString(separator)),
               TaxelsText::tr("one character"));
    else
        format.separator = separator.front();
    format.skip = 1;
    keys.whole("skip", format.skip, {0, 1000},
               "Lines at the start that are not frames; the first after connecting may be cut",
               Need::optional);
    std::string columns;
    keys.text("columns", columns, "Columns of the values, counted from 1, as `2..85`");
    if (!readColumns(columns, format)) {
        format.firstColumn = format.lastColumn = 1;
        refuse(keys, "columns",
               TaxelsText::tr("\"%1\" names no columns").arg(QString::fromStdString(columns)),
               TaxelsText::tr("the first and the last column, as \"2..85\""));
    }
    keys.whole("time_column", format.timeColumn, {0, kMostBytes}, "Column of the sensor's time; 0: none",
               Need::optional);
    describeTimeUnit(keys, "time_unit", format.timeUnit_s);
    if (format.timeColumn >= format.firstColumn && format.timeColumn <= format.lastColumn)
        refuse(keys, "time_column", TaxelsText::tr("a column cannot be a value and the time"),
               TaxelsText::tr("a column outside \"columns\""));
    describeScaling(keys, format.scaling);
}

void describePointer(Keys& keys, std::string_view key, std::string& pointer, std::string_view about,
                     Need need) {
    keys.text(key, pointer, about, need);
    if (!isJsonPointer(pointer)) {
        refuse(keys, key, TaxelsText::tr("\"%1\" is no JSON pointer").arg(QString::fromStdString(pointer)),
               TaxelsText::tr("a path as \"/sensors/0/data\""));
        pointer.clear();
    }
}

void describeJson(Keys& keys, JsonFormat& format, std::size_t perGroup) {
    describePointer(keys, "values", format.values, "JSON pointer to the list of values, as `/sensors/0/data`",
                    Need::required);
    keys.whole("count", format.count, {1, kMostBytes}, "Numbers in the list, all components counted");
    if (format.count % perGroup != 0)
        refuse(keys, "count",
               TaxelsText::tr("%1 numbers are not %2 for each taxel").arg(format.count).arg(perGroup),
               TaxelsText::tr("a multiple of %1").arg(perGroup));
    keys.flag("hex", format.hex,
              "The values are one text of hexadecimal 16-bit numbers with commas between them");
    describePointer(keys, "time", format.time, "JSON pointer to the sensor's time; otherwise there is none",
                    Need::optional);
    describeTimeUnit(keys, "time_unit", format.timeUnit_s);
    describePointer(keys, "counter", format.counter,
                    "JSON pointer to a whole number that counts the frames; otherwise there is none",
                    Need::optional);
    describeScaling(keys, format.scaling);
}

/// "AA 55" or "aa55" as bytes; nothing for anything else, or more than kMostMarkBytes.
std::optional<std::vector<std::uint8_t>> bytesOf(const std::string& hex) {
    std::string digits;
    std::ranges::copy_if(hex, std::back_inserter(digits), [](char c) { return c != ' '; });
    if (digits.size() % 2 != 0 || digits.size() > 2 * kMostMarkBytes)
        return std::nullopt;
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i < digits.size(); i += 2) {
        std::uint8_t byte = 0;
        const auto [end, error] = std::from_chars(&digits[i], &digits[i] + 2, byte, 16);
        if (error != std::errc() || end != &digits[i] + 2)
            return std::nullopt;
        bytes.push_back(byte);
    }
    return bytes;
}

} // namespace

void describeBytes(Keys& keys, std::string_view key, std::vector<std::uint8_t>& bytes,
                   std::string_view about) {
    std::string text;
    keys.text(key, text, about, Need::optional);
    if (auto found = bytesOf(text))
        bytes = std::move(*found);
    else
        refuse(keys, key,
               TaxelsText::tr("\"%1\" is not a list of hexadecimal bytes").arg(QString::fromStdString(text)),
               TaxelsText::tr("up to %1 bytes, as \"AA 55\"").arg(kMostMarkBytes));
}

void describeWebAddress(Keys& keys, std::string& url, std::string_view about, Need need) {
    keys.text("url", url, about, need);
    if (!link::isWebAddress(url))
        refuse(keys, "url",
               TaxelsText::tr("\"%1\" is no address of a WebSocket server").arg(QString::fromStdString(url)),
               TaxelsText::tr("ws://HOST:PORT or wss://HOST:PORT"));
}

void refuseWithoutThreshold(Keys& keys) {
    refuse(keys, "threshold", TaxelsText::tr("without a threshold it is not known which taxels are touched"),
           TaxelsText::tr("threshold = a number in the unit of the values, above the first table"));
}

void describeFrame(Keys& keys, FrameFormat& format, std::size_t perGroup) {
    keys.choose("encoding", format.index(), {"binary", "csv", "json"},
                "Bytes, lines of numbers, or one JSON document a line", Need::required,
                [&](Keys& chosen, std::size_t index) {
                    if (index == 0)
                        describeBinary(chosen, format.emplace<BinaryFormat>(), perGroup);
                    else if (index == 1)
                        describeCsv(chosen, format.emplace<CsvFormat>());
                    else
                        describeJson(chosen, format.emplace<JsonFormat>(), perGroup);
                });
}

} // namespace teleta::taxels
