// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/bracelet/bracelet_port.h"
#include "backend/core/threads/stop_switch.h"
#include "devices/sound_bracelet/sound_bracelet_file.h"
#include "devices/sound_bracelet/sound_output.h"
#include "devices/sound_bracelet/tone_engine.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace teleta::sound {

/// Opens what plays an engine.
using OutputOpener =
    std::function<core::Expected<std::unique_ptr<SoundOutput>>(const SoundBraceletFile&, ToneEngine&)>;

/// A bracelet on a sound card. A frame is handed to the callback, which reports that it took it: nothing says
/// that a coil moved. After any fault the connection is lost. Thread: one at a time.
class SoundBraceletPort : public core::BraceletPort {
public:
    SoundBraceletPort(std::unique_ptr<ToneEngine> engine, std::unique_ptr<SoundOutput> output,
                      double period_s);
    /// Lets a ramp that was begun come to its end.
    ~SoundBraceletPort() override;

    [[nodiscard]] bool write(std::uint16_t sequence, const core::Drive& drive,
                             std::uint16_t timeout_ms) override;
    [[nodiscard]] Read read(core::BoardReport& report) override;
    [[nodiscard]] std::string failure() const override;

private:
    [[nodiscard]] bool isBroken();

    std::unique_ptr<ToneEngine> m_engine;
    std::unique_ptr<SoundOutput> m_output; ///< ends before the engine
    std::int64_t m_longestSilence_ns;
};

/// Opens the bracelet of a file, silent. stopSwitch must outlive the port.
[[nodiscard]] core::Expected<core::OpenedBracelet> openSoundBraceletPort(const SoundBraceletFile& file,
                                                                         const core::StopSwitch& stopSwitch,
                                                                         const OutputOpener& opener);

} // namespace teleta::sound
