// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "devices/link/byte_link.h"
#include "devices/wts/wts_codec.h"
#include "devices/wts/wts_config.h"
#include "devices/wts/wts_decoder.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace teleta::wts {

/// "the sensor is already running", or the number of a status without a name. Translated.
[[nodiscard]] std::string describe(Status status);

/// A connected sensor whose array is known: requests and answers over a link, and the frames that come alone.
/// Thread: one; wake pipes may be null and end any wait with the error "cancelled".
class WtsSession {
public:
    /// Connects, ends a transfer that an earlier program may have left running, and asks for the array.
    /// Error: as link::ByteLink::open; unavailable when nothing answers, or the sensor refuses; refused for
    /// an array without square cells or larger than core::ArrayLayout and one message allow.
    [[nodiscard]] static core::Expected<WtsSession> open(const WtsConfig& config, const link::WakePipe* wake);

    [[nodiscard]] const MatrixInfo& matrix() const { return m_matrix; }

    /// The sensor takes what it feels now as unloaded.
    [[nodiscard]] core::Expected<void> tare(const link::WakePipe* wake);
    [[nodiscard]] core::Expected<void> startFrames(const link::WakePipe* wake);
    /// Asks the sensor to be silent; waits for its answer, though not for long.
    void stopFrames();

    /// Waits for bytes of the sensor and feeds the decoder; readTime_ns() is then the time of the read.
    [[nodiscard]] link::ByteLink::Outcome receive(std::int64_t deadline_ns, const link::WakePipe* wake);
    [[nodiscard]] std::int64_t readTime_ns() const { return m_readTime_ns; }
    [[nodiscard]] MessageDecoder& decoder() { return m_decoder; }
    [[nodiscard]] const std::string& goneReason() const { return m_link.goneReason(); }

private:
    WtsSession(link::ByteLink link, const WtsConfig& config)
        : m_link(std::move(link))
        , m_config(config) {}

    [[nodiscard]] core::Expected<void> readMatrix(const link::WakePipe* wake);
    [[nodiscard]] core::Expected<Status> request(std::span<const std::uint8_t> bytes, int answer_ms,
                                                 int attempts, const link::WakePipe* wake);
    [[nodiscard]] core::Expected<void> demand(std::span<const std::uint8_t> bytes, int answer_ms,
                                              int attempts, const link::WakePipe* wake);
    [[nodiscard]] core::Unexpected failure(link::ByteLink::Outcome outcome) const;

    link::ByteLink m_link;
    WtsConfig m_config;
    MessageDecoder m_decoder;
    MatrixInfo m_matrix;
    std::vector<std::uint8_t> m_answer; ///< parameters of the newest one
    std::array<std::uint8_t, 4096> m_read{};
    std::int64_t m_readTime_ns = 0;
};

} // namespace teleta::wts
