// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/stiffness/touch_equations.h"

#include <algorithm>
#include <cmath>

namespace teleta::stiffness {

tl::expected<Compliance, Refusal> objectCompliance(const Compliance& total, double link_NPerM,
                                                   double linkSe_NPerM) {
    if (!std::isfinite(total.value_mPerN) || !std::isfinite(total.se_mPerN.value_or(0.0)) ||
        !std::isfinite(link_NPerM) || !std::isfinite(linkSe_NPerM))
        return tl::unexpected(Refusal::notFinite);
    if (link_NPerM <= 0.0)
        return tl::unexpected(Refusal::notPositive);
    if (total.se_mPerN.value_or(0.0) < 0.0 || linkSe_NPerM < 0.0)
        return tl::unexpected(Refusal::negativeUncertainty);

    Compliance object = total;
    object.value_mPerN = total.value_mPerN - 1.0 / link_NPerM;
    if (total.se_mPerN)
        object.se_mPerN = std::hypot(*total.se_mPerN, linkSe_NPerM / link_NPerM / link_NPerM);
    return object;
}

Stiffness stiffnessFromCompliance(const Compliance& compliance, double link_NPerM) {
    const double resolution_mPerN = kComplianceResolution / link_NPerM;
    const double c_mPerN = compliance.value_mPerN;
    Stiffness stiffness;
    if (!compliance.se_mPerN) {
        if (c_mPerN >= resolution_mPerN)
            stiffness.value_NPerM = 1.0 / c_mPerN;
        else
            stiffness.lower95_NPerM = link_NPerM;
        return stiffness;
    }

    const double se_mPerN = *compliance.se_mPerN;
    const double margin_mPerN = compliance.margin_mPerN();
    if (c_mPerN >= kDetectionLimit_se * se_mPerN && c_mPerN - margin_mPerN >= resolution_mPerN) {
        stiffness.value_NPerM = 1.0 / c_mPerN;
        stiffness.se_NPerM = se_mPerN / c_mPerN / c_mPerN;
        stiffness.lower95_NPerM = 1.0 / (c_mPerN + margin_mPerN);
        stiffness.upper95_NPerM = 1.0 / (c_mPerN - margin_mPerN);
    } else {
        const double most_mPerN =
            std::max({std::max(c_mPerN, 0.0) + margin_mPerN, -c_mPerN, resolution_mPerN});
        stiffness.lower95_NPerM = 1.0 / most_mPerN;
    }
    return stiffness;
}

} // namespace teleta::stiffness
