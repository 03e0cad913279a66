// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/devices/wts/wts_fuzz_target.h"

#include "devices/wts/wts_codec.h"
#include "devices/wts/wts_decoder.h"

#include <algorithm>
#include <cstdlib>
#include <span>
#include <vector>

namespace {

using namespace teleta::wts;

constexpr float kUntouched = -1.0F;

void require(bool condition) {
    if (!condition)
        std::abort();
}

void readAll(const Message& message) {
    for (const std::size_t cells : {0U, 1U, 84U}) {
        std::vector<float> guarded(cells + 1, kUntouched);
        const bool whole = readFrame(message.payload, std::span(guarded).first(cells)).has_value();
        require(guarded.back() == kUntouched);
        require(!whole || std::ranges::count(guarded, kUntouched) == 1);
    }
    if (const auto answer = readAnswer(message)) {
        require(answer->params.size() + 2 == message.payload.size());
        require(readMatrixInfo(answer->params).has_value() == (answer->params.size() == 10));
        require(readTemperature_C(answer->params).has_value() == (answer->params.size() == 2));
    }
}

void drain(MessageDecoder& decoder, MessageDecoder::Rest rest) {
    Message message;
    while (decoder.next(message, rest))
        readAll(message);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span bytes(data, size);
    MessageDecoder decoder;
    decoder.setMaximumPayload(256);
    for (std::size_t begin = 0; begin < size;) {
        const std::size_t count = std::min<std::size_t>(1 + bytes[begin], size - begin);
        decoder.feed(bytes.subspan(begin, count));
        drain(decoder, MessageDecoder::Rest::mayCome);
        begin += count;
        const MessageDecoder::Counters& counted = decoder.counters();
        require(counted.messageBytes + counted.droppedBytes + decoder.pendingBytes() == begin);
        // An incomplete message is all that waits.
        require(decoder.pendingBytes() < kHeaderBytes + 256 + kChecksumBytes);
    }
    drain(decoder, MessageDecoder::Rest::willNotCome);
    require(decoder.pendingBytes() == 0);
    return 0;
}
