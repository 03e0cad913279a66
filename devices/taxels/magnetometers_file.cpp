// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/magnetometers_file.h"

#include "devices/taxels/frames/frame_decoder.h"
#include "devices/taxels/taxels_text.h"

#include <optional>
#include <string>

namespace teleta::taxels {

namespace {

using core::Need;
using core::NumberRange;

constexpr std::size_t kAxes = 3;
constexpr std::size_t kNumbers = 4; ///< of a chip
constexpr std::size_t kChipBytes = 16;
constexpr double kMostField_uT = 1e6;
constexpr double kColdest_degC = -40.0;
constexpr double kHottest_degC = 125.0;
constexpr int kRestFrames = 50;
constexpr int kFewestGuessed = 4;
constexpr std::uint64_t kFramesForGuess = 3;

enum class Format { binary, reskinText };

CsvFormat reskinText(std::size_t chips) {
    return {.separator = '\t',
            .skip = 1,
            .firstColumn = 1,
            .lastColumn = kNumbers * chips,
            .groupColumns = kNumbers,
            .perGroup = kAxes};
}

} // namespace

BinaryFormat magnetometerFrames(std::size_t chips) {
    BinaryFormat format;
    format.end = {0x0D, 0x0A};
    format.length = kChipBytes * chips + format.end.size();
    format.values = {.field = {.at = 4, .type = NumberType::float32},
                     .count = kAxes * chips,
                     .perGroup = kAxes,
                     .stride = kChipBytes,
                     .low = -kMostField_uT,
                     .high = kMostField_uT};
    format.others = {{.field = {.at = 0, .type = NumberType::float32},
                      .count = chips,
                      .perGroup = 1,
                      .stride = kChipBytes,
                      .low = kColdest_degC,
                      .high = kHottest_degC}};
    return format;
}

std::optional<int> chipsOf(std::span<const std::uint8_t> bytes) {
    std::optional<int> best;
    std::uint64_t most = 0;
    for (int chips = kFewestGuessed; chips <= kMostChips; ++chips) {
        const auto decoder =
            makeDecoder(magnetometerFrames(static_cast<std::size_t>(chips)), FrameDecoder::Framing::stream);
        decoder->feed(bytes);
        DecodedFrame frame;
        while (decoder->next(frame)) {
        }
        const FrameDecoder::Counters& counted = decoder->counters();
        if (counted.frames >= kFramesForGuess && counted.frameBytes > most) {
            most = counted.frameBytes;
            best = chips;
        }
    }
    return best;
}

void MagnetometersFile::describeKeys(core::Keys& keys) {
    keys.word("kind", "magnetometers", "A skin of magnetometers, as AnySkin or ReSkin");
    keys.text("name", taxels.name, "Name on the screen");
    link::SerialAddress serial;
    keys.text("path", serial.path, "Path of its serial port");
    keys.whole("baud", serial.baud, {9600, 4'000'000}, "Bits a second", Need::optional);
    taxels.address = serial;
    std::optional<int> told;
    keys.whole("chips", told, {kFewestChips, kMostChips},
               "Magnetometers on the board; otherwise as many as there are positions");
    auto format = Format::binary;
    keys.choice("format", format,
                {{"binary", "Four float32 a chip, t, x, y, z, then `0D 0A`, as AnySkin and ReSkin send it"},
                 {"reskin_text", "x, y, z, t of each chip between tabs. The text of AnySkin has no separator "
                                 "between chips and cannot be read: load its binary sketch"}},
                "What the board sends");
    taxels.grid.setComponents(TaxelGrid::kMostComponents);
    taxels.grid.setUnit("µT");
    const bool hasPositions =
        taxels.grid.describePositions(keys, static_cast<std::size_t>(told.value_or(0)), Need::required);
    if (hasPositions && taxels.grid.taxels() > kMostChips)
        refuse(keys, "positions_mm", TaxelsText::tr("there are %1 positions").arg(taxels.grid.taxels()),
               TaxelsText::tr("at most %1 chips").arg(kMostChips));
    const std::size_t chips = taxels.grid.taxels();
    taxels.format = format == Format::binary ? FrameFormat(magnetometerFrames(chips)) : reskinText(chips);
    taxels.temperatures = chips;
    taxels.grid.describeAxes(keys);
    double threshold_uT = 0.0;
    keys.number("threshold_uT", threshold_uT, NumberRange::positive(),
                "Change of the field from which a chip counts as touched");
    taxels.threshold = threshold_uT;
    keys.number("rate_Hz", taxels.rate_Hz, NumberRange::between(0.0, 1e5),
                "Frames a second that the board sends; 0: not known", Need::optional);
    taxels.restFrames = kRestFrames;
    keys.whole("rest_frames", taxels.restFrames, {1, 10'000},
               "Frames read at opening; their median becomes the tare", Need::optional);
    taxels.describeLoads(keys);
}

} // namespace teleta::taxels
