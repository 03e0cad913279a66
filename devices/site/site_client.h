// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/device/arm_device.h"
#include "backend/core/device/stream_tap.h"
#include "backend/core/error.h"
#include "backend/core/threads/latest_copy.h"
#include "backend/core/threads/mailbox.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/recording/recording_types.h"
#include "backend/site/clock_estimator.h"
#include "backend/site/control_arbiter.h"
#include "backend/site/operator_hand.h"
#include "devices/dds/discovery.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/participant.h"
#include "devices/dds/wait_set.h"
#include "devices/site/remote_site_file.h"
#include "devices/site/site_topics.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace teleta::site_link {

/// An arm of a site as its last state told it.
struct RemoteArmState {
    std::string name;
    core::ArmDrive drive = core::ArmDrive::held;
    std::uint32_t flags = 0; ///< limits that act, arm_model::MotionFlag
    std::string message;     ///< why it does not move; empty: nothing is in the way
};

/// The answer to the last request of this console.
struct RequestOutcome {
    std::uint64_t id = 0;
    site::RequestKind kind = site::RequestKind::request;
    site::RequestAnswer answer = site::RequestAnswer::waits;
    std::optional<std::string> declined{}; ///< another console declined it, with this reason or without one
};

/// What happened at the site, as it told.
struct RemoteEvent {
    std::int64_t site_ns = 0;
    int severity = 0; ///< 0 note, 1 warning, 2 error
    std::string source;
    std::string code;
    std::string message;
};

/// How long the last loops took: from here to the site and back.
struct LoopTimes {
    double median_s = 0.0;
    double slow_s = 0.0; ///< 99 % were not slower
};

/// What a console knows of a site now.
struct SiteView {
    bool reached = false;          ///< its state came within kSilence_ns
    std::int64_t lastState_ns = 0; ///< console's clock; 0: never
    site::Mode mode = site::Mode::free;
    std::string controller; ///< empty: nobody
    std::string offeredTo;
    std::uint64_t epoch = 0;
    double controlLeft_s = 0.0;
    double offerLeft_s = 0.0;
    std::vector<std::string> stopHolders;
    std::vector<std::string> viewers;
    std::vector<std::string> consoles; ///< all that are there, this one included
    /// Who sits at a console, as the console tells; of those that tell somebody.
    std::map<std::string, std::string> persons;
    std::vector<RemoteArmState> arms;
    std::uint64_t accepted = 0;
    std::uint64_t refused = 0;
    site::CommandRefusal lastRefusal = site::CommandRefusal::none;
    /// Those that were refused while this console looked, by reason. A state tells the last reason alone: to
    /// that one all are counted which were refused since the state before.
    std::array<std::uint64_t, site::kRefusals> refusedBy{};
    std::uint64_t statesLost = 0;
    std::optional<site::ClockOffset> clock;
    std::optional<std::int64_t> shownOffset_ns; ///< of the clock, slewed, for the screen
    std::optional<double> loop_s;               ///< age of the whole loop of the last probe: there and back
    std::optional<LoopTimes> loops;             ///< of the last kLoops probes
    std::uint64_t clockJumps = 0;
    std::optional<RequestOutcome> request;
    /// The switch of this console is held, but moves nothing until it is let go and pressed again: after a
    /// grant, a hand-over, STOP, a fault, or a pause of the link.
    bool pressAnew = false;
    bool granted = false; ///< this program was given control; else a controller of its name is an earlier one
    std::uint64_t boots = 0; ///< how often the site was started while this console looked

    [[nodiscard]] bool controls(const std::string& console) const {
        return reached && granted && controller == console && mode != site::Mode::free;
    }
};

/// Why this console cannot move an arm of the site now, a translated sentence without a full stop; empty:
/// nothing is in the way. Thread: any (pure).
[[nodiscard]] std::string hindranceOf(const SiteView& view, const std::string& console,
                                      const std::string& arm);

/// A console at a site: tells that it is there and whether STOP is engaged, measures the clock, asks for
/// control, and passes the operator's commands on while the dead-man switch is held. What the site's devices
/// measure comes through RemoteArm and RemoteArray. Thread: a thread of its own; all calls from any, none
/// waits but open().
class SiteClient {
public:
    static constexpr std::int64_t kSilence_ns = 300'000'000;
    static constexpr std::size_t kLoops = 64;
    /// Longer ones are not shown.
    static constexpr std::size_t kLongestPerson_bytes = 120;
    static constexpr std::int64_t kLongestOpen_ns = 8'000'000'000;

    /// Joins the domain and waits for what the site tells of itself. stop outlives the client. cancelled:
    /// looked at meanwhile. Error: as dds::Participant::open(); unavailable, the site was not found;
    /// refused, it speaks another protocol; cancelled.
    [[nodiscard]] static core::Expected<std::shared_ptr<SiteClient>>
    open(const RemoteSiteFile& file, const std::string& version, const core::StopSwitch& stop,
         const std::function<bool()>& cancelled = {});
    /// Gives control up.
    ~SiteClient();
    SiteClient(const SiteClient&) = delete;
    SiteClient& operator=(const SiteClient&) = delete;

    [[nodiscard]] const RemoteSiteFile& file() const { return m_file; }
    [[nodiscard]] const std::shared_ptr<const dds::Participant>& participant() const { return m_participant; }
    [[nodiscard]] const SiteTopics& topics() const { return m_topics; }
    /// What the site sends, as it was when the client was opened.
    [[nodiscard]] const std::vector<recording::StreamInfo>& streams() const { return m_streams; }
    /// How long control stays with a console that is silent.
    [[nodiscard]] double controlLease_s() const { return m_controlLease_s; }
    /// The site takes no command of a console that has seen nothing newer from it.
    [[nodiscard]] double loopLimit_s() const { return m_loopLimit_s; }
    /// OperatorDomain::keyWarnings() then.
    [[nodiscard]] const std::vector<std::string>& keyWarnings() const { return m_keyWarnings; }

    [[nodiscard]] SiteView view() const { return m_view.get(); }
    /// Events since the last call, in order; at most kMostEvents are kept.
    [[nodiscard]] std::vector<RemoteEvent> takeEvents();

    /// Asks the site; the answer is in SiteView::request, under the number that this returns. A viewer is
    /// not permitted anything. target: the console that it is about; of decline, the reason.
    std::uint64_t request(site::RequestKind kind, const std::string& target = {});
    /// The operator's command to an arm; a rate of zero: the switch is let go. Ignored from a viewer.
    void post(const std::string& arm, const core::ArmCommand& command);

    /// The stream of recordClock(): every accepted probe of the clock with its four raw times.
    [[nodiscard]] recording::StreamInfo clockStream() const;
    /// Where the probes go from now on; null: nowhere.
    void recordClock(std::shared_ptr<core::StreamTap> tap);

    /// The program ends, and with it this console's part: the switch counts as let go, control is given up,
    /// and STOP stays at the site as it was. A program engages STOP for its own devices when it ends; that is
    /// no STOP of a person, which would hold the site until a supervisor withdraws it.
    void leave() { m_leaves.store(true, std::memory_order_relaxed); }
    /// The same for all of them, also from the handler of a signal.
    static void leaveAll() { s_allLeave.store(true, std::memory_order_relaxed); }

    /// When something was read at the site, by the clock here; where the clock is not known yet, when it
    /// arrived.
    [[nodiscard]] std::int64_t readTime_ns(std::int64_t read_site_ns, std::int64_t arrived_ns) const;

private:
    static constexpr std::size_t kMostEvents = 256;
    struct Ends {
        dds::Reader<ros::SiteState> state;
        dds::Reader<ros::SiteEvent> event;
        dds::Reader<ros::ClockAnswer> answer;
        dds::Writer<ros::ConsolePresence> presence;
        // Permissions of a viewer do not allow these two.
        std::optional<dds::Writer<ros::ControlRequest>> request;
        std::optional<dds::Writer<ros::SiteArmCommand>> command;
        dds::Writer<ros::ClockProbe> probe;
        dds::Discovery discovery;
    };
    struct Posted {
        std::string arm;
        core::ArmCommand command;
    };
    struct Pending {
        RequestOutcome outcome;
        std::string target;
        std::int64_t until_ns = 0;
        std::int64_t next_ns = 0;
    };

    struct Told {
        std::vector<recording::StreamInfo> streams;
        double controlLease_s = 0.0;
        double loopLimit_s = 0.0;
    };

    SiteClient(RemoteSiteFile file, std::string version, std::shared_ptr<const dds::Participant> participant,
               Told told, Ends ends, const core::StopSwitch& stop);
    [[nodiscard]] static core::Expected<Told>
    findSite(const std::shared_ptr<const dds::Participant>& participant, const SiteTopics& topics,
             const RemoteSiteFile& file, const std::function<bool()>& cancelled);

    void run(const std::stop_token& stop);
    void listen();
    void take(const ros::SiteState& state, std::int64_t now_ns);
    void take(const ros::ClockAnswer& answer, std::int64_t now_ns);
    void tellPresence(std::int64_t now_ns);
    void probeClock(std::int64_t now_ns);
    void ask(std::int64_t now_ns);
    void writeRequest(std::uint64_t number, site::RequestKind kind, const std::string& target);
    void giveUp();
    void findConsoles(std::int64_t now_ns);
    void listenToOthers();
    void countRefusals();
    void judgePress(std::int64_t now_ns);
    void command(std::int64_t now_ns);
    void publish(std::int64_t now_ns);
    [[nodiscard]] bool leaves() const {
        return m_leaves.load(std::memory_order_relaxed) || s_allLeave.load(std::memory_order_relaxed);
    }

    RemoteSiteFile m_file;
    std::string m_version;
    std::shared_ptr<const dds::Participant> m_participant;
    SiteTopics m_topics;
    std::vector<recording::StreamInfo> m_streams;
    double m_controlLease_s;
    double m_loopLimit_s;
    std::vector<std::string> m_keyWarnings;
    Ends m_ends;
    const core::StopSwitch& m_stop;
    dds::WaitSet m_waitSet;
    site::BootName m_boot;
    static inline std::atomic<bool> s_allLeave{false};
    std::atomic<bool> m_leaves{false};
    core::LatestCopy<SiteView> m_view;
    core::LatestCopy<std::optional<std::int64_t>> m_offset_ns;
    std::mutex m_mutex;
    std::deque<RemoteEvent> m_events; ///< guarded by m_mutex, as the next five
    std::deque<Posted> m_posted;
    std::optional<Pending> m_pending;
    std::shared_ptr<core::StreamTap> m_clockTap;
    std::deque<std::uint64_t> m_askedControl; ///< requests that may give control, also after newer ones
    std::uint64_t m_lastRequest; ///< begins anywhere: answers to a program before are not this one's

    // The thread's own.
    SiteView m_now;
    std::optional<site::BootName> m_siteBoot;
    std::uint64_t m_stateNumber = 0;
    std::int64_t m_echoSite_ns = 0;
    site::ClockEstimator m_clock;
    site::SlewedOffset m_shownOffset;
    std::deque<double> m_loops_s; ///< of the last probes
    std::map<std::string, std::optional<dds::Reader<ros::ConsolePresence>>>
        m_others;                           ///< nothing: not allowed
    std::optional<std::uint64_t> m_refused; ///< as the last state of this program of the site told
    site::OperatorHand m_hand;
    /// What the site had counted at its last state since the switch was pressed. Nothing: the switch is not
    /// held, or what is refused may still be from before.
    struct Counted {
        std::uint64_t accepted = 0;
        std::uint64_t pressAnew = 0;
    };
    std::optional<Counted> m_sincePress;
    std::uint32_t m_press = 0; ///< that m_pressed_ns is of
    std::int64_t m_pressed_ns = 0;
    std::uint64_t m_engagements = 0; ///< of STOP, that the hand knows of
    Posted m_newest;
    std::uint64_t m_commandNumber = 0;
    std::uint64_t m_presenceNumber = 0;
    std::uint32_t m_probeNumber = 0;
    std::int64_t m_started_ns = 0;
    std::int64_t m_nextPresence_ns = 0;
    std::int64_t m_nextProbe_ns = 0;
    std::int64_t m_nextCommand_ns = 0;
    std::int64_t m_nextLook_ns = 0;
    bool m_toldStop = false;
    bool m_released = false; ///< control was given up for the end

    std::jthread m_thread;
};

} // namespace teleta::site_link
