// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/interface.h"
#include "devices/modbus/register_map.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace teleta::modbus {

/// How a server answered one request.
struct Answer {
    enum class Kind {
        done,
        exception, ///< the server refused; the connection is sound
        timedOut,  ///< no complete answer in time
        damaged,   ///< the answer does not match the request, or has a wrong checksum
        lost,      ///< the connection is gone
    };
    Kind kind = Kind::done;
    int exceptionCode = 0; ///< as in the protocol, with Kind::exception; 0: unknown to the protocol

    [[nodiscard]] bool done() const { return kind == Kind::done; }
    bool operator==(const Answer&) const = default;
};

/// The answer as a sentence for people, translated; empty when it was done. Thread: any.
[[nodiscard]] std::string describe(const Answer& answer);

/// One open connection to a Modbus server. Tests replace it with one that they play themselves. Every call
/// waits for the answer, at most for the timeout. Thread: one at a time.
class RegisterLink : public core::Interface {
public:
    /// Writes neighbouring holding registers in one request; 1 .. 123 words.
    [[nodiscard]] virtual Answer write(std::uint16_t address, std::span<const std::uint16_t> words) = 0;
    /// The same without waiting for an answer, as a last resort for a server that does not answer.
    virtual void writeUnanswered(std::uint16_t address, std::span<const std::uint16_t> words) = 0;
    /// Reads words.size() neighbouring registers, 1 .. 125; on failure words are untouched or partly written.
    [[nodiscard]] virtual Answer read(RegisterTable table, std::uint16_t address,
                                      std::span<std::uint16_t> words) = 0;
    /// Answers that were discarded because they arrived after their timeout, as far as that can be detected.
    [[nodiscard]] virtual std::uint64_t lateAnswers() const = 0;
};

/// Connects. Error: unavailable, with the reason. Thread: any, one at a time.
using LinkOpener = std::function<core::Expected<std::unique_ptr<RegisterLink>>()>;

} // namespace teleta::modbus
