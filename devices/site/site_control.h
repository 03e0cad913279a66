// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/error.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/recording/recording_types.h"
#include "backend/site/control_arbiter.h"
#include "devices/dds/discovery.h"
#include "devices/dds/participant.h"
#include "devices/dds/wait_set.h"
#include "devices/site/asked_motion.h"
#include "devices/site/console_ends.h"
#include "devices/site/site_arm.h"
#include "devices/site/site_topics.h"

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace teleta::site_link {

/// What a site's file says of control.
struct SiteSettings {
    std::string name;
    std::string version; ///< of the program
    std::set<std::string> supervisors;
    site::LeaseTimes times;
    site::StopHolders stops = {}; ///< from the program of this site before
    /// Told whenever that changes, by the control's thread; must not wait. May be empty.
    std::function<void(const site::StopHolders&)> keepStops = {};
};

/// Something that happened at a site, for its log and for the consoles.
struct SiteNews {
    enum class Severity { note, warning, error };
    Severity severity = Severity::note;
    std::string source;  ///< a console or a device; empty: the site
    std::string code;    ///< for programs: "granted", "free", "stop", "stop_withdrawn", "fault", ...
    std::string message; ///< for people, a sentence
};

/// What the site's control knows now.
struct SiteStatus {
    site::Mode mode = site::Mode::free;
    std::string controller;
    std::uint64_t epoch = 0;
    std::size_t consoles = 0; ///< known names
    std::uint64_t accepted = 0;
    std::uint64_t refused = 0;
    std::uint64_t cycles = 0;     ///< since the start: they go on as long as the control lives
    std::uint64_t lateCycles = 0; ///< that began more than kLate_ns late
};

/// The robot's end of the protocol: listens to the consoles, decides by ControlArbiter who moves the arms,
/// passes accepted commands on, and tells the state. An arm gets rates of zero whenever nobody may move it,
/// and STOP of any console stops all of them. Thread: a thread of its own with cycles of kCycle_ns; the arms
/// are commanded by it alone; status() from any.
class SiteControl {
public:
    static constexpr std::int64_t kCycle_ns = 10'000'000;
    static constexpr std::int64_t kState_ns = 50'000'000;
    static constexpr std::int64_t kLate_ns = 50'000'000;
    /// So many late cycles in kLateWindow_ns are a fault.
    static constexpr std::size_t kMostLate = 3;
    static constexpr std::int64_t kLateWindow_ns = 10'000'000'000;
    /// More names than that are ignored, and the first of them is told.
    static constexpr std::size_t kMostConsoles = 64;

    /// arms: their sources and stop outlive the control. told: called by its thread; must not wait. Error:
    /// unavailable, a topic cannot be opened.
    [[nodiscard]] static core::Expected<std::unique_ptr<SiteControl>>
    open(std::shared_ptr<const dds::Participant> participant, SiteSettings settings,
         std::vector<SiteArm> arms, const std::vector<recording::StreamInfo>& streams,
         const site::BootName& boot, core::StopSwitch& stop, std::function<void(const SiteNews&)> told);
    /// Holds the arms and ends the thread.
    ~SiteControl();
    SiteControl(const SiteControl&) = delete;
    SiteControl& operator=(const SiteControl&) = delete;

    [[nodiscard]] SiteStatus status() const { return m_status.get(); }
    /// The site's own STOP. Any thread.
    void setStop(bool engaged) { m_siteStop = engaged; }
    /// Withdraws the STOPs of consoles that have vanished, in the next cycle. Any thread.
    void withdrawStopsOfGone() { m_withdraws = true; }
    /// Tells the consoles of something besides the control of the arms. Any thread; told() is not called.
    void post(SiteNews news);

private:
    struct Writers {
        dds::Writer<ros::SiteInfo> info;
        dds::Writer<ros::SiteState> state;
        dds::Writer<ros::SiteEvent> event;
        std::vector<dds::Writer<ros::String>> descriptions;
    };

    SiteControl(std::shared_ptr<const dds::Participant> participant, SiteSettings settings,
                std::vector<SiteArm> arms, const site::BootName& boot, core::StopSwitch& stop,
                std::function<void(const SiteNews&)> told, Writers writers, dds::Discovery discovery);

    void tellInfo(const std::vector<recording::StreamInfo>& streams);
    void run(const std::stop_token& stop);
    void findConsoles();
    void listen(std::int64_t now_ns);
    void take(ConsoleEnds& console, const ros::ConsolePresence& presence, std::int64_t now_ns);
    void take(ConsoleEnds& console, const ros::ControlRequest& request, std::int64_t now_ns);
    void take(ConsoleEnds& console, const ros::SiteArmCommand& command, std::int64_t now_ns);
    void checkArms(std::int64_t now_ns);
    void moveArms(std::int64_t now_ns);
    void noteChanges(std::int64_t now_ns);
    void tellState(std::int64_t now_ns);
    void tellNews();
    void publish(const SiteNews& news);
    void tell(SiteNews::Severity severity, const std::string& source, const std::string& code,
              const std::string& message);
    [[nodiscard]] const SiteArm* armOf(const std::string& name) const;
    [[nodiscard]] std::uint64_t refused() const;

    std::shared_ptr<const dds::Participant> m_participant;
    SiteSettings m_settings;
    SiteTopics m_topics;
    std::vector<SiteArm> m_arms;
    site::BootName m_boot;
    core::StopSwitch& m_stop;
    std::function<void(const SiteNews&)> m_told;
    Writers m_writers;
    dds::Discovery m_discovery;
    dds::WaitSet m_waitSet;
    std::atomic<bool> m_siteStop;
    std::atomic<bool> m_withdraws{false};
    std::mutex m_newsMutex;
    std::vector<SiteNews> m_news; ///< posted, not told yet
    core::LatestCopy<SiteStatus> m_status;

    // The thread's own.
    site::ControlArbiter m_arbiter;
    std::map<std::string, std::unique_ptr<ConsoleEnds>> m_consoles;
    bool m_isFull = false;           ///< told that there are kMostConsoles
    std::vector<ArmHealth> m_health; ///< of each arm
    std::optional<AskedMotion> m_command;
    const SiteArm* m_commanded = nullptr;
    std::uint64_t m_commandNumber = 0;
    site::CommandRefusal m_lastRefusal = site::CommandRefusal::none;
    std::deque<std::int64_t> m_late_ns;
    std::uint64_t m_lateCycles = 0;
    std::uint64_t m_stateNumber = 0;
    std::uint64_t m_eventNumber = 0;
    std::int64_t m_nextState_ns = 0;
    std::int64_t m_nextLook_ns = 0;
    SiteStatus m_known; ///< as it was told last
    std::set<std::string> m_stopHolders;
    site::StopHolders m_keptStops;
    std::string m_keptOut; ///< why a program was, as told last

    std::jthread m_thread;
};

} // namespace teleta::site_link
