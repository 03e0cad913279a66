// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/column_reader.h"
#include "app/cli/base/command_io.h"
#include "app/cli/base/options.h"
#include "app/cli/commands/tactile/tactile_commands.h"
#include "backend/core/failure.h"
#include "backend/stiffness/stiffness_estimator.h"

#include <QCoreApplication>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace teleta::cli {

namespace {

using stiffness::JointSample;
using stiffness::Material;
using stiffness::Method;
using stiffness::Refusal;
using stiffness::Stiffness;
using stiffness::TouchStiffness;
using stiffness::TouchWarning;

constexpr const char* kFromStart = "start";

struct StiffnessText {
    Q_DECLARE_TR_FUNCTIONS(StiffnessText)
};

nlohmann::ordered_json toJson(const stiffness::Interval95& interval) {
    return {{"value", interval.value}, {"lower_95", interval.lower}, {"upper_95", interval.upper}};
}

nlohmann::ordered_json toJson(const std::optional<stiffness::StandardLinearSolid>& solid) {
    if (!solid)
        return nullptr;
    return {{"static_stiffness_n_per_m", toJson(solid->static_NPerM)},
            {"ratio", toJson(solid->ratio)},
            {"relaxation_s", toJson(solid->relaxation_s)}};
}

nlohmann::ordered_json toJson(const TouchStiffness& touch) {
    nlohmann::ordered_json warnings = nlohmann::ordered_json::array();
    for (const TouchWarning warning : touch.warnings)
        warnings.push_back(stiffness::toString(warning));
    nlohmann::ordered_json budget = nlohmann::ordered_json::array();
    for (const stiffness::ErrorShare& part : touch.errorBudget)
        budget.push_back({{"source", stiffness::toString(part.source)}, {"share", part.share}});
    const auto ifKnown = [&touch](const nlohmann::ordered_json& value) {
        return touch.materialKnown() ? value : nullptr;
    };
    return {{"method", stiffness::toString(touch.method)},
            {"samples", touch.samples},
            {"delta_theta_rad", touch.deltaTheta_rad},
            {"delta_torque_nm", touch.deltaTorque_Nm},
            {"total_stiffness_n_per_m", orNull(touch.total.value_NPerM)},
            {"total_stiffness_se", orNull(touch.total.se_NPerM)},
            {"object_stiffness_n_per_m", orNull(touch.object.value_NPerM)},
            {"object_stiffness_lower_95", orNull(touch.object.lower95_NPerM)},
            {"object_stiffness_upper_95", orNull(touch.object.upper95_NPerM)},
            {"material", ifKnown(stiffness::toString(touch.material))},
            {"safe", ifKnown(stiffness::isSafe(touch.material))},
            {"level", ifKnown(stiffness::level(touch.material))},
            {"reliable", touch.reliable},
            {"warnings", std::move(warnings)},
            {"error_budget", std::move(budget)},
            {"effective_samples", touch.effectiveSamples},
            {"torque_reference_nm", touch.torqueReference_Nm},
            {"torque_drift_nm_per_s", touch.torqueDrift_NmPerS},
            {"tangent_stiffness_n_per_m", orNull(touch.tangent_NPerM)},
            {"secant_stiffness_n_per_m", orNull(touch.secant_NPerM)},
            {"standard_linear_solid", toJson(touch.solid)}};
}

QString materialName(Material material) {
    switch (material) {
    case Material::sponge:
        return StiffnessText::tr("sponge");
    case Material::rubberSponge:
        return StiffnessText::tr("rubber sponge");
    case Material::rubber:
        return StiffnessText::tr("rubber");
    case Material::wood:
        return StiffnessText::tr("wood");
    case Material::metal:
        return StiffnessText::tr("metal");
    }
    return {};
}

/// Four significant digits, without an exponent where people say thousands.
QString perMetre(double stiffness_NPerM) {
    if (stiffness_NPerM < 1e4 || stiffness_NPerM >= 1e9)
        return forPeople(stiffness_NPerM);
    const double digit_NPerM = std::pow(10.0, std::floor(std::log10(stiffness_NPerM)) - 3.0);
    return QString::number(std::round(stiffness_NPerM / digit_NPerM) * digit_NPerM, 'f', 0);
}

QString inWords(const Stiffness& stiffness) {
    if (!stiffness.value_NPerM)
        return StiffnessText::tr("at least %1 N/m (95 %)").arg(perMetre(*stiffness.lower95_NPerM));
    if (!stiffness.lower95_NPerM)
        return StiffnessText::tr("%1 N/m (uncertainty not available)").arg(perMetre(*stiffness.value_NPerM));
    return StiffnessText::tr("%1 N/m (95 %: %2 to %3)")
        .arg(perMetre(*stiffness.value_NPerM), perMetre(*stiffness.lower95_NPerM),
             perMetre(*stiffness.upper95_NPerM));
}

QString inWords(TouchWarning warning) {
    switch (warning) {
    case TouchWarning::correlatedNoise:
        return StiffnessText::tr("the noise of neighbouring samples is not independent");
    case TouchWarning::coarseTorque:
        return StiffnessText::tr("one step of the torque reading is over a tenth of the window");
    case TouchWarning::coarseAngle:
        return StiffnessText::tr("one step of the angle reading is over a tenth of the rotation");
    case TouchWarning::torqueOffset:
        return StiffnessText::tr("the free joint has a torque; it was taken off");
    case TouchWarning::torqueDrift:
        return StiffnessText::tr("the torque of the free joint changes; the change was taken off");
    case TouchWarning::nonlinear:
        return StiffnessText::tr("the stiffness changes within the window");
    case TouchWarning::rateDependent:
        return StiffnessText::tr("the force depends on how quickly the object is pressed");
    case TouchWarning::stickSlip:
        return StiffnessText::tr("the torque jumps or falls back, or the joint has play");
    }
    return {};
}

/// An offset keeps its word only while the program takes it off.
QString toldOf(TouchWarning warning, bool referenceTold) {
    return warning == TouchWarning::torqueOffset && referenceTold
               ? StiffnessText::tr("the free joint has another torque than --torque-reference says")
               : inWords(warning);
}

QString materialLine(const TouchStiffness& touch) {
    if (!touch.materialKnown())
        return StiffnessText::tr("cannot tell");
    return (stiffness::isSafe(touch.material) ? StiffnessText::tr("%1, safe to touch, level %2 of 5")
                                              : StiffnessText::tr("%1, danger, level %2 of 5"))
        .arg(materialName(touch.material), QString::number(stiffness::level(touch.material)));
}

QString inWords(const stiffness::Interval95& interval, const QString& pattern) {
    return pattern.arg(perMetre(interval.value), perMetre(interval.lower), perMetre(interval.upper));
}

core::Expected<void> printTable(const TouchStiffness& touch, bool referenceTold) {
    const QString method =
        touch.method == Method::twoPoint ? StiffnessText::tr("two-point") : StiffnessText::tr("regression");
    const auto samples = static_cast<int>(touch.samples);
    Fields fields{
        {StiffnessText::tr("Method"), method},
        {StiffnessText::tr("Samples"), QString::number(samples)},
        {StiffnessText::tr("Rotation"), StiffnessText::tr("%1 rad").arg(forPeople(touch.deltaTheta_rad))},
        {StiffnessText::tr("Torque rise"), StiffnessText::tr("%1 Nm").arg(forPeople(touch.deltaTorque_Nm))},
        {StiffnessText::tr("Total stiffness"), inWords(touch.total)},
        {StiffnessText::tr("Object stiffness"), inWords(touch.object)},
    };
    if (touch.secant_NPerM && touch.tangent_NPerM)
        fields.emplace_back(StiffnessText::tr("Secant, tangent"),
                            StiffnessText::tr("%1 N/m, %2 N/m at the upper end")
                                .arg(perMetre(*touch.secant_NPerM), perMetre(*touch.tangent_NPerM)));
    if (touch.solid) {
        fields.emplace_back(StiffnessText::tr("Static stiffness"),
                            inWords(touch.solid->static_NPerM, StiffnessText::tr("%1 N/m (95 %: %2 to %3)")));
        fields.emplace_back(StiffnessText::tr("Quick over static"),
                            inWords(touch.solid->ratio, StiffnessText::tr("1 + %1 (95 %: %2 to %3)")));
        fields.emplace_back(StiffnessText::tr("Relaxation"),
                            inWords(touch.solid->relaxation_s, StiffnessText::tr("%1 s (95 %: %2 to %3)")));
    }
    fields.emplace_back(StiffnessText::tr("Material"), materialLine(touch));
    if (!touch.reliable)
        fields.emplace_back(StiffnessText::tr("Reliable"), StiffnessText::tr("no"));
    for (const TouchWarning warning : touch.warnings)
        fields.emplace_back(StiffnessText::tr("Warning"), toldOf(warning, referenceTold));
    return printFields(fields);
}

/// Why the log yields no stiffness, and what it must contain instead.
core::Unexpected explain(Refusal refusal, const std::vector<JointSample>& log,
                         const stiffness::TouchSettings& settings, const std::string& path) {
    double largest_Nm = 0.0;
    for (const JointSample& sample : log)
        largest_Nm = std::max(largest_Nm, std::abs(sample.torque_Nm));
    const QString low = forPeople(settings.window.low_Nm);
    const QString high = forPeople(settings.window.high_Nm);
    const auto refused = [&path](const QString& message, const QString& expected) {
        return core::failed(core::ErrorKind::refused, message, expected, {path});
    };
    switch (refusal) {
    case Refusal::noSamples:
        return core::failed(core::ErrorKind::badInput, StiffnessText::tr("the log has no samples"),
                            StiffnessText::tr("a row for each sample of the touch"), {path});
    case Refusal::windowNotReached:
        if (settings.method == Method::twoPoint && largest_Nm >= settings.window.low_Nm)
            return refused(
                StiffnessText::tr("one half of the torque window has no sample; the largest torque is %1 Nm")
                    .arg(forPeople(largest_Nm)),
                StiffnessText::tr("samples near %1 Nm and near %2 Nm").arg(low, high));
        return refused(StiffnessText::tr("no sample reaches the torque window; the largest torque is %1 Nm")
                           .arg(forPeople(largest_Nm)),
                       StiffnessText::tr("torques from %1 to %2 Nm").arg(low, high));
    case Refusal::tooFewSamples:
        return refused(
            StiffnessText::tr("fewer than 20 independent samples lie in the torque window"),
            StiffnessText::tr("a slower touch or quicker sampling from %1 to %2 Nm; --method two-point "
                              "needs two samples")
                .arg(low, high));
    case Refusal::torqueUnchanged:
        return refused(StiffnessText::tr("the torque does not change within the window"),
                       StiffnessText::tr("torque that rises from %1 to %2 Nm").arg(low, high));
    case Refusal::angleOpposesTorque:
        return refused(
            StiffnessText::tr("the joint turns against the rising torque"),
            StiffnessText::tr("angle and torque that rise together; the sign of one column may be turned"));
    case Refusal::tooQuick:
        return refused(StiffnessText::tr("the torque rises so quickly that the arm's inertia is part of it"),
                       StiffnessText::tr("a slower touch"));
    case Refusal::notFinite:
    case Refusal::notPositive:
    case Refusal::negativeUncertainty:
    case Refusal::outOfRange:
    case Refusal::badWindow:
    case Refusal::noTorques:
        break;
    }
    return refused(StiffnessText::tr("the numbers are too large or too small to compute with"),
                   StiffnessText::tr("SI units"));
}

class StiffnessCommand {
public:
    void declare(CLI::App& app) {
        addOption(app, "log", m_logPath,
                  StiffnessText::tr("CSV with the columns time_s,joint_angle_rad,joint_torque_nm"), "LOG.csv")
            ->required();
        addOption(app, "--contact-distance", m_settings.contactDistance_m,
                  StiffnessText::tr("Distance of the contact from the joint's axis along the link, m"), "M")
            ->required()
            ->check(positive());
        addOption(app, "--contact-distance-se", m_settings.contactDistanceSe_m,
                  StiffnessText::tr("Standard error of the contact distance, m; it enters twice. Default: "
                                    "0.05 % of the distance"),
                  "M")
            ->check(CLI::NonNegativeNumber)
            ->check(finite());
        addOption(app, "--link-half-thickness", m_linkHalfThickness_m,
                  StiffnessText::tr("Half the thickness of the link, m; it cancels out of the stiffness"),
                  "M")
            ->check(finite());
        addOption(app, "--link-stiffness", m_settings.linkStiffness_NPerM,
                  StiffnessText::tr("The link's own stiffness, N/m"), positive(), "N_PER_M");
        addOption(app, "--link-stiffness-se", m_settings.linkStiffnessSe_NPerM,
                  StiffnessText::tr("Standard error of that stiffness, N/m"), CLI::NonNegativeNumber,
                  "N_PER_M")
            ->check(finite());
        addOption(app, "--torque-reference", m_torqueReference,
                  StiffnessText::tr("Torque of the joint without the touch, Nm; start: that of the free "
                                    "motion before the touch, or 0 when there is none"),
                  "NM|start")
            ->capture_default_str();
        addOption(
            app, "--method", m_method,
            StiffnessText::tr("two-point: the samples nearest to both borders of the window; regression: all "
                              "samples in it"),
            CLI::IsMember({stiffness::toString(Method::twoPoint), stiffness::toString(Method::regression)})
                .description(""),
            "two-point|regression");
        addOption(app, "--window", m_window_Nm,
                  StiffnessText::tr("Torques between which the touch is evaluated, Nm"), "LO,HI")
            ->delimiter(',')
            ->expected(2)
            ->default_str("0.02,0.05")
            ->check(finite());
        declareJson(app, m_json);
    }

    [[nodiscard]] core::Expected<void> run() {
        if (m_linkHalfThickness_m < 0.0)
            refuse("--link-half-thickness", StiffnessText::tr("0 or more is expected"));
        if (m_window_Nm.size() == 2) {
            m_settings.window = {m_window_Nm[0], m_window_Nm[1]};
            if (m_window_Nm[0] < 0.0 || m_window_Nm[1] <= m_window_Nm[0])
                refuse("--window",
                       StiffnessText::tr("a lower border of 0 or more and a higher upper one are expected"));
        }
        if (m_torqueReference != kFromStart) {
            bool isNumber = false;
            const double reference_Nm = QString::fromStdString(m_torqueReference).toDouble(&isNumber);
            if (!isNumber || !std::isfinite(reference_Nm))
                refuse("--torque-reference", StiffnessText::tr("a torque in Nm or start is expected"));
            m_settings.torqueReference_Nm = reference_Nm;
        }
        m_settings.method = *stiffness::methodFromString(m_method);

        TELETA_TRY(const std::vector<JointSample> log, readLog());
        const tl::expected<TouchStiffness, Refusal> touch = stiffness::estimateStiffness(log, m_settings);
        if (!touch)
            return explain(touch.error(), log, m_settings, m_logPath);
        if (touch->stifferThanLink)
            warn(StiffnessText::tr(
                "the touch is stiffer than the link allows: check contact distance and link stiffness"));
        return m_json ? printDocument(toJson(*touch))
                      : printTable(*touch, m_settings.torqueReference_Nm.has_value());
    }

private:
    [[nodiscard]] core::Expected<std::vector<JointSample>> readLog() const {
        constexpr std::array<std::string_view, 3> kNames{"time_s", "joint_angle_rad", "joint_torque_nm"};
        TELETA_TRY(ColumnReader reader, ColumnReader::open(m_logPath, kNames));
        std::vector<JointSample> log;
        TELETA_CHECK(reader.forEachRow(isatty(STDOUT_FILENO) != 0, [&](std::span<const double> row) {
            log.push_back({row[0], row[1], row[2]});
            return true;
        }));
        return log;
    }

    stiffness::TouchSettings m_settings;
    std::string m_logPath;
    std::string m_method = stiffness::toString(stiffness::Method::regression);
    std::vector<double> m_window_Nm;
    std::string m_torqueReference = kFromStart;
    double m_linkHalfThickness_m = 0.0;
    bool m_json = false;
};

} // namespace

Command stiffnessCommand() {
    return makeCommand<StiffnessCommand>(
        "stiffness",
        StiffnessText::tr("Stiffness and material of an object from joint angle and torque during a touch"),
        "teleta simulate teleta-touch --duration 8 --out run\n"
        "  cut -d, -f1,5,9 run/joints.csv | sed '1s/.*/time_s,joint_angle_rad,joint_torque_nm/' "
        ">touch.csv\n"
        "  teleta stiffness touch.csv --contact-distance 0.1695");
}

} // namespace teleta::cli
