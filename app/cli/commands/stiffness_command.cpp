// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/stiffness_command.h"

#include "app/cli/command_io.h"
#include "app/cli/interruption.h"
#include "app/cli/progress_bar.h"
#include "app/cli/validators.h"
#include "backend/core/csv_reader.h"

#include <QCoreApplication>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <unistd.h>
#include <utility>

namespace teleta::cli {

namespace {

using stiffness::JointSample;
using stiffness::Material;
using stiffness::Method;
using stiffness::Refusal;
using stiffness::Stiffness;
using stiffness::TouchStiffness;

QString translate(const char* text) {
    return QCoreApplication::translate("StiffnessCommand", text);
}

nlohmann::ordered_json orNull(const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

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
        return translate("sponge");
    case Material::rubberSponge:
        return translate("rubber sponge");
    case Material::rubber:
        return translate("rubber");
    case Material::wood:
        return translate("wood");
    case Material::metal:
        return translate("metal");
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
        return translate("at least %1 N/m (95 %)").arg(perMetre(*stiffness.lower95_NPerM));
    if (!stiffness.lower95_NPerM)
        return translate("%1 N/m (uncertainty not available)").arg(perMetre(*stiffness.value_NPerM));
    return translate("%1 N/m (95 %: %2 to %3)")
        .arg(perMetre(*stiffness.value_NPerM), perMetre(*stiffness.lower95_NPerM),
             perMetre(*stiffness.upper95_NPerM));
}

core::Expected<void> printTable(const TouchStiffness& touch) {
    const QString method =
        touch.method == Method::twoPoint ? translate("two-point") : translate("regression");
    const auto samples = static_cast<int>(touch.samples);
    const std::array<std::pair<QString, QString>, 7> fields{{
        {translate("Method"), method},
        {translate("Samples"), QString::number(samples)},
        {translate("Rotation"), translate("%1 rad").arg(forPeople(touch.deltaTheta_rad))},
        {translate("Torque rise"), translate("%1 Nm").arg(forPeople(touch.deltaTorque_Nm))},
        {translate("Total stiffness"), inWords(touch.total)},
        {translate("Object stiffness"), inWords(touch.object)},
        {translate("Material"),
         (stiffness::isSafe(touch.material) ? translate("%1, safe to touch, level %2 of 5")
                                            : translate("%1, danger, level %2 of 5"))
             .arg(materialName(touch.material), QString::number(stiffness::level(touch.material)))},
    }};
    return printFields(fields);
}

} // namespace

QString StiffnessCommand::summary() const {
    return translate("Stiffness and material of an object from joint angle and torque during a touch");
}

const char* StiffnessCommand::example() const {
    return "teleta stiffness touch.csv --contact-distance 0.175";
}

void StiffnessCommand::declare(CLI::App& app) {
    const auto help = [](const char* text) { return translate(text).toStdString(); };
    app.add_option("log", m_logPath,
                   help(QT_TRANSLATE_NOOP("StiffnessCommand",
                                          "CSV with the columns time_s,joint_angle_rad,joint_torque_nm")))
        ->type_name("LOG.csv")
        ->required();
    app.add_option("--contact-distance", m_settings.contactDistance_m,
                   help(QT_TRANSLATE_NOOP("StiffnessCommand",
                                          "Distance of the contact from the joint's axis along the link, m")))
        ->type_name("M")
        ->required()
        ->check(positive());
    app.add_option(
           "--link-half-thickness", m_linkHalfThickness_m,
           help(QT_TRANSLATE_NOOP("StiffnessCommand",
                                  "Half the thickness of the link, m; it cancels out of the stiffness")))
        ->type_name("M")
        ->check(finite());
    app.add_option("--link-stiffness", m_settings.linkStiffness_NPerM,
                   help(QT_TRANSLATE_NOOP("StiffnessCommand", "The link's own stiffness, N/m")))
        ->type_name("N_PER_M")
        ->capture_default_str()
        ->check(positive());
    app.add_option("--method", m_method,
                   help(QT_TRANSLATE_NOOP("StiffnessCommand",
                                          "two-point: the samples nearest to both borders of the window; "
                                          "regression: all samples in it")))
        ->type_name("two-point|regression")
        ->capture_default_str()
        ->check(
            CLI::IsMember({stiffness::toString(Method::twoPoint), stiffness::toString(Method::regression)})
                .description(""));
    app.add_option(
           "--window", m_window_Nm,
           help(QT_TRANSLATE_NOOP("StiffnessCommand", "Torques between which the touch is evaluated, Nm")))
        ->type_name("LO,HI")
        ->delimiter(',')
        ->expected(2)
        ->default_str("0.02,0.05")
        ->check(finite());
    declareJson(app, m_json);
}

core::Expected<void> StiffnessCommand::run() {
    if (m_linkHalfThickness_m < 0.0)
        throw CLI::ValidationError("--link-half-thickness", translate("0 or more is expected").toStdString());
    if (m_window_Nm.size() == 2) {
        m_settings.window = {m_window_Nm[0], m_window_Nm[1]};
        if (m_window_Nm[0] < 0.0 || m_window_Nm[1] <= m_window_Nm[0])
            throw CLI::ValidationError(
                "--window",
                translate("a lower border of 0 or more and a higher upper one are expected").toStdString());
    }
    m_settings.method = *stiffness::methodFromString(m_method);

    const core::Expected<std::vector<JointSample>> log = readLog();
    if (!log)
        return core::Unexpected(log.error());
    const tl::expected<TouchStiffness, Refusal> touch = stiffness::estimateStiffness(*log, m_settings);
    if (!touch)
        return core::Unexpected(explain(touch.error(), *log));
    if (touch->stifferThanLink)
        std::fprintf(
            stderr, "teleta: %s\n",
            translate("the touch is stiffer than the link allows: check contact distance and link stiffness")
                .toUtf8()
                .constData());
    return m_json ? printDocument(toJson(*touch)) : printTable(*touch);
}

core::Expected<std::vector<JointSample>> StiffnessCommand::readLog() const {
    core::Expected<core::CsvReader> reader = core::CsvReader::open(m_logPath);
    if (!reader)
        return core::Unexpected(reader.error());
    constexpr std::array<std::string_view, 3> kNames{"time_s", "joint_angle_rad", "joint_torque_nm"};
    const core::Expected<std::vector<std::size_t>> columns = reader->columns(kNames);
    if (!columns)
        return core::Unexpected(columns.error());

    std::vector<JointSample> log;
    std::vector<double> row;
    ProgressBar progress(reader->bytesTotal(), isatty(STDOUT_FILENO) != 0);
    for (;;) {
        const core::Expected<bool> more = reader->next(row);
        if (!more)
            return core::Unexpected(more.error());
        if (!*more)
            return log;
        if (interrupted())
            return core::Unexpected(interruption());
        log.push_back({row[(*columns)[0]], row[(*columns)[1]], row[(*columns)[2]]});
        progress.update(reader->bytesRead());
    }
}

core::Error StiffnessCommand::explain(Refusal refusal, const std::vector<JointSample>& log) const {
    core::Error error;
    error.kind = core::ErrorKind::refused;
    error.where.file = m_logPath;
    double largest_Nm = 0.0;
    for (const JointSample& sample : log)
        largest_Nm = std::max(largest_Nm, std::abs(sample.torque_Nm));
    const QString low = forPeople(m_settings.window.low_Nm);
    const QString high = forPeople(m_settings.window.high_Nm);
    const auto say = [&error](const QString& message, const QString& expected = {}) {
        error.message = message.toStdString();
        error.expected = expected.toStdString();
    };
    switch (refusal) {
    case Refusal::noSamples:
        error.kind = core::ErrorKind::badInput;
        say(translate("the log has no samples"), translate("a row for each sample of the touch"));
        break;
    case Refusal::windowNotReached:
        if (m_settings.method == Method::twoPoint && largest_Nm >= m_settings.window.low_Nm)
            say(translate("one half of the torque window has no sample; the largest torque is %1 Nm")
                    .arg(forPeople(largest_Nm)),
                translate("samples near %1 Nm and near %2 Nm").arg(low, high));
        else
            say(translate("no sample reaches the torque window; the largest torque is %1 Nm")
                    .arg(forPeople(largest_Nm)),
                translate("torques from %1 to %2 Nm").arg(low, high));
        break;
    case Refusal::tooFewSamples:
        say(translate("only one sample lies in the torque window"),
            translate("two or more samples from %1 to %2 Nm").arg(low, high));
        break;
    case Refusal::torqueUnchanged:
        say(translate("the torque does not change within the window"),
            translate("torque that rises from %1 to %2 Nm").arg(low, high));
        break;
    case Refusal::angleOpposesTorque:
        say(translate("the joint turns against the rising torque"),
            translate("angle and torque that rise together; the sign of one column may be turned"));
        break;
    case Refusal::notFinite:
    case Refusal::notPositive:
    case Refusal::negativeUncertainty:
    case Refusal::outOfRange:
    case Refusal::badWindow:
        say(translate("the numbers are too large or too small to compute with"), translate("SI units"));
        break;
    }
    return error;
}

} // namespace teleta::cli
