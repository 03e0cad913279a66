// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace teleta::site {

/// Random at each start of a program, so that a restarted one is not taken for the one before.
using BootName = std::array<std::uint8_t, 16>;

/// Leases of a site; all > 0. Steady clock of the site.
struct LeaseTimes {
    std::int64_t motion_ns = 100'000'000;     ///< from the last accepted command
    std::int64_t control_ns = 2'000'000'000;  ///< from the last presence or command of the controller
    std::int64_t offer_ns = 10'000'000'000;   ///< to accept a hand-over
    std::int64_t takeOver_ns = 5'000'000'000; ///< to decline a take-over
    std::int64_t loopLimit_ns = 500'000'000;  ///< largest age of the newest state that the console had seen
    std::int64_t gap_ns = 500'000'000;        ///< after a longer gap the switch must be pressed anew
    std::int64_t presence_ns = 1'000'000'000; ///< a console that is silent for longer has vanished
    /// A console that has been there for less is given no control: whether its switch is held, and for how
    /// long, shows in its commands.
    std::int64_t known_ns = 300'000'000;
};

/// Numbers are those of SiteState.mode.
enum class Mode : std::uint8_t { free = 0, held = 1, moving = 2, offered = 3, stopped = 4, fault = 5 };

/// Numbers are those of ControlRequest.kind.
enum class RequestKind : std::uint8_t {
    request = 1,
    release = 2,
    offer = 3,
    accept = 4,
    decline = 5,
    takeOver = 6,
    withdrawStop = 7,
    clearFault = 8,
};

/// Numbers are those of RequestResult.result.
enum class RequestAnswer : std::uint8_t {
    waits = 0,
    done = 1,
    busy = 2,
    notPermitted = 3,
    noSuchConsole = 4,
    notController = 5,
    stopped = 6,
    expired = 7,
};

/// Why a command was not accepted: the first condition that does not hold. Numbers are those of
/// SiteState.last_refusal.
enum class CommandRefusal : std::uint8_t {
    none = 0,
    notController = 1, ///< also: the controller's offer is open
    oldEpoch = 2,
    stopped = 3,
    pressAnew = 4, ///< the dead-man switch must be let go and pressed again
    oldNumber = 5,
    oldLoop = 6, ///< the console commands after a state that is too old
    unknownArm = 7,
    notFinite = 8,
    notLive = 9, ///< the arm's readings are stale, or it has a fault
    otherBoot = 10,
};
inline constexpr std::size_t kRefusals = 11; ///< values of CommandRefusal

/// What a console tells of itself, ten times a second.
struct Presence {
    BootName boot{};
    bool viewer = false;
    bool stopEngaged = false;
};

/// Who engages STOP. It is kept for the next start of the site's program.
struct StopHolders {
    bool site = false; ///< somebody at the site
    /// Consoles, with the program that did.
    std::set<std::pair<std::string, BootName>> consoles;

    [[nodiscard]] bool any() const { return site || !consoles.empty(); }
    bool operator==(const StopHolders&) const = default;
};

/// What decides whether a command is accepted. The site looks at arm and values before.
struct CommandHead {
    BootName boot{};
    std::uint64_t number = 0;
    std::uint64_t epoch = 0;
    std::uint32_t press = 0;      ///< how often the dead-man switch was pressed
    bool hold = false;            ///< the switch was let go
    std::int64_t echoSite_ns = 0; ///< site_ns of the newest state that the console had seen
    bool armKnown = true;         ///< arm, kind and length of the values are known
    bool finite = true;
    bool armLive = true;
};

/// Who may move the arms of a site: one console at a time, by leases. Pure: time is an argument, in ns of the
/// site's steady clock, and never goes back.
///   free     --request--> held, epoch + 1 --accepted command--> moving --lease over or hold--> held
///   held     --offer--> offered --accept--> held by the other, epoch + 1; decline or time over --> held
///   any      --release, control lease over--> free; held by a supervisor who waits to take over
///   held     --take over by a supervisor--> offered; 5 s to decline, then held by the supervisor, epoch + 1
///   any      --STOP of any console or at the site--> stopped, until every holder withdrew; control and epoch
///   stay any      --fault--> fault, until the controller clears it and its cause is gone
/// STOP is a level: a console that vanishes while it engages STOP keeps it engaged. After a grant, an
/// offer, STOP, a fault, a hold, or a gap of more than LeaseTimes::gap_ns a command needs a newer press than
/// any that was seen before, those of refused commands included. Thread: one.
class ControlArbiter {
public:
    /// The holder of STOP that is the site itself.
    static constexpr const char* kSiteHolder = "site";
    /// A longer reason of a decline is dropped.
    static constexpr std::size_t kLongestReason_bytes = 400;
    /// STOPs that are kept of programs of one name; as long as there are so many, a further one adds nothing.
    static constexpr std::size_t kMostStopsOfName = 16;

    /// stops: of the program of this site before. epoch: that of no controller; not that of the program
    /// before, whose commands may still be on their way.
    explicit ControlArbiter(std::set<std::string> supervisors, const LeaseTimes& times = {},
                            StopHolders stops = {}, std::uint64_t epoch = 0);

    /// Ends the leases that are over. Call it before state is looked at, and at least every motion lease.
    void advance(std::int64_t now_ns);

    /// False: another program of that name is alive; the presence is ignored, except that its STOP counts.
    bool presence(const std::string& console, const Presence& presence, std::int64_t now_ns);

    /// A request; the same id of the same console is answered as before without doing it again. target: the
    /// console that it is about (offer, withdrawStop); of decline, the reason, at most kLongestReason_bytes.
    /// waits: an offer or a take-over is open, or the console has just come; it asks again then.
    RequestAnswer request(const std::string& console, const BootName& boot, std::uint64_t id,
                          RequestKind kind, const std::string& target, std::int64_t now_ns);

    /// Accepts a command, or says why not. An accepted command that is no hold moves.
    CommandRefusal command(const std::string& console, const CommandHead& head, std::int64_t now_ns);

    /// STOP at the site itself.
    void setSiteStop(bool engaged);
    /// Somebody at the site withdraws the STOPs of consoles that have vanished, as a supervisor does one by
    /// one. That of a console that is there stays its own.
    void withdrawStopsOfGone(std::int64_t now_ns);
    /// An arm was held for reasons of its own: who is in control has to press the switch anew.
    void demandNewPress() { requireNewPress(); }
    /// An arm has a fault, or its cause is gone. The fault lasts until clearFault.
    void setFaultCause(bool present);

    [[nodiscard]] Mode mode(std::int64_t now_ns) const;
    /// The motion lease runs: the last accepted command counts.
    [[nodiscard]] bool mayMove(std::int64_t now_ns) const { return mode(now_ns) == Mode::moving; }
    /// Empty when control is free.
    [[nodiscard]] const std::string& controller() const { return m_controller; }
    [[nodiscard]] std::uint64_t epoch() const { return m_epoch; }
    /// Who gets control when the open offer or take-over succeeds; empty without one.
    [[nodiscard]] std::string offeredTo() const { return m_offer ? m_offer->to : std::string(); }
    [[nodiscard]] std::int64_t controlLeft_ns(std::int64_t now_ns) const;
    [[nodiscard]] std::int64_t offerLeft_ns(std::int64_t now_ns) const;
    /// Their names; the site's is kSiteHolder.
    [[nodiscard]] std::set<std::string> stopHolders() const;
    [[nodiscard]] const StopHolders& stops() const { return m_stops; }
    /// Consoles that are alive and only look.
    [[nodiscard]] std::set<std::string> viewers(std::int64_t now_ns) const;
    /// The answer to a request so far; waits when it is not known.
    [[nodiscard]] RequestAnswer answerTo(const std::string& console, std::uint64_t id) const;
    /// Why another console declined what was asked with this request, empty without a reason; nothing: it was
    /// not declined.
    [[nodiscard]] std::optional<std::string> declinedFor(const std::string& console, std::uint64_t id) const;
    /// Another program of that name has told its presence since then: this one is answered noSuchConsole
    /// whatever it asks. One that has just ended, or was killed, does not tell it any more.
    [[nodiscard]] bool isNameTaken(const std::string& console, const BootName& boot,
                                   std::int64_t since_ns) const;
    [[nodiscard]] std::uint64_t accepted() const { return m_accepted; }
    [[nodiscard]] std::uint64_t refused(CommandRefusal why) const {
        return m_refused[static_cast<std::size_t>(why)];
    }

private:
    struct Console {
        BootName boot{};
        bool viewer = false;
        std::int64_t since_ns = 0; ///< it is there
        std::int64_t seen_ns = 0;
        std::uint64_t lastNumber = 0;
        bool hasNumber = false;
        std::uint32_t highestPress = 0;                 ///< of all commands seen, refused ones too
        std::map<std::uint64_t, RequestAnswer> answers; ///< of the last requests
        std::map<std::uint64_t, std::string> declined;  ///< reasons, of those of them that were
    };
    struct Offer {
        std::string to;
        bool takeOver = false;
        std::int64_t until_ns = 0;
        std::string asker; ///< whose request waits
        std::uint64_t request = 0;
    };

    [[nodiscard]] bool alive(const std::string& console, std::int64_t now_ns) const;
    RequestAnswer carryOut(const std::string& console, RequestKind kind, const std::string& target,
                           std::uint64_t id, std::int64_t now_ns);
    RequestAnswer answerOffer(const std::string& console, bool accepts, const std::string& reason,
                              std::int64_t now_ns);
    void grant(const std::string& console, std::int64_t now_ns);
    void release(std::int64_t now_ns);
    void closeOffer(RequestAnswer answer, const std::optional<std::string>& declined = {});
    void requireNewPress();
    [[nodiscard]] CommandRefusal judge(const std::string& console, const CommandHead& head,
                                       std::int64_t now_ns) const;

    std::set<std::string> m_supervisors;
    LeaseTimes m_times;
    std::map<std::string, Console> m_consoles;
    StopHolders m_stops;
    bool m_faultCause = false;
    bool m_fault = false;

    std::string m_controller;
    std::uint64_t m_epoch = 0;
    std::int64_t m_controlUntil_ns = 0;
    std::optional<Offer> m_offer;

    std::uint32_t m_pressFloor = 0; ///< a command needs a higher press
    std::int64_t m_lastAccepted_ns = 0;
    bool m_hasAccepted = false; ///< since the grant
    bool m_moving = false;

    std::uint64_t m_accepted = 0;
    std::array<std::uint64_t, kRefusals> m_refused{};
};

} // namespace teleta::site
