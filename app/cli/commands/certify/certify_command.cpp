// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/base/progress_bar.h"
#include "app/cli/commands/certify/certify_commands.h"
#include "app/cli/commands/certify/chain.h"
#include "app/cli/commands/certify/fault_injector.h"
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

QString msText(const std::optional<double>& time_s) {
    return time_s ? forPeople(1e3 * *time_s, 3) : QStringLiteral("NA");
}

class CertifyCommand {
public:
    void declare(CLI::App& app) {
        addOption(app, "--bracelet", m_driver,
                  CertifyText::tr("File of a Modbus motor driver over TCP; default: a simulated one. Nobody "
                                  "may wear its motors: they run the whole time"),
                  "FILE");
        addFlag(app, "--yes", m_yes, CertifyText::tr("With --bracelet: nobody wears the motors"));
        addOption(app, "--faults", m_faults, CertifyText::tr("Number of faults"),
                  CLI::Range(1LL, 1'000'000LL).description(""), "N");
        std::vector<std::string> words;
        for (const FaultKind kind : certificate::kFaultKinds)
            words.emplace_back(toString(kind));
        addOption(app, "--kinds", m_kinds,
                  CertifyText::tr("Kinds of faults, separated by commas: %1. Default: all but clock_step, "
                                  "which sets the clock of this computer")
                      .arg(QString::fromStdString(CLI::detail::join(words, ", "))),
                  "KINDS")
            ->delimiter(',')
            ->check(CLI::IsMember(words).description(""));
        addOption(app, "--bound", m_bound_s, CertifyText::tr("Longest time until the motors must be at zero"),
                  positive(), "S");
        addOption(app, "--seed", m_seed, CertifyText::tr("Seed for the order and timing of the faults"),
                  seed(), "N");
        addOption(app, "--out", m_out,
                  CertifyText::tr("Name of the report: NAME.html and NAME.json are written"), "NAME")
            ->capture_default_str();
        declareJson(app, m_json);
        // How this program starts itself.
        app.add_option("--chain", m_recording)->group("");
        app.add_option("--port", m_port)->group("");
    }

    [[nodiscard]] core::Expected<void> run() {
        if (!m_recording.empty())
            return runChain({m_driver, m_port, m_recording});
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

        Certificate certificate = begun(map.name, simulated);
        FaultInjector injector({file, folder.path().toStdString(), m_out + "-damaged-", m_bound_s, m_seed},
                               *relay, *watch);
        const core::Expected<void> injected = injectAll(injector, certificate);
        if (!injected && injected.error().kind != core::ErrorKind::cancelled)
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

private:
    [[nodiscard]] Certificate begun(const std::string& driver, bool simulated) const {
        Certificate certificate;
        certificate.bound_s = m_bound_s;
        certificate.seed = m_seed;
        certificate.system.version = app::version().text().toStdString();
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
            std::ranges::copy_if(certificate::kFaultKinds, std::back_inserter(kinds),
                                 [](FaultKind kind) { return kind != FaultKind::clockStep; });
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
        remark(CertifyText::tr("The program under test follows a simulated array by live setpoints, drives "
                               "the motors within their limits, and records."));
        if (static_cast<long long>(certificate.outcomes.size()) < m_faults)
            remark(CertifyText::tr("Interrupted: %1 of %2 faults were injected.")
                       .arg(certificate.outcomes.size())
                       .arg(m_faults));
        if (certificate.system.simulated)
            remark(
                CertifyText::tr("The driver of the motors is SIMULATED: a Modbus server with a watchdog of "
                                "100 ms."));
        remark(CertifyText::tr("Not covered: arms, and bracelets that are not Modbus drivers over TCP."));
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
        fields.emplace_back(CertifyText::tr("Frames lost"), QString::number(all.framesLost));
        fields.emplace_back(CertifyText::tr("Files damaged"), QString::number(all.filesDamaged));
        fields.emplace_back(CertifyText::tr("Report"), QString::fromStdString(m_out + ".html"));
        return printFields(fields);
    }

    std::string m_driver;
    bool m_yes = false;
    long long m_faults = 1000;
    std::vector<std::string> m_kinds;
    double m_bound_s = 0.15;
    std::uint64_t m_seed = 1;
    std::string m_out = "certificate";
    bool m_json = false;
    std::string m_recording;
    std::uint16_t m_port = 0;
};

} // namespace

Command certifyCommand() {
    return makeCommand<CertifyCommand>(
        "certify",
        CertifyText::tr(
            "Inject faults into the program that drives the motors, and report how soon the motors stop"),
        "teleta certify --faults 4 --kinds kill,stop --bound 1 --out certificate");
}

} // namespace teleta::cli
