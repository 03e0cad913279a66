// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/interface.h"

#include <cstdint>
#include <optional>
#include <string>

namespace teleta::core {

/// What happened, for a recorder outside this program.
struct TriggerEvent {
    enum class Kind {
        session,    ///< a session begins or goes on after an interruption
        sessionEnd, ///< it ends
        pause,
        goOn,
        fault,    ///< a fault of the device, or an abort
        stimulus, ///< index: stimulus or target, at its confirmed onset
        answer,   ///< index: the answer
        noAnswer, ///< the time was over
    };
    Kind kind = Kind::session;
    std::size_t index = 0;           ///< from 1; of stimulus and answer
    std::string session = {};        ///< its id
    std::size_t trial = 0;           ///< number in its phase, from 1; 0: outside a trial
    std::optional<float> level = {}; ///< of the stimulus; empty: it has none
    std::int64_t time_ns = 0;        ///< steady clock: when it happened

    /// The byte of a serial line: 1 session, 2 its end, 3 pause, 4 go on, 5 fault or abort, 100 + index for
    /// a stimulus, 200 + index for an answer, 200 for none. Indices are cut off at 99 and 55.
    [[nodiscard]] std::uint8_t byte() const;
    /// session, end, pause, go_on, fault, stimulus_3, answer_3, no_answer.
    [[nodiscard]] std::string word() const;
};

/// Where triggers go. A study's settings.
struct TriggerSettings {
    enum class Kind { none, serial, osc };
    Kind kind = Kind::none;
    std::string device;             ///< of a serial port: /dev/ttyUSB0
    double pulse_ms = 5.0;          ///< after which the byte 0 follows; 0: never
    std::string host = "127.0.0.1"; ///< of OSC
    std::uint16_t port = 9000;

    friend bool operator==(const TriggerSettings&, const TriggerSettings&) = default;
};

/// An open line for triggers. Thread: that of its owner.
class TriggerPort : public Interface {
public:
    /// Writes an event; it has left the program when this returns. Error: ioFailed, the device having gone.
    [[nodiscard]] virtual Expected<void> write(const TriggerEvent& event) = 0;
    /// How long a written byte stays before clear() is due; 0: clear() is not needed.
    [[nodiscard]] virtual std::int64_t pulse_ns() const { return 0; }
    [[nodiscard]] virtual Expected<void> clear() { return {}; }
};

} // namespace teleta::core
