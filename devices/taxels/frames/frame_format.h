// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/taxels/frames/checksum.h"
#include "devices/taxels/frames/number_type.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace teleta::taxels {

/// Longest frame, line or message in bytes; what is longer is taken for noise.
inline constexpr std::size_t kLongestFrame = std::size_t{1} << 20U;

/// A number in a frame. at: of its first byte, from the frame's first; a negative one from its end.
struct NumberField {
    long long at = 0;
    NumberType type = NumberType::uint8;
    ByteOrder order = ByteOrder::little;
};

struct LengthField {
    /// What the number counts.
    enum class Counts {
        payload, ///< the bytes between it and the checksum, or the closing bytes
        rest,    ///< all bytes behind it
        frame,   ///< all bytes
    };

    NumberField field{.at = 0, .type = NumberType::uint16};
    Counts counts = Counts::payload;
};

/// The checksum over the bytes [from, to) of a frame.
struct ChecksumField {
    ChecksumType type = ChecksumType::none;
    long long at = 0;
    long long from = 0;
    long long to = 0;
    ByteOrder order = ByteOrder::little;
    std::uint32_t init = 0;
    std::uint32_t xorOut = 0;
};

/// The sensor's time; unit_s: of one step.
struct TimeField {
    NumberField field{.at = 0, .type = NumberType::uint32};
    double unit_s = 1e-3;
};

/// Numbers of one type in a frame: value i stands in group i / perGroup, whose first byte is
/// at + group * stride.
struct ValueField {
    NumberField field{.at = 0, .type = NumberType::uint16};
    std::size_t count = 1;
    std::size_t perGroup = 1;
    std::size_t stride = 0; ///< bytes; 0: the groups touch
    /// Numbers outside make a frame invalid.
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();

    [[nodiscard]] std::size_t groupBytes() const {
        return stride > 0 ? stride : perGroup * sizeOf(field.type);
    }
    /// From the first byte of the first number to behind the last byte of the last one.
    [[nodiscard]] std::size_t bytes() const;
};

/// value = scale * number + offset
struct Scaling {
    double scale = 1.0;
    double offset = 0.0;
};

struct BinaryFormat {
    std::vector<std::uint8_t> sync; ///< first bytes of each frame; may be empty
    std::vector<std::uint8_t> end;  ///< last bytes of each frame; may be empty
    std::size_t length = 0;         ///< of each frame; 0: as the length field says
    std::optional<LengthField> lengthField;
    ChecksumField checksum;
    std::optional<NumberField> counter;
    std::optional<TimeField> time;
    ValueField values;
    Scaling scaling = {};
    std::vector<ValueField> others; ///< further numbers, which come behind the values and are not scaled

    /// Bytes that show that a frame is one: below three, two frames in a row have to be right.
    [[nodiscard]] std::size_t evidence() const { return sync.size() + end.size() + sizeOf(checksum.type); }
};

/// Lines of numbers between separators. Columns count from 1.
struct CsvFormat {
    char separator = ',';
    std::size_t skip = 0; ///< lines at the begin of a connection that are no frames
    std::size_t firstColumn = 1;
    std::size_t lastColumn = 1;
    std::size_t timeColumn = 0; ///< 0: none
    /// Of so many columns in a row the first perGroup are values, the rest other numbers, which come behind
    /// them and are not scaled.
    std::size_t groupColumns = 1;
    std::size_t perGroup = 1;
    double timeUnit_s = 1.0;
    Scaling scaling = {};
};

/// One of several sensors in a JSON document, with what it says of itself: "taxels", a number, and "model".
struct JsonSensor {
    std::string place = {}; ///< pointer to it; a document without it is another frame
    std::size_t taxels = 0; ///< that it has to have, where it tells them
    std::string model = {}; ///< likewise; empty: the first one that it tells
};

/// One JSON document a line. Pointers as RFC 6901 has them. NaN and Infinity as Python writes them, which are
/// no JSON, are read as null.
struct JsonFormat {
    std::string values = {};    ///< to an array of numbers, or a text of hexadecimal numbers with commas
    std::string time = {};      ///< to a number; empty: none
    std::string otherTime = {}; ///< to a number that counts where there is no time; empty: none
    bool mayLackTime = false;
    std::optional<JsonSensor> sensor = {}; ///< nothing: a document without the values is another frame
    std::string counter = {};              ///< to a whole number that counts the frames; empty: none
    double timeUnit_s = 1.0;
    bool hex = false;
    std::size_t count = 1; ///< of values
    Scaling scaling = {};
};

using FrameFormat = std::variant<BinaryFormat, CsvFormat, JsonFormat>;

/// The position of a field in a frame of this length; nothing: it does not fit.
[[nodiscard]] std::optional<std::size_t> positionOf(long long at, std::size_t bytes, std::size_t length);

/// Whether the text can be a JSON pointer.
[[nodiscard]] bool isJsonPointer(const std::string& text);

} // namespace teleta::taxels
