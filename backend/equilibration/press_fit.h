// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/equilibration/taxel_gains.h"

#include <cstddef>
#include <vector>

namespace teleta::equilibration {

/// What is known from one press.
struct PressFit {
    std::vector<TaxelState> states;
    std::vector<double> response; ///< mean 1 over the good taxels
    std::vector<double> error;    ///< of the response
    std::size_t frames = 0;
    double level = 0.0;
    double scatter = 0.0;
};

/// Fits the loads of the frames and the responses of the taxels of one press in turn; see findTaxelGains().
/// press: whole frames of `taxels` values. Error: refused, as for findTaxelGains(). Thread: any (pure).
[[nodiscard]] core::Expected<PressFit> fitPress(std::size_t taxels, const GainPress& press);

} // namespace teleta::equilibration
