// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/protocol.h"

#include <string>

namespace teleta::study {

/// Three patterns, two conditions; practice once with feedback, test twice. settings: further keys.
inline Protocol smallProtocol(const std::string& window = "from_onset", const std::string& settings = "") {
    return parseProtocol("name = \"small\"\nstimulus_s = 2.0\nresponse_limit_s = 10.0\nresponse_window = \"" +
                             window + "\"\norder = \"full_random\"\n" + settings + R"(
[practice]
repetitions = 1
feedback = true
[test]
repetitions = 2
[masking_noise]
colour = "none"
[[task]]
id = "shape"
pattern = [{ letter = "A" }, { letter = "B" }, { letter = "C" }]
condition = [{ id = "static" }, { id = "dynamic" }]
)",
                         "small.toml")
        .value();
}

} // namespace teleta::study
