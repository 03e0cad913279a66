// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/site/site_program.h"

#include "app/common/version.h"
#include "app/site/running_site.h"
#include "app/site/service_manager.h"
#include "app/site/site_file.h"
#include "app/site/site_log.h"
#include "app/site/stop_memory.h"
#include "backend/core/failure.h"
#include "backend/core/steady_time.h"

#include <QCoreApplication>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <ctime>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace teleta::site_program {

namespace {

struct SiteProgramText {
    Q_DECLARE_TR_FUNCTIONS(SiteProgramText)
};

constexpr std::int64_t kPoll_ns = 50'000'000;
/// A check waits so long for the devices.
constexpr std::int64_t kCheck_ns = 8'000'000'000;
/// Of status lines to the service manager.
constexpr std::int64_t kTell_ns = 250'000'000;

enum ExitCode { kDone = 0, kWorkFailed = 1, kWrongUsage = 2, kBadInput = 3 };

int failedWith(const core::Error& error, bool badInput) {
    std::cerr << "teleta-site: " << core::describe(error) << '\n';
    return badInput ? kBadInput : kWorkFailed;
}

struct Options {
    std::string path;
    SiteFolders folders{.recordings = ".", .state = {}};
    bool check = false;
    bool json = false;
};

/// Waits until every device is live and says what is missing.
int check(RunningSite& site, const Options& options, const SiteSignals& sent) {
    std::vector<std::string> problems = site.problems();
    for (const std::int64_t end_ns = core::steadyNow_ns() + kCheck_ns;
         !problems.empty() && core::steadyNow_ns() < end_ns && !sent.wait(kPoll_ns);) {
        site.poll();
        problems = site.problems();
    }
    if (options.json) {
        std::cout << nlohmann::ordered_json(
                         {{"devices", site.devices()}, {"usable", problems.empty()}, {"problems", problems}})
                         .dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)
                  << '\n';
    } else if (problems.empty()) {
        std::cout << SiteProgramText::tr("All %n device(s) are ready.", nullptr,
                                         static_cast<int>(site.devices()))
                         .toStdString()
                  << '\n';
    } else {
        for (const std::string& problem : problems)
            std::cout << problem << '\n';
    }
    return problems.empty() ? kDone : kWorkFailed;
}

int serve(RunningSite& site, const SiteFile& file, SiteLog& log, const SiteSignals& sent) {
    const ServiceManager manager;
    manager.tell("READY=1");
    log.write({site_link::SiteNews::Severity::note,
               {},
               "ready",
               SiteProgramText::tr("%1 is ready in domain %2 on %3")
                   .arg(QString::fromStdString(file.name))
                   .arg(file.meeting.domain.domain)
                   .arg(QString::fromStdString(file.meeting.domain.interface))
                   .toStdString()});
    std::uint64_t cycles = 0;
    std::int64_t nextTell_ns = 0;
    // In a thread of its own: a log that nobody reads must not hold up STOP.
    const std::jthread keys([&site, &sent](const std::stop_token& ends) {
        while (!ends.stop_requested() && !sent.wait(kPoll_ns))
            if (const std::optional<bool> stop = sent.takeStop())
                site.setStop(*stop);
    });
    while (!sent.wait(kPoll_ns)) {
        site.poll();
        log.flush();
        const std::int64_t now_ns = core::steadyNow_ns();
        if (now_ns < nextTell_ns)
            continue;
        nextTell_ns = now_ns + kTell_ns;
        // The service manager restarts a program whose control hangs, not only one that is gone.
        if (const std::uint64_t done = site.status().cycles; done != cycles) {
            cycles = done;
            manager.tell("WATCHDOG=1");
        }
    }
    manager.tell("STOPPING=1");
    log.write({site_link::SiteNews::Severity::note,
               {},
               "end",
               SiteProgramText::tr("the site ends; the arms are held").toStdString()});
    return kDone;
}

int run(const Options& options, const SiteSignals& sent) {
    const core::Expected<SiteFile> file = readSite(options.path);
    if (!file)
        return failedWith(file.error(), file.error().kind != core::ErrorKind::ioFailed);
    SiteLog log(options.json && !options.check);
    const auto cancelled = [&sent] { return sent.wait(0); };
    core::Expected<std::unique_ptr<RunningSite>> site =
        options.check ? RunningSite::openForCheck(*file, log, cancelled)
                      : RunningSite::open(*file, options.folders, log, cancelled);
    if (!site) {
        log.flush();
        if (site.error().kind == core::ErrorKind::cancelled)
            return kWorkFailed;
        // A device that is not there may come; a file that is wrong stays wrong.
        return failedWith(site.error(), site.error().kind == core::ErrorKind::badInput);
    }
    const int code = options.check ? check(**site, options, sent) : serve(**site, *file, log, sent);
    site->reset();
    log.flush();
    return code;
}

} // namespace

SiteSignals::SiteSignals() {
    sigemptyset(&m_signals);
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
        // nohup has made the program deaf to one.
        struct sigaction before {};
        sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN)
            sigaddset(&m_signals, signal);
    }
    sigaddset(&m_signals, SIGUSR1);
    sigaddset(&m_signals, SIGUSR2);
    pthread_sigmask(SIG_BLOCK, &m_signals, nullptr);
}

bool SiteSignals::wait(std::int64_t longest_ns) const {
    const timespec longest{longest_ns / 1'000'000'000, longest_ns % 1'000'000'000};
    const int signal = m_came ? 0 : sigtimedwait(&m_signals, nullptr, &longest);
    if (signal == SIGUSR1) {
        m_stop = Stop::engage;
        // Which of two that wait came first is not known: STOP counts.
        sigset_t withdrawn;
        sigemptyset(&withdrawn);
        sigaddset(&withdrawn, SIGUSR2);
        constexpr timespec kNoTime{};
        (void)sigtimedwait(&withdrawn, nullptr, &kNoTime);
    } else if (signal == SIGUSR2) {
        Stop before = Stop::unchanged;
        (void)m_stop.compare_exchange_strong(before, Stop::withdraw);
    } else if (signal > 0) {
        m_came = true;
    }
    return m_came;
}

std::optional<bool> SiteSignals::takeStop() const {
    const Stop stop = m_stop.exchange(Stop::unchanged);
    return stop == Stop::unchanged ? std::nullopt : std::optional(stop == Stop::engage);
}

int runProgram(int argc, const char* const* argv, const SiteSignals& sent) {
    CLI::App app(SiteProgramText::tr("Runs at the robot: sends what its arms and tactile arrays feel to the "
                                     "consoles, and decides which console moves them.")
                     .toStdString(),
                 "teleta-site");
    app.set_help_flag("-h,--help", SiteProgramText::tr("Print this help").toStdString());
    Options options;
    bool asksVersion = false;
    CLI::Option* site =
        app.add_option("site", options.path,
                       SiteProgramText::tr("File of the site (kind = \"site\")").toStdString())
            ->type_name("SITE.toml");
    app.add_flag("--check", options.check,
                 SiteProgramText::tr("Open everything, move nothing, and say what is missing").toStdString());
    app.add_flag(
        "-j,--json", options.json,
        SiteProgramText::tr("Print the log, or what is missing, as JSON on standard output").toStdString());
    app.add_option("--recordings", options.folders.recordings,
                   SiteProgramText::tr("Folder for recordings (record = true); default: the current one")
                       .toStdString())
        ->type_name("DIR");
    app.add_option("--state", options.folders.state,
                   SiteProgramText::tr("Folder that keeps who engages STOP, for the next start; default: "
                                       "$STATE_DIRECTORY, otherwise ~/.local/state/teleta-site")
                       .toStdString())
        ->type_name("DIR");
    app.add_flag("--version", asksVersion, SiteProgramText::tr("Print the version").toStdString());
    app.failure_message([](const CLI::App*, const CLI::Error& error) {
        return SiteProgramText::tr("teleta-site: %1\nRun teleta-site --help for more.\n")
            .arg(QString::fromLocal8Bit(error.what()))
            .toStdString();
    });
    try {
        app.parse(argc, argv);
        if (asksVersion) {
            std::cout << "teleta-site " << app::version().number.toStdString() << '\n';
            return kDone;
        }
        if (site->count() == 0)
            throw CLI::RequiredError("SITE.toml");
        if (options.folders.state.empty())
            options.folders.state = StopMemory::usualFolder();
        return run(options, sent);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? kDone : kWrongUsage;
    }
}

} // namespace teleta::site_program
