// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/ros/topic_names.h"
#include "devices/bracelet/bracelet_reports.h"
#include "devices/bracelet/hid_bracelet_file.h"
#include "devices/modbus/register_map.h"
#include "devices/mouse3d/mouse3d_reports.h"
#include "devices/ros/files/ros_arm_file.h"
#include "devices/sound_bracelet/sound_bracelet_file.h"
#include "devices/taxels/frames/frame_decoder.h"
#include "devices/taxels/taxels_file.h"
#include "devices/wts/wts_codec.h"
#include "devices/wts/wts_config.h"
#include "devices/wts/wts_decoder.h"
#include "tests/fuzz/fuzz_check.h"
#include "tests/fuzz/fuzz_targets.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace teleta::fuzz {

namespace {

constexpr float kUntouched = -1.0F;

/// Every reader of payloads, with arrays of several sizes.
void readPayload(const wts::Message& message) {
    for (const std::size_t cells : {0U, 1U, 84U}) {
        std::vector<float> guarded(cells + 1, kUntouched);
        const bool whole = wts::readFrame(message.payload, std::span(guarded).first(cells)).has_value();
        require(guarded.back() == kUntouched, "a frame stays within its cells");
        require(!whole || std::ranges::count(guarded, kUntouched) == 1, "a whole frame fills its cells");
    }
    if (const auto answer = wts::readAnswer(message)) {
        require(answer->params.size() + 2 == message.payload.size(), "an answer has a status and the rest");
        require(wts::readMatrixInfo(answer->params).has_value() == (answer->params.size() == 10),
                "a matrix info has ten bytes");
    }
}

std::size_t drain(wts::MessageDecoder& decoder, wts::MessageDecoder::Rest rest) {
    std::size_t messages = 0;
    for (wts::Message message; decoder.next(message, rest); ++messages)
        readPayload(message);
    return messages;
}

void requireWritten(const modbus::RegisterMap& map) {
    constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
    for (const double intensity : {-1.0, 0.0, 1e-9, 0.5, 1.0, 2.0, kNothing}) {
        core::Intensities intensities;
        intensities.fill(intensity);
        require(modbus::tactorWords(*map.tactors, intensities).size() == map.tactors->registers(),
                "a frame fills its registers");
    }
}

void requireRead(const modbus::RegisterMap& map) {
    constexpr int kMostRegisters = 125;
    std::multiset<std::size_t> brought;
    for (const modbus::ReadRequest& request : modbus::planReads(map.inputs)) {
        require(request.count > 0 && request.count <= kMostRegisters,
                "a read is as long as the protocol allows");
        require(request.address + request.count <= 0x10000, "a read stays within the addresses");
        for (const std::size_t i : request.inputs) {
            const modbus::InputRegister& input = map.inputs.at(i);
            require(input.table == request.table && input.address >= request.address &&
                        input.address + modbus::registersOf(input.format.type) <=
                            static_cast<std::size_t>(request.address + request.count),
                    "a read brings what it says");
        }
        brought.insert(request.inputs.begin(), request.inputs.end());
    }
    require(brought.size() == map.inputs.size(), "every input is read once");
}

} // namespace

// In pieces whose sizes are taken from the bytes.
bool wtsFrames(Bytes bytes) {
    constexpr std::size_t kLargest = 256;
    wts::MessageDecoder decoder;
    decoder.setMaximumPayload(kLargest);
    std::size_t messages = 0;
    for (std::size_t begin = 0; begin < bytes.size();) {
        const std::size_t count = std::min<std::size_t>(1 + bytes[begin], bytes.size() - begin);
        decoder.feed(bytes.subspan(begin, count));
        messages += drain(decoder, wts::MessageDecoder::Rest::mayCome);
        begin += count;
        const wts::MessageDecoder::Counters& counted = decoder.counters();
        require(counted.messageBytes + counted.droppedBytes + decoder.pendingBytes() == begin,
                "the account of the bytes closes");
        require(decoder.pendingBytes() < wts::kHeaderBytes + kLargest + wts::kChecksumBytes,
                "an incomplete message is all that waits");
    }
    messages += drain(decoder, wts::MessageDecoder::Rest::willNotCome);
    require(decoder.pendingBytes() == 0, "nothing waits at the end");
    return messages > 0;
}

namespace {

/// In pieces whose sizes are taken from the bytes; the account of the bytes has to close at each.
std::size_t decodeInPieces(const taxels::FrameFormat& format, taxels::FrameDecoder::Framing framing,
                           Bytes bytes) {
    using taxels::FrameDecoder;
    const auto decoder = taxels::makeDecoder(format, framing);
    const std::size_t values = taxels::valuesOf(format);
    taxels::DecodedFrame frame;
    std::size_t frames = 0;
    std::uint64_t end = 0;
    const auto drain = [&](FrameDecoder::Rest rest) {
        for (; decoder->next(frame, rest); ++frames) {
            require(frame.values.size() >= values, "a frame has all its values");
            require(std::ranges::all_of(frame.values, [](float value) { return std::isfinite(value); }),
                    "a value is a number");
            require(decoder->frameBegin() >= end, "frames follow each other");
            end = decoder->frameBegin() + decoder->frameSize();
        }
    };
    for (std::size_t begin = 0; begin < bytes.size();) {
        const std::size_t count = std::min<std::size_t>(1 + bytes[begin], bytes.size() - begin);
        decoder->feed(bytes.subspan(begin, count));
        drain(FrameDecoder::Rest::mayCome);
        begin += count;
        const FrameDecoder::Counters& counted = decoder->counters();
        require(counted.frameBytes + counted.droppedBytes + decoder->pendingBytes() == begin,
                "the account of the bytes closes");
        require(end <= begin, "a frame is among the bytes");
    }
    drain(FrameDecoder::Rest::willNotCome);
    require(decoder->pendingBytes() == 0, "nothing waits at the end");
    return frames;
}

/// Formats of all encodings and of each way to find a frame.
std::vector<taxels::FrameFormat> knownFormats() {
    using namespace taxels;
    BinaryFormat fixed;
    fixed.sync = {0xAA, 0x55};
    fixed.length = 9;
    fixed.checksum = {.type = ChecksumType::sum8, .at = -1, .from = 2, .to = -1};
    fixed.counter = NumberField{.at = 2};
    fixed.time = TimeField{.field = {.at = 3, .type = NumberType::uint16}};
    fixed.values = {.field = {.at = 5, .type = NumberType::uint8}, .count = 3};
    BinaryFormat counted;
    counted.sync = {0x7E};
    counted.end = {0x0A};
    counted.lengthField = LengthField{.field = {.at = 1, .type = NumberType::uint16}};
    counted.values = {.field = {.at = -5, .type = NumberType::int16}, .count = 2};
    BinaryFormat skin;
    skin.end = {0x0D, 0x0A};
    skin.length = 34;
    skin.values = {.field = {.at = 4, .type = NumberType::float32}, .count = 6, .perGroup = 3, .stride = 16};
    skin.others = {{.field = {.at = 0, .type = NumberType::float32}, .count = 2, .stride = 16}};
    return {fixed,
            counted,
            skin,
            CsvFormat{.skip = 0, .firstColumn = 2, .lastColumn = 3, .timeColumn = 1},
            JsonFormat{.values = "/v", .time = "/t", .count = 2},
            JsonFormat{.values = "/1/data", .hex = true, .count = 3}};
}

} // namespace

// All formats read the same bytes.
bool taxelStream(Bytes bytes) {
    std::size_t frames = 0;
    for (const taxels::FrameFormat& format : knownFormats()) {
        frames += decodeInPieces(format, taxels::FrameDecoder::Framing::stream, bytes);
        frames += decodeInPieces(format, taxels::FrameDecoder::Framing::datagrams, bytes);
    }
    return frames > 0;
}

// A description, and what it makes of its own text as bytes.
bool taxelsFile(Bytes bytes) {
    // By its bits: comparing NaN would raise what the traps of these tests wait for.
    const auto isTaxel = [](float load) {
        constexpr std::uint32_t kNotFinite = 0x7F80'0000U;
        return (std::bit_cast<std::uint32_t>(load) & kNotFinite) != kNotFinite;
    };
    const core::Expected<taxels::TaxelsFile> file = taxels::parseTaxels(textOf(bytes), kInput);
    if (!file) {
        requireExplained(file.error());
        return false;
    }
    require(!file->name.empty(), "an array has a name");
    require(taxels::valuesOf(file->format) == file->grid.values(), "a frame has the numbers of the layout");
    require(file->touchedFrom() > 0.0, "a threshold is positive");
    constexpr std::size_t kMostShown = 4096;
    if (file->grid.values() <= kMostShown) {
        (void)decodeInPieces(file->format, taxels::FrameDecoder::Framing::stream, bytes);
        std::vector<float> loads(file->grid.layout().values(), kUntouched);
        file->grid.place(std::vector<float>(file->grid.values(), 1.0F), loads);
        require(static_cast<std::size_t>(std::ranges::count_if(loads, isTaxel)) == file->grid.values(),
                "each taxel has a place of its own");
    }
    return true;
}

bool hidReports(Bytes bytes) {
    mouse3d::RawAxes axes;
    const mouse3d::RawAxes before = axes;
    const mouse3d::ReportKind kind = mouse3d::decodeReport(bytes, axes);
    require(kind == mouse3d::ReportKind::axes || kind == mouse3d::ReportKind::buttons || axes == before,
            "only a whole report changes something");
    const auto report = bracelet::decodeReport(bytes);
    const auto identity = bracelet::decodeIdentity(bytes);
    require(!identity ||
                (!identity->serial.empty() && identity->serial.size() <= 16 && identity->highestDrive > 0 &&
                 identity->maximumRate_Hz > 0 && identity->longestTimeout_ms > 0),
            "an identity makes sense");
    return kind == mouse3d::ReportKind::axes || kind == mouse3d::ReportKind::buttons || report || identity;
}

bool hidBraceletFile(Bytes bytes) {
    const core::Expected<bracelet::HidBraceletFile> file = bracelet::parseHidBracelet(textOf(bytes), kInput);
    if (!file) {
        requireExplained(file.error());
        return false;
    }
    require(!file->name.empty() && file->config.vendorId > 0 && file->config.productId > 0,
            "a bracelet has a name and ids");
    return true;
}

bool soundBraceletFile(Bytes bytes) {
    const core::Expected<sound::SoundBraceletFile> file = sound::parseSoundBracelet(textOf(bytes), kInput);
    if (!file) {
        requireExplained(file.error());
        return false;
    }
    require(!file->name.empty() && file->period_s() > 0.0, "a bracelet has a name and a period");
    for (std::size_t i = 0; i < file->tones.size(); ++i) {
        const sound::ToneSettings& tone = file->tones[i];
        require(file->channels[i] >= 1 && std::ranges::count(file->channels, file->channels[i]) == 1,
                "each tactor has an output of its own");
        require(tone.fullScale > 0.0 && tone.fullScale <= 0.9 && tone.gain >= 0.0 && tone.gain <= 1.0,
                "a sample is never too large");
        require(tone.ramp_s >= tone.shortestRamp_s() - 1e-9, "a ramp does not click");
    }
    return true;
}

bool rosArmFile(Bytes bytes) {
    const core::Expected<ros_arm::RosArmFile> file = ros_arm::parseRosArm(textOf(bytes), kInput);
    if (!file) {
        requireExplained(file.error());
        return false;
    }
    const arm_model::MotionLimits& limits = file->limits;
    require(!file->name.empty() && !file->baseFrame.empty() && !file->tipFrame.empty(),
            "an arm has a name and two frames");
    require(ros::isTopicName(file->jointStates) && ros::isTopicName(file->controller),
            "topics have names of topics");
    require(file->jointTimeout_s > 0.0 && file->jointTimeout_s <= 1.0, "joints grow old within a second");
    for (const double limit :
         {limits.speedScale, limits.acceleration_radPerS2, limits.deceleration_radPerS2, limits.leash_rad,
          limits.jointMargin_rad, limits.tipSpeed_mPerS, limits.tipTurn_radPerS})
        require(std::isfinite(limit) && limit > 0.0, "limits are positive");
    require(limits.speedScale <= 1.0 && limits.stopDeceleration_radPerS2 >= limits.deceleration_radPerS2,
            "limits do not contradict each other");
    require(!limits.box_m || !limits.box_m->isEmpty(), "a box has room");
    return true;
}

bool registerMap(Bytes bytes) {
    const std::string text = textOf(bytes);
    if (const auto address = wts::parseWtsAddress(text); !address)
        require(!address.error().message.empty(), "an error has a message");
    const core::Expected<modbus::RegisterMap> map = modbus::parseRegisterMap(text, kInput);
    if (!map) {
        requireExplained(map.error());
        return false;
    }
    require(!modbus::linkName(*map).empty(), "a link has a name");
    if (map->tactors)
        requireWritten(*map);
    requireRead(*map);
    return true;
}

} // namespace teleta::fuzz
