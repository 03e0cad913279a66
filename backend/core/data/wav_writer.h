// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/data/output_file.h"
#include "backend/core/error.h"

#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace teleta::core {

/// Writes a WAV file of 16-bit PCM samples: one channel as plain PCM, more as WAVE_FORMAT_EXTENSIBLE without
/// speaker positions. The file appears under its name with finish(), see OutputFile. Thread: one.
class WavWriter {
public:
    /// Frames that fit into the 4 GiB of the format.
    [[nodiscard]] static std::uint64_t mostFrames(std::uint16_t channels);

    /// Creates the file and writes its header. frames: as many as will be written, at most mostFrames().
    [[nodiscard]] static Expected<WavWriter> create(const std::string& path, std::uint16_t channels,
                                                    std::uint32_t rate_Hz, std::uint64_t frames);

    /// One value a channel; 1 is full scale, what is beyond -1 .. 1 is clipped.
    void write(std::span<const double> frame);
    [[nodiscard]] bool failed() const { return m_output.failed(); }
    [[nodiscard]] Expected<void> finish() { return m_output.finish(); }

private:
    explicit WavWriter(OutputFile output)
        : m_output(std::move(output)) {}

    OutputFile m_output;
    std::string m_bytes; ///< of the frame at hand
};

} // namespace teleta::core
