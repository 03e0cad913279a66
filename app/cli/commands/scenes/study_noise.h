// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <cstdint>
#include <string>

namespace CLI {
class App;
}

namespace teleta::cli {

/// The part of `teleta study` that writes masking noise.
class StudyNoise {
public:
    void declare(CLI::App& app);
    [[nodiscard]] core::Expected<void> write() const;

private:
    std::string m_out;
    double m_level_dBFS = -20.0;
    std::uint64_t m_seed = 1;
    bool m_json = false;
};

} // namespace teleta::cli
