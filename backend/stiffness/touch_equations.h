// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/stiffness/refusal.h"

#include <tl/expected.hpp>

#include <optional>

namespace teleta::stiffness {

/// Stiffness k_ri of the paper's own link, from its touch of aluminium (TeleTA, section 2).
inline constexpr double kPaperLinkStiffness_NPerM = 3468.6;

/// Share of the link's compliance below which an object's compliance counts as zero. No touch resolves less:
/// the paper's own k_ri is known to 0.06 % (its factors are rounded). It keeps every reported stiffness below
/// 1000 k_ri.
inline constexpr double kComplianceResolution = 1e-3;

/// A compliance that is not this many standard errors above zero is not told from zero
/// (limit of detection, ICH Q2(R1)).
inline constexpr double kDetectionLimit_se = 3.3;

/// Half width of a 95 % interval in standard errors, normal distribution.
inline constexpr double kNormalQuantile95 = 1.959963984540054;

/// A measured compliance. Compliances of springs in series add, and their errors stay bounded where stiffness
/// diverges, so all reckoning is done with them.
struct Compliance {
    double value_mPerN = 0.0;
    std::optional<double> se_mPerN;        ///< standard error; empty when the data do not tell
    double quantile95 = kNormalQuantile95; ///< half width of the 95 % interval in standard errors

    [[nodiscard]] double margin_mPerN() const { return quantile95 * se_mPerN.value_or(0.0); }
};

/// A stiffness as it may be shown. Either value_NPerM is there, or only lower95_NPerM ("at least N N/m").
/// Every number is finite and, but for a standard error of zero, positive.
struct Stiffness {
    std::optional<double> value_NPerM;   ///< empty: not told from rigid, only a bound is known
    std::optional<double> se_NPerM;      ///< standard error of value_NPerM
    std::optional<double> lower95_NPerM; ///< empty only when the value has no standard error
    std::optional<double> upper95_NPerM; ///< empty when rigid is not excluded, or without a standard error

    [[nodiscard]] bool onlyBound() const { return !value_NPerM.has_value(); }
};

/// Total stiffness that the joint feels at the contact point.
///   k_i = dTau / (P_C^2 dTheta)
/// Equal to the paper's dTau / (P_C dTheta r cos(phi)), since r cos(phi) = P_C whatever the link's thickness
/// is. torqueRise_Nm, contactDistance_m, rotation_rad: > 0. Error: notFinite, notPositive. Thread: any
/// (pure). Source: TeleTA, eq. (2)-(4).
[[nodiscard]] tl::expected<double, Refusal>
totalStiffness_NPerM(double torqueRise_Nm, double contactDistance_m, double rotation_rad);

/// Compliance of the touched object: what the total yields more than the link alone.
///   c_o = c_i - 1/k_ri,   se^2 = se_i^2 + (se_ri / k_ri^2)^2
/// link_NPerM: > 0; linkSe_NPerM: >= 0. Error: notFinite, notPositive, negativeUncertainty. Thread: any
/// (pure). Source: TeleTA, eq. (5)-(6).
[[nodiscard]] tl::expected<Compliance, Refusal> objectCompliance(const Compliance& total, double link_NPerM,
                                                                 double linkSe_NPerM = 0.0);

/// Stiffness 1/c with its 95 % interval, or a lower bound when c is not told from zero.
///   value and interval   when c >= 3.3 se and c - q se >= r,  r = 1e-3 / k_ri
///   else                 k >= 1 / max(max(c, 0) + q se, -c, r)
/// The bound is the lower end of the same interval. A negative c shows an error of at least its own size
/// (contact distance, link stiffness), so the bound goes back as c falls. Without a standard error the bound
/// is k_ri. link_NPerM: > 0, sets the scale. Thread: any (pure).
[[nodiscard]] Stiffness stiffnessFromCompliance(const Compliance& compliance, double link_NPerM);

/// Stiffness of the touched object from the total stiffness and the link's own.
///   c_o = 1/k_i - 1/k_ri,   k_o = 1/c_o
/// total_NPerM, link_NPerM: > 0; totalSe_NPerM: >= 0 or empty when unknown. A total stiffer than the link
/// gives a bound. Error: notFinite, notPositive, negativeUncertainty. Thread: any (pure). Source: TeleTA, eq.
/// (5)-(6).
[[nodiscard]] tl::expected<Stiffness, Refusal> objectStiffness(double total_NPerM,
                                                               std::optional<double> totalSe_NPerM,
                                                               double link_NPerM, double linkSe_NPerM = 0.0);

} // namespace teleta::stiffness
