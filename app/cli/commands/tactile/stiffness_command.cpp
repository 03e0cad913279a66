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

struct StiffnessText {
    Q_DECLARE_TR_FUNCTIONS(StiffnessCommand)
};

nlohmann::ordered_json toJson(const TouchStiffness& touch) {
    return {{"method", stiffness::toString(touch.method)},
            {"samples", touch.samples},
            {"delta_theta_rad", touch.deltaTheta_rad},
            {"delta_torque_nm", touch.deltaTorque_Nm},
            {"total_stiffness_n_per_m", orNull(touch.total.value_NPerM)},
            {"total_stiffness_se", orNull(touch.total.se_NPerM)},
            {"object_stiffness_n_per_m", orNull(touch.object.value_NPerM)},
            {"object_stiffness_lower_95", orNull(touch.object.lower95_NPerM)},
            {"object_stiffness_upper_95", orNull(touch.object.upper95_NPerM)},
            {"material", stiffness::toString(touch.material)},
            {"safe", stiffness::isSafe(touch.material)},
            {"level", stiffness::level(touch.material)}};
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

core::Expected<void> printTable(const TouchStiffness& touch) {
    const QString method =
        touch.method == Method::twoPoint ? StiffnessText::tr("two-point") : StiffnessText::tr("regression");
    const auto samples = static_cast<int>(touch.samples);
    return printFields({
        {StiffnessText::tr("Method"), method},
        {StiffnessText::tr("Samples"), QString::number(samples)},
        {StiffnessText::tr("Rotation"), StiffnessText::tr("%1 rad").arg(forPeople(touch.deltaTheta_rad))},
        {StiffnessText::tr("Torque rise"), StiffnessText::tr("%1 Nm").arg(forPeople(touch.deltaTorque_Nm))},
        {StiffnessText::tr("Total stiffness"), inWords(touch.total)},
        {StiffnessText::tr("Object stiffness"), inWords(touch.object)},
        {StiffnessText::tr("Material"),
         (stiffness::isSafe(touch.material) ? StiffnessText::tr("%1, safe to touch, level %2 of 5")
                                            : StiffnessText::tr("%1, danger, level %2 of 5"))
             .arg(materialName(touch.material), QString::number(stiffness::level(touch.material)))},
    });
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
        return refused(StiffnessText::tr("only one sample lies in the torque window"),
                       StiffnessText::tr("two or more samples from %1 to %2 Nm").arg(low, high));
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
        addOption(app, "--link-half-thickness", m_linkHalfThickness_m,
                  StiffnessText::tr("Half the thickness of the link, m; it cancels out of the stiffness"),
                  "M")
            ->check(finite());
        addOption(app, "--link-stiffness", m_settings.linkStiffness_NPerM,
                  StiffnessText::tr("The link's own stiffness, N/m"), positive(), "N_PER_M");
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
        m_settings.method = *stiffness::methodFromString(m_method);

        TELETA_TRY(const std::vector<JointSample> log, readLog());
        const tl::expected<TouchStiffness, Refusal> touch = stiffness::estimateStiffness(log, m_settings);
        if (!touch)
            return explain(touch.error(), log, m_settings, m_logPath);
        if (touch->stifferThanLink)
            warn(StiffnessText::tr(
                "the touch is stiffer than the link allows: check contact distance and link stiffness"));
        return m_json ? printDocument(toJson(*touch)) : printTable(*touch);
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
