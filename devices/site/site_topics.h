// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/ros/qos_profile.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Names and qualities of the topics of a site, as DDS has them. Thread: any (pure).
namespace teleta::site_link {

/// The protocol that this program speaks. Another number is refused.
inline constexpr unsigned kProtocol = 1;

/// What sites, consoles and their devices may be called: a small letter, then at most 30 small letters,
/// digits and _.
[[nodiscard]] bool isSiteName(std::string_view name);

/// Kinds of a command of a console.
inline constexpr std::uint8_t kHoldCommand = 0;
inline constexpr std::uint8_t kRatesCommand = 1;
inline constexpr std::uint8_t kTwistCommand = 2;
inline constexpr std::uint8_t kPositionsCommand = 3;
/// A request that is not of control: the program of a simulated arm begins anew.
inline constexpr std::uint8_t kRestartRequest = 10;

/// Names of the topics of one site.
class SiteTopics {
public:
    explicit SiteTopics(std::string_view site)
        : m_prefix("rt/teleta/" + std::string(site) + '/') {}

    [[nodiscard]] std::string info() const { return m_prefix + "info"; }
    [[nodiscard]] std::string state() const { return m_prefix + "state"; }
    [[nodiscard]] std::string event() const { return m_prefix + "event"; }
    /// What describes each stream, as a recording does.
    [[nodiscard]] std::string streams() const { return m_prefix + "streams"; }
    [[nodiscard]] std::string description(std::string_view arm) const { return below("description", arm); }
    [[nodiscard]] std::string joints(std::string_view arm) const { return below("joints", arm); }
    [[nodiscard]] std::string tactile(std::string_view array) const { return below("tactile", array); }
    /// Of the chips of an array.
    [[nodiscard]] std::string temperatures(std::string_view array) const {
        return below("temperatures", array);
    }
    [[nodiscard]] std::string wrench(std::string_view arm) const { return below("wrench", arm); }
    [[nodiscard]] std::string image(std::string_view camera) const { return below("image", camera); }
    /// The newest pictures of a gel with nothing touching it.
    [[nodiscard]] std::string rest(std::string_view gel) const { return below("rest", gel); }

    // Written by a console, but for the answers.
    [[nodiscard]] std::string presence(std::string_view console) const { return of(console, kPresence); }
    [[nodiscard]] std::string request(std::string_view console) const { return of(console, "request"); }
    [[nodiscard]] std::string command(std::string_view console) const { return of(console, "command"); }
    [[nodiscard]] std::string clockProbe(std::string_view console) const {
        return of(console, "clock_probe");
    }
    [[nodiscard]] std::string clockAnswer(std::string_view console) const {
        return of(console, "clock_answer");
    }
    /// The console whose topic of presence this is.
    [[nodiscard]] std::optional<std::string> consoleOf(std::string_view presenceTopic) const;

private:
    static constexpr std::string_view kPresence = "presence";
    static constexpr std::string_view kConsole = "console/";

    [[nodiscard]] std::string below(std::string_view kind, std::string_view name) const {
        return m_prefix + std::string(kind) + '/' + std::string(name);
    }
    [[nodiscard]] std::string of(std::string_view console, std::string_view topic) const {
        return m_prefix + std::string(kConsole) + std::string(console) + '/' + std::string(topic);
    }

    std::string m_prefix;
};

/// The site whose topic `info` this is.
[[nodiscard]] std::optional<std::string> siteOfInfo(std::string_view ddsTopic);

// Our own ends on both sides. What a writer offers is told, what a reader needs it measures itself.
inline constexpr ros::QosProfile kLatched = ros::kLatchedWriter;
inline constexpr ros::QosProfile kNewest{ros::Reliability::bestEffort, ros::Durability::volatileData, 1};
inline constexpr ros::QosProfile kStreamed{ros::Reliability::bestEffort, ros::Durability::volatileData, 8};
inline constexpr ros::QosProfile kEvents{ros::Reliability::reliable, ros::Durability::volatileData, 100,
                                         0.005};
inline constexpr ros::QosProfile kRequests{ros::Reliability::reliable, ros::Durability::volatileData, 16,
                                           0.005};
inline constexpr ros::QosProfile kState{
    ros::Reliability::bestEffort, ros::Durability::volatileData, 1, 0.0, 0.15, 1.0};
inline constexpr ros::QosProfile kPresenceProfile{
    ros::Reliability::bestEffort, ros::Durability::volatileData, 1, 0.0, 0.3, 1.0};
/// Of blocks at 1 kHz that wait while a reader's thread sleeps.
inline constexpr int kReaderDepth = 64;

} // namespace teleta::site_link
