// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/ros/topic_names.h"
#include "devices/bracelet/bracelet_reports.h"
#include "devices/bracelet/hid_bracelet_file.h"
#include "devices/modbus/register_map.h"
#include "devices/mouse3d/mouse3d_reports.h"
#include "devices/ros/ros_arm_file.h"
#include "devices/wts/wts_codec.h"
#include "devices/wts/wts_config.h"
#include "devices/wts/wts_decoder.h"
#include "tests/fuzz/fuzz_check.h"
#include "tests/fuzz/fuzz_targets.h"

#include <algorithm>
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
