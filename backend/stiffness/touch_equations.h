// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/quantile.h"
#include "backend/stiffness/refusal.h"

#include <tl/expected.hpp>

#include <optional>

namespace teleta::stiffness {

/// Stiffness k_ri of the paper's own link, from its touch of aluminium (TeleTA, section 2).
inline constexpr double kPaperLinkStiffness_NPerM = 3468.6;

/// Share of the link's compliance below which an object's compliance counts as zero. No touch resolves less:
/// the paper's own k_ri is known to 0.06 %, because its factors are rounded. It also keeps every reported
/// stiffness below 1000 k_ri.
inline constexpr double kComplianceResolution = 1e-3;

/// A compliance less than this many standard errors above zero cannot be distinguished from zero (limit of
/// detection, ICH Q2(R1)).
inline constexpr double kDetectionLimit_se = 3.3;

/// A measured compliance. All calculations use compliances: those of springs in series add up, and their
/// errors stay bounded where the stiffness diverges.
struct Compliance {
    double value_mPerN = 0.0;
    std::optional<double> se_mPerN;              ///< standard error; empty when the data do not determine it
    double quantile95 = core::kNormalQuantile95; ///< half width of the 95 % interval in standard errors

    [[nodiscard]] double margin_mPerN() const { return quantile95 * se_mPerN.value_or(0.0); }
};

/// A stiffness ready to be shown: either value_NPerM is set, or only lower95_NPerM ("at least N N/m"). Every
/// number is finite and positive, except that a standard error may be zero.
struct Stiffness {
    std::optional<double>
        value_NPerM; ///< empty: cannot be distinguished from rigid; only the lower bound is known
    std::optional<double> se_NPerM;      ///< standard error of value_NPerM
    std::optional<double> lower95_NPerM; ///< empty only when the value has no standard error
    std::optional<double> upper95_NPerM; ///< empty when the object may be rigid, or without a standard error

    [[nodiscard]] bool onlyBound() const { return !value_NPerM.has_value(); }
};

/// Compliance of the touched object: the total compliance minus that of the link.
///   c_o = c_i - 1/k_ri,   se^2 = se_i^2 + (se_ri / k_ri^2)^2
/// link_NPerM: > 0; linkSe_NPerM: >= 0. Error: notFinite, notPositive, negativeUncertainty. Thread: any
/// (pure). Source: TeleTA, eq. (5)-(6).
[[nodiscard]] tl::expected<Compliance, Refusal> objectCompliance(const Compliance& total, double link_NPerM,
                                                                 double linkSe_NPerM = 0.0);

/// Stiffness 1/c with its 95 % interval, or only a lower bound when c cannot be distinguished from zero:
///   value and interval   when c >= 3.3 se and c - q se >= r,  r = 1e-3 / k_ri
///   else                 k >= 1 / max(max(c, 0) + q se, -c, r)
/// The bound is the lower end of the same interval. A negative c reveals an error of at least its own size
/// (of contact distance or link stiffness), so the bound decreases as c falls. Without a standard error the
/// bound is k_ri. link_NPerM: k_ri > 0, sets the scale. Thread: any (pure).
[[nodiscard]] Stiffness stiffnessFromCompliance(const Compliance& compliance, double link_NPerM);

} // namespace teleta::stiffness
