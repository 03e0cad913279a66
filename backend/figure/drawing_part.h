// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <string>

namespace teleta::figure {

/// What the module teleta_drawing exports: figure_file.h says what the functions do.
struct Drawing {
    core::Expected<std::string> (*pdf)(const std::string& svg);
    core::Expected<std::string> (*png)(const std::string& svg, double scale);
};

} // namespace teleta::figure

extern "C" {
[[gnu::visibility("default")]] extern const teleta::figure::Drawing teleta_drawing;
}
