// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/frames/binary_decoder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::taxels {

namespace {

constexpr std::size_t kEvidence = 3;

constexpr std::size_t kOtherFrames = 256;

/// Bytes of the checksum and what stands behind it, or else of the end.
std::size_t closingOf(const BinaryFormat& format) {
    const ChecksumField& checksum = format.checksum;
    const bool isAtEnd = checksum.type != ChecksumType::none && checksum.at < 0;
    return isAtEnd ? static_cast<std::size_t>(-checksum.at) : format.end.size();
}

/// The shortest frame that holds a field.
std::size_t lengthFor(long long at, std::size_t bytes) {
    return at < 0 ? static_cast<std::size_t>(-at) : static_cast<std::size_t>(at) + bytes;
}

std::size_t longestOf(const BinaryFormat& format) {
    std::size_t needed = lengthFor(format.values.field.at, format.values.bytes());
    for (const ValueField& other : format.others)
        needed = std::max(needed, lengthFor(other.field.at, other.bytes()));
    if (format.counter)
        needed = std::max(needed, lengthFor(format.counter->at, sizeOf(format.counter->type)));
    if (format.time)
        needed = std::max(needed, lengthFor(format.time->field.at, sizeOf(format.time->field.type)));
    return std::min(2 * needed + kOtherFrames, kLongestFrame);
}

std::size_t lengthOf(const LengthField& field, std::uint32_t number, std::size_t fieldEnd,
                     std::size_t closing) {
    switch (field.counts) {
    case LengthField::Counts::payload:
        return fieldEnd + number + closing;
    case LengthField::Counts::rest:
        return fieldEnd + number;
    case LengthField::Counts::frame:
        break;
    }
    return number;
}

} // namespace

BinaryDecoder::BinaryDecoder(BinaryFormat format, Framing framing)
    : m_format(std::move(format))
    , m_closing(closingOf(m_format))
    , m_longest(longestOf(m_format))
    , m_datagrams(framing == Framing::datagrams)
    , m_needsTwo(!m_datagrams && m_format.evidence() < kEvidence) {
}

bool BinaryDecoder::next(DecodedFrame& frame, Rest rest) {
    while (findSync(rest)) {
        std::size_t length = 0;
        const std::span<const std::uint8_t> bytes = pending();
        Verdict verdict = judge(bytes, length, &frame, &m_counters);
        if (verdict == Verdict::incomplete) {
            if (rest == Rest::mayCome && !m_datagrams)
                return false;
            verdict = Verdict::wrong;
        }
        if (m_datagrams && length != bytes.size())
            verdict = Verdict::wrong;
        if (verdict == Verdict::wrong) {
            refuse();
            continue;
        }
        if (m_needsTwo && !m_locked) {
            std::size_t second = 0;
            const Verdict following = judge(bytes.subspan(length), second, nullptr, nullptr);
            if (following == Verdict::incomplete && rest == Rest::mayCome)
                return false;
            // Silence right behind a frame shows its end as well.
            const bool isAlone = bytes.size() == length;
            if (following == Verdict::wrong || (following == Verdict::incomplete && !isAlone)) {
                refuse();
                continue;
            }
            m_locked = true;
        }
        take(length, verdict == Verdict::other);
        if (verdict == Verdict::frame)
            return true;
    }
    return false;
}

bool BinaryDecoder::findSync(Rest rest) {
    const std::span<const std::uint8_t> bytes = pending();
    const std::vector<std::uint8_t>& sync = m_format.sync;
    auto found = bytes.begin();
    if (!sync.empty())
        found = std::search(bytes.begin(), bytes.end(), sync.begin(), sync.end());
    if (found == bytes.end()) {
        // The first bytes of a frame may stand at the end.
        std::size_t kept = rest == Rest::mayCome && !m_datagrams ? std::min(bytes.size(), sync.size()) : 0;
        while (kept > 0 &&
               (kept == sync.size() ||
                !std::equal(bytes.end() - static_cast<std::ptrdiff_t>(kept), bytes.end(), sync.begin())))
            --kept;
        if (bytes.size() > kept) {
            m_locked = false;
            drop(bytes.size() - kept);
        }
        return false;
    }
    if (found != bytes.begin()) {
        m_locked = false;
        drop(m_datagrams ? bytes.size() : static_cast<std::size_t>(found - bytes.begin()));
    }
    return pendingBytes() > 0;
}

std::optional<std::size_t> BinaryDecoder::lengthAt(std::span<const std::uint8_t> bytes) const {
    if (!m_format.lengthField)
        return m_format.length;
    const NumberField& field = m_format.lengthField->field;
    const std::size_t size = sizeOf(field.type);
    const std::size_t end = static_cast<std::size_t>(field.at) + size;
    if (bytes.size() < end)
        return std::nullopt;
    const std::size_t length = lengthOf(
        *m_format.lengthField, readBits(bytes.subspan(end - size), size, field.order), end, m_closing);
    return length >= std::max(end + m_closing, m_format.sync.size()) && length <= m_longest ? length : 0;
}

BinaryDecoder::Verdict BinaryDecoder::judge(std::span<const std::uint8_t> bytes, std::size_t& length,
                                            DecodedFrame* frame, Counters* counters) const {
    const std::vector<std::uint8_t>& sync = m_format.sync;
    const std::size_t common = std::min(bytes.size(), sync.size());
    if (!std::equal(sync.begin(), sync.begin() + static_cast<std::ptrdiff_t>(common), bytes.begin()))
        return Verdict::wrong;
    const std::optional<std::size_t> found = lengthAt(bytes);
    if (!found)
        return Verdict::incomplete;
    length = *found;
    if (length == 0) {
        if (counters != nullptr)
            ++counters->badSizes;
        return Verdict::wrong;
    }
    if (bytes.size() < length)
        return Verdict::incomplete;
    const std::span<const std::uint8_t> whole = bytes.first(length);
    if (!std::equal(m_format.end.rbegin(), m_format.end.rend(), whole.rbegin())) {
        if (counters != nullptr)
            ++counters->badEnds;
        return Verdict::wrong;
    }
    const ChecksumField& checksum = m_format.checksum;
    if (const std::size_t size = sizeOf(checksum.type); size > 0) {
        const auto at = positionOf(checksum.at, size, length);
        const auto from = positionOf(checksum.from, 0, length);
        const auto to = positionOf(checksum.to, 0, length);
        const bool isRight =
            at && from && to && *from <= *to &&
            readBits(whole.subspan(*at), size, checksum.order) ==
                checksumOf(whole.subspan(*from, *to - *from), checksum.type, checksum.init, checksum.xorOut);
        if (!isRight) {
            if (counters != nullptr)
                ++counters->badChecksums;
            return Verdict::wrong;
        }
    }
    // In a frame of another length, the checksum may stand where numbers would be.
    const auto fitsBytes = [&](long long at, std::size_t size) {
        const std::size_t room = m_format.lengthField && at >= 0 ? length - m_closing : length;
        return positionOf(at, size, room).has_value();
    };
    const auto fits = [&](const ValueField& field) { return fitsBytes(field.field.at, field.bytes()); };
    const auto fitsNumber = [&](const NumberField& field) { return fitsBytes(field.at, sizeOf(field.type)); };
    if (!fits(m_format.values) || !std::ranges::all_of(m_format.others, fits) ||
        (m_format.counter && !fitsNumber(*m_format.counter)) ||
        (m_format.time && !fitsNumber(m_format.time->field)))
        return Verdict::other;

    if (frame != nullptr) {
        frame->values.clear();
        frame->counter.reset();
        frame->ticks.reset();
        frame->time_s.reset();
    }
    bool isRight = readValues(whole, m_format.values, m_format.scaling, frame);
    for (const ValueField& other : m_format.others)
        isRight = isRight && readValues(whole, other, {}, frame);
    if (frame != nullptr) {
        if (m_format.counter) {
            const NumberField& field = *m_format.counter;
            const std::size_t size = sizeOf(field.type);
            frame->counter = readBits(whole.subspan(*positionOf(field.at, size, length)), size, field.order);
        }
        if (m_format.time) {
            const NumberField& field = m_format.time->field;
            const std::size_t size = sizeOf(field.type);
            const std::span<const std::uint8_t> place = whole.subspan(*positionOf(field.at, size, length));
            if (isFloat(field.type)) {
                frame->time_s = readNumber(place, field.type, field.order) * m_format.time->unit_s;
                isRight = isRight && std::isfinite(*frame->time_s);
            } else {
                frame->ticks = readBits(place, size, field.order);
            }
        }
    }
    if (isRight)
        return Verdict::frame;
    if (counters != nullptr)
        ++counters->badValues;
    return Verdict::wrong;
}

bool BinaryDecoder::readValues(std::span<const std::uint8_t> bytes, const ValueField& field,
                               const Scaling& scaling, DecodedFrame* frame) const {
    const std::size_t begin = *positionOf(field.field.at, field.bytes(), bytes.size());
    const std::size_t size = sizeOf(field.field.type);
    for (std::size_t i = 0; i < field.count; ++i) {
        const std::size_t at = begin + i / field.perGroup * field.groupBytes() + i % field.perGroup * size;
        const double number = readNumber(bytes.subspan(at), field.field.type, field.field.order);
        if (!std::isfinite(number))
            return false;
        const auto value = static_cast<float>(scaling.scale * number + scaling.offset);
        if (!std::isfinite(value) || number < field.low || number > field.high)
            return false;
        if (frame != nullptr)
            frame->values.push_back(value);
    }
    return true;
}

void BinaryDecoder::refuse() {
    m_locked = false;
    drop(m_datagrams ? pendingBytes() : 1);
}

} // namespace teleta::taxels
