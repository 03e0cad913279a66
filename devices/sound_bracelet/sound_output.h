// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/core/interface.h"
#include "devices/sound_bracelet/sound_bracelet_file.h"
#include "devices/sound_bracelet/tone_engine.h"

#include <cstdint>
#include <memory>
#include <string>

namespace teleta::sound {

/// Plays an engine's samples on a card, from a thread of its own, until it is destroyed. Faults go to the
/// engine. Thread: one at a time.
class SoundOutput : public core::Interface {
public:
    /// Looks for faults that no callback can see; they go to the engine.
    virtual void check() {}
    /// Which server or driver plays, and where, for people: "PipeWire, tactors".
    [[nodiscard]] virtual std::string where() const = 0;
    /// From a setpoint to its first sample at the coil, at most, as the server states it; nobody measured it:
    ///   period (periods + 1) + what the server or the card adds
    [[nodiscard]] virtual double statedLatency_s() const = 0;
};

/// How long a server or a card may take until it asks for samples as the file says.
inline constexpr std::int64_t kLongestOpening_ns = 2'000'000'000;

/// Opens the card of the file and plays. engine must outlive what is returned. Error: unavailable, the server
/// or the card is not there; refused, it does not fit what the file says.
[[nodiscard]] core::Expected<std::unique_ptr<SoundOutput>> openSoundOutput(const SoundBraceletFile& file,
                                                                           ToneEngine& engine);

/// What happened, a translated sentence. fault: not none.
[[nodiscard]] std::string describe(SoundFault fault);

} // namespace teleta::sound
