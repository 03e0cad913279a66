// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/equilibration/taxel_gains.h"

#include <cstddef>
#include <vector>

namespace teleta::equilibration {

/// What one press tells.
struct PressFit {
    std::vector<TaxelState> states;
    std::vector<double> response; ///< mean 1 over the good taxels
    std::vector<double> error;    ///< of the response
    std::size_t frames = 0;
    double level = 0.0;
    double scatter = 0.0;
};

/// Loads of the frames and responses of the taxels of one press, fitted in turn; see findTaxelGains(). The
/// press is whole frames of so many taxels. Error: refused. Thread: any (pure).
[[nodiscard]] core::Expected<PressFit> fitPress(std::size_t taxels, const GainPress& press);

} // namespace teleta::equilibration
