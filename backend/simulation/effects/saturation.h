// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/simulation/base/effect.h"

namespace teleta::simulation {

/// Limits each reading to 0 .. full scale.
class Saturation : public Effect {
public:
    Saturation(std::string_view name, double fullScale_N);

    void apply(std::span<double> load_N) override;

private:
    double m_fullScale_N;
};

} // namespace teleta::simulation
