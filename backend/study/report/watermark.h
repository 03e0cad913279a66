// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/trial.h"

#include <QString>

#include <optional>

namespace teleta::study {

/// Says across a figure that its data are not those of a study: PILOT or SIMULATED; otherwise empty.
[[nodiscard]] QString watermarkOf(std::optional<Mode> mode);

} // namespace teleta::study
