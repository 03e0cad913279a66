// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/base/progress_bar.h"
#include "app/cli/commands/arm/jog_target.h"
#include "app/cli/commands/certify/arm_chain.h"
#include "app/cli/commands/certify/arm_watch.h"
#include "app/cli/commands/certify/certify_commands.h"
#include "app/cli/commands/certify/chain.h"
#include "app/cli/commands/certify/fault_injector.h"
#include "app/cli/commands/certify/motor_watch.h"
#include "app/common/version.h"
#include "backend/certificate/certificate_page.h"
#include "backend/core/data/output_file.h"
#include "backend/core/failure.h"
#include "devices/modbus/simulated_driver.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QSysInfo>
#include <QTemporaryDir>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <random>
#include <stdlib.h>
#include <string>
#include <thread>
#include <variant>
#include <vector>

namespace teleta::cli {

namespace {

using certificate::Certificate;
using certificate::FaultKind;
using certificate::FaultTally;

struct CertifyText {
    Q_DECLARE_TR_FUNCTIONS(CertifyCommand)
};

constexpr const char* kSimulatedDriver = ":/devices/motor-driver.toml";
constexpr double kMotorBound_s = 0.15;
/// What commands an arm is held by leases, and brakes.
constexpr double kArmBound_s = 0.4;
/// Longer than the silence after which a site wants a new press.
constexpr double kArmSleep_s = 0.6;

std::string processorName() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name"))
            return line.substr(std::min(line.find(':') + 2, line.size()));
    return {};
}

/// As many of each kind, but for one, in an order by chance.
std::vector<FaultKind> planned(const std::vector<FaultKind>& kinds, long long faults, std::uint64_t seed) {
    std::vector<FaultKind> plan;
    for (long long k = 0; k < faults; ++k)
        plan.push_back(kinds[static_cast<std::size_t>(k) % kinds.size()]);
    std::mt19937_64 random(seed);
    std::ranges::shuffle(plan, random);
    return plan;
}

/// Kinds that are injected into the chain of an arm: it has no line that can be made to fail, and does not
/// record.
bool isOfArm(FaultKind kind) {
    return !isOfLine(kind) && kind != FaultKind::diskFull;
}

/// Reads back as the same number.
std::string number(double value) {
    return QString::number(value, 'g', 17).toStdString();
}

QString msText(const std::optional<double>& time_s) {
    return time_s ? forPeople(1e3 * *time_s, 3) : QStringLiteral("NA");
}

class CertifyCommand {
public:
    void declare(CLI::App& app) {
        CLI::Option* driver = addOption(
            app, "--bracelet", m_driver,
            CertifyText::tr("File of a Modbus motor driver over TCP; default: a simulated one. Nobody "
                            "may wear its motors: they run the whole time"),
            "FILE");
        CLI::Option* arm = addOption(
            app, "--arm", m_arm.path,
            CertifyText::tr("File of an arm over ROS 2, which is certified instead. One of its joints moves "
                            "to and fro the whole time; nobody may be within its reach"),
            "FILE");
        CLI::Option* site = addOption(
            app, "--site", m_site,
            CertifyText::tr("The same with an arm at a site: the file of a console that may move it"),
            "FILE");
        addOption(app, "--viewer", m_viewer,
                  CertifyText::tr("With --site: file of a viewer, which watches the arm. Default without "
                                  "certificates: the same file"),
                  "FILE")
            ->needs(site);
        addOption(app, "--device", m_arm.device,
                  CertifyText::tr("With --site: the arm's name there; default: the only one"), "NAME")
            ->needs(site);
        addOption(app, "--joint", m_arm.joint, CertifyText::tr("With --arm and --site: joint that moves"),
                  "NAME");
        addOption(app, "--rate", m_arm.rate,
                  CertifyText::tr("With --arm and --site: its speed in rad/s, prismatic m/s. It turns back "
                                  "after half a second of motion to each side"),
                  between(0.02, 0.5), "R");
        driver->excludes(arm)->excludes(site);
        arm->excludes(site);
        addFlag(app, "--yes", m_yes,
                CertifyText::tr("Nobody wears the motors of --bracelet, or is within reach of the arm"));
        addOption(app, "--faults", m_faults, CertifyText::tr("Number of faults"),
                  CLI::Range(1LL, 1'000'000LL).description(""), "N");
        std::vector<std::string> words;
        for (const FaultKind kind : certificate::kFaultKinds)
            words.emplace_back(toString(kind));
        addOption(app, "--kinds", m_kinds,
                  CertifyText::tr("Kinds of faults, separated by commas: %1. Default: all but clock_step, "
                                  "which sets the clock of this computer; for an arm, also without faults "
                                  "of the line and of the recording")
                      .arg(QString::fromStdString(CLI::detail::join(words, ", "))),
                  "KINDS")
            ->delimiter(',')
            ->check(CLI::IsMember(words).description(""));
        addOption(
            app, "--bound", m_bound_s,
            CertifyText::tr("Longest time until the motors must be at zero or the arm at rest; default: "
                            "%1, with an arm %2")
                .arg(kMotorBound_s)
                .arg(kArmBound_s),
            "S")
            ->check(positive());
        addOption(app, "--seed", m_seed, CertifyText::tr("Seed for the order and timing of the faults"),
                  seed(), "N");
        addOption(app, "--out", m_out,
                  CertifyText::tr("Name of the report: NAME.html and NAME.json are written"), "NAME")
            ->capture_default_str();
        declareJson(app, m_json);
        // How this program starts itself.
        app.add_option("--chain", m_recording)->group("");
        app.add_option("--port", m_port)->group("");
        app.add_option("--centre", m_centre)->group("");
    }

    [[nodiscard]] core::Expected<void> run() {
        if (!m_recording.empty())
            return runChain({m_driver, m_port, m_recording});
        if (!m_site.empty())
            m_arm.path = m_site;
        if (m_arm.path.empty())
            return certifyMotors();
        if (m_centre) {
            m_arm.centre = *m_centre;
            return runArmChain(m_arm);
        }
        return certifyArm();
    }

private:
    [[nodiscard]] core::Expected<void> certifyMotors() {
        const bool simulated = m_driver.empty();
        if (!simulated && !m_yes)
            refuse(
                "--bracelet",
                CertifyText::tr(
                    "the motors will run the whole time; make sure that nobody wears them, then add --yes"));
        const std::string file = simulated ? kSimulatedDriver : m_driver;
        TELETA_TRY(modbus::RegisterMap map, modbus::readRegisterMap(file));
        if (!map.tactors)
            return core::failed(core::ErrorKind::badInput, CertifyText::tr("the device has no motors"),
                                CertifyText::tr("a table [tactors]"), {file});
        std::unique_ptr<modbus::SimulatedDriver> driver;
        if (simulated) {
            TELETA_TRY(driver, modbus::SimulatedDriver::start(map));
            map.link = modbus::TcpLink{"127.0.0.1", driver->port()};
        }
        const auto* tcp = std::get_if<modbus::TcpLink>(&map.link);
        if (tcp == nullptr)
            return core::failed(core::ErrorKind::badInput,
                                CertifyText::tr("only a driver over TCP can be certified"),
                                QStringLiteral("link.kind = \"tcp\""), {file});
        TELETA_TRY(const auto relay, LineRelay::start(tcp->host, tcp->port));
        TELETA_TRY(const auto watch, MotorWatch::start(map));
        const QTemporaryDir folder;
        if (!folder.isValid())
            return core::failed(core::ErrorKind::ioFailed, folder.errorString());
        const auto chain = [&file, &relay](const std::string& recording) {
            return std::vector<std::string>{"--chain", recording, "--bracelet",
                                            file,      "--port",  std::to_string(relay->port())};
        };
        FaultInjector injector(
            {chain, folder.path().toStdString(), m_out + "-damaged-", bound_s(), m_seed, 0.0}, relay.get(),
            *watch);
        return certify(injector, begun(certificate::Actuator::motors, map.name, simulated));
    }

    [[nodiscard]] core::Expected<void> certifyArm() {
        const char* option = m_site.empty() ? "--arm" : "--site";
        if (m_arm.joint.empty())
            refuse(option, CertifyText::tr("--joint is needed, the joint that moves to and fro"));
        for (const FaultKind kind : kinds())
            if (!isOfArm(kind))
                refuse("--kinds", CertifyText::tr("%1 is no fault of an arm's chain")
                                      .arg(QString::fromLatin1(toString(kind))));
        TELETA_CHECK(checkJogFile(m_arm.path));
        if (!m_yes)
            refuse(option,
                   CertifyText::tr("the arm will move the whole time; make sure that nobody is within its "
                                   "reach, then add --yes"));
        TELETA_TRY(auto view, m_site.empty() ? viewRosJoint(m_arm.path, m_arm.joint)
                                             : viewSiteJoint(m_viewer.empty() ? m_site : m_viewer,
                                                             m_arm.device, m_arm.joint));
        TELETA_TRY(const auto watch, ArmWatch::start(std::move(view), m_arm.rate));
        std::vector<std::string> words{option,   m_arm.path,         "--joint",  m_arm.joint,
                                       "--rate", number(m_arm.rate), "--centre", number(*watch->position())};
        if (!m_arm.device.empty())
            words.insert(words.end(), {"--device", m_arm.device});
        FaultInjector injector(
            {[&words](const std::string&) { return words; }, "", "", bound_s(), m_seed, kArmSleep_s}, nullptr,
            *watch);
        return certify(injector,
                       begun(certificate::Actuator::arm, watch->view().name(), watch->view().simulated()));
    }

    [[nodiscard]] core::Expected<void> certify(FaultInjector& injector, Certificate certificate) const {
        const core::Expected<void> injected = injectAll(injector, certificate);
        injector.finish();
        if (!injected && certificate.outcomes.empty())
            return injected;
        complete(certificate, injector);
        TELETA_CHECK(write(certificate));
        TELETA_CHECK(print(certificate));
        if (!injected)
            return injected;
        if (!certificate.passes())
            return core::failed(core::ErrorKind::refused, CertifyText::tr("The certificate was not passed."));
        return {};
    }

    [[nodiscard]] bool ofArm() const { return !m_arm.path.empty(); }
    [[nodiscard]] double bound_s() const { return m_bound_s.value_or(ofArm() ? kArmBound_s : kMotorBound_s); }

    [[nodiscard]] Certificate begun(certificate::Actuator actuator, const std::string& driver,
                                    bool simulated) const {
        Certificate certificate;
        certificate.bound_s = bound_s();
        certificate.seed = m_seed;
        certificate.system.version = app::version().text().toStdString();
        certificate.system.actuator = actuator;
        certificate.system.driver = driver;
        certificate.system.simulated = simulated;
        certificate.system.started = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
        certificate.system.kernel =
            (QSysInfo::kernelType() + QLatin1Char(' ') + QSysInfo::kernelVersion()).toStdString();
        certificate.system.processor = processorName();
        certificate.system.cores = static_cast<int>(std::thread::hardware_concurrency());
        return certificate;
    }

    [[nodiscard]] std::vector<FaultKind> kinds() const {
        std::vector<FaultKind> kinds;
        for (const std::string& word : m_kinds)
            kinds.push_back(*certificate::faultKindOf(word));
        if (kinds.empty())
            std::ranges::copy_if(certificate::kFaultKinds, std::back_inserter(kinds), [this](FaultKind kind) {
                return kind != FaultKind::clockStep && (!ofArm() || isOfArm(kind));
            });
        return kinds;
    }

    [[nodiscard]] core::Expected<void> injectAll(FaultInjector& injector, Certificate& certificate) const {
        ProgressBar progress(ProgressBar::Unit::share, false);
        for (const FaultKind kind : planned(kinds(), m_faults, m_seed)) {
            progress.update(static_cast<double>(certificate.outcomes.size()), static_cast<double>(m_faults));
            TELETA_TRY(const certificate::FaultOutcome outcome, injector.inject(kind));
            certificate.outcomes.push_back(outcome);
        }
        return {};
    }

    void complete(Certificate& certificate, const FaultInjector& injector) const {
        double load = 0.0;
        if (getloadavg(&load, 1) == 1)
            certificate.system.load = load;
        certificate.system.resolution_s = injector.resolution_s();
        const auto remark = [&certificate](const QString& text) {
            certificate.remarks.push_back(text.toStdString());
        };
        if (ofArm())
            remark(CertifyText::tr("The program under test moves %1 to and fro at %2 (rad/s, prismatic m/s). "
                                   "It has its own connection; the arm is watched over another one.")
                       .arg(QString::fromStdString(m_arm.joint))
                       .arg(m_arm.rate));
        else
            remark(CertifyText::tr("The program under test follows a simulated array by live setpoints, "
                                   "drives the motors within their limits, and records."));
        if (static_cast<long long>(certificate.outcomes.size()) < m_faults)
            remark(CertifyText::tr("Ended early: %1 of %2 faults were injected.")
                       .arg(certificate.outcomes.size())
                       .arg(m_faults));
        if (certificate.system.simulated && !ofArm())
            remark(
                CertifyText::tr("The driver of the motors is SIMULATED: a Modbus server with a watchdog of "
                                "100 ms."));
        remark(ofArm() ? CertifyText::tr("Not covered: faults of the network, of the site and of the arm's "
                                         "controller.")
                       : CertifyText::tr("Not covered: bracelets that are not Modbus drivers over TCP."));
        for (const std::string& file : injector.kept())
            remark(CertifyText::tr("A damaged recording was kept: %1").arg(QString::fromStdString(file)));
    }

    [[nodiscard]] core::Expected<void> write(const Certificate& certificate) const {
        TELETA_CHECK(core::writeFile(m_out + ".json", toJson(certificate).dump(2) + "\n"));
        return core::writeFile(m_out + ".html", certificatePage(certificate).toStdString());
    }

    [[nodiscard]] core::Expected<void> print(const Certificate& certificate) const {
        if (m_json)
            return printDocument(toJson(certificate));
        Fields fields;
        const auto add = [&fields](const QString& name, const FaultTally& tally) {
            fields.emplace_back(
                name, CertifyText::tr("%1 faults: median %2, 99 % %3, longest %4 ms; %5 over the bound")
                          .arg(tally.faults)
                          .arg(msText(tally.median_s), msText(tally.p99_s), msText(tally.longest_s))
                          .arg(tally.overBound));
        };
        for (const FaultTally& tally : certificate.tallies())
            add(nameOf(tally.kind), tally);
        const FaultTally all = certificate.total();
        add(CertifyText::tr("All"), all);
        fields.emplace_back(CertifyText::tr("Restarted by itself"), QString::number(all.restarted));
        if (!ofArm()) {
            fields.emplace_back(CertifyText::tr("Frames lost"), QString::number(all.framesLost));
            fields.emplace_back(CertifyText::tr("Files damaged"), QString::number(all.filesDamaged));
        }
        fields.emplace_back(CertifyText::tr("Report"), QString::fromStdString(m_out + ".html"));
        return printFields(fields);
    }

    std::string m_driver;
    bool m_yes = false;
    long long m_faults = 1000;
    std::vector<std::string> m_kinds;
    std::optional<double> m_bound_s;
    std::uint64_t m_seed = 1;
    std::string m_out = "certificate";
    bool m_json = false;
    std::string m_recording;
    std::uint16_t m_port = 0;
    ArmChainOptions m_arm{.path = {}, .device = {}, .joint = {}, .rate = 0.1};
    std::string m_site;
    std::string m_viewer;
    std::optional<double> m_centre; ///< given: this program is the chain of an arm
};

} // namespace

Command certifyCommand() {
    return makeCommand<CertifyCommand>(
        "certify",
        CertifyText::tr(
            "Inject faults into the program that drives motors or an arm, and report how soon they stop"),
        "teleta certify --faults 4 --kinds kill,stop --bound 1 --out certificate");
}

} // namespace teleta::cli
