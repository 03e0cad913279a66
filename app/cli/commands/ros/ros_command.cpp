// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/commands/ros/arm_check_report.h"
#include "app/cli/commands/ros/echo_text.h"
#include "app/cli/commands/ros/ros_commands.h"
#include "backend/core/data/output_file.h"
#include "backend/core/failure.h"
#include "backend/ros/messages.h"
#include "backend/ros/node_list.h"
#include "backend/ros/topic_names.h"
#include "devices/dds/discovery.h"
#include "devices/dds/domain_config.h"
#include "devices/dds/endpoint.h"
#include "devices/dds/participant.h"
#include "devices/dds/qos_text.h"
#include "devices/dds/wait_set.h"

#include <QCoreApplication>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::cli {

namespace {

using Clock = std::chrono::steady_clock;

struct RosText {
    Q_DECLARE_TR_FUNCTIONS(RosCommand)
};

/// Other programs repeat what they are within 2 s.
constexpr std::chrono::milliseconds kDiscovery{2500};
constexpr std::chrono::seconds kTopicWait{5};
/// Between looks for an interruption.
constexpr std::chrono::milliseconds kWaitAtMost{50};

/// What writers of a topic offer: "reliable", "best_effort" or, of several that differ, "mixed".
template <typename Value>
std::optional<std::string_view> common(const std::vector<dds::FoundEnd>& ends, Value ros::QosProfile::*member,
                                       std::array<std::string_view, 2> words) {
    std::optional<std::string_view> word;
    for (const dds::FoundEnd& end : ends) {
        if (!end.writes)
            continue;
        const std::string_view own = words[static_cast<std::size_t>(end.profile.*member)];
        word = word && *word != own ? "mixed" : own;
    }
    return word;
}

class RosCommand : public CommandGroup {
public:
    void declare(CLI::App& app) {
        app.require_subcommand(1);
        CLI::App& topics = addPart(app, "topics", RosText::tr("List topics and who publishes and reads them"),
                                   [this] { return listTopics(); });
        declareDomain(topics);
        declareJson(topics, m_json);
        CLI::App& nodes =
            addPart(app, "nodes", RosText::tr("List the nodes of programs"), [this] { return listNodes(); });
        declareDomain(nodes);
        declareJson(nodes, m_json);
        CLI::App& echo = addPart(app, "echo", RosText::tr("Print what is sent on a topic, until Ctrl-C"),
                                 [this] { return printMessages(); });
        addOption(echo, "topic", m_topic, RosText::tr("Name of the topic, for example /joint_states"),
                  "TOPIC")
            ->required();
        addOption(echo, "--count", m_count, RosText::tr("End after so many messages"), "N")
            ->check(CLI::Range(1, 1'000'000'000));
        declareDomain(echo);
        declareJson(echo, m_json);
        CLI::App& check =
            addPart(app, "check", RosText::tr("Watch an arm for 5 s and report what prevents moving it"),
                    [this] { return reportArmCheck(m_armPath, m_json); });
        addOption(check, "arm", m_armPath, RosText::tr("File that describes the arm (kind = \"ros_arm\")"),
                  "ARM.toml")
            ->required();
        declareJson(check, m_json);
    }

private:
    void declareDomain(CLI::App& app) {
        addOption(app, "--domain", m_domain,
                  RosText::tr("Number of the domain; default: ROS_DOMAIN_ID of the environment, else 0"), "N")
            ->check(CLI::Range(0, dds::kHighestDomain));
        addOption(app, "--interface", m_interface,
                  RosText::tr("Network interface, its name or its address; default: the first one"), "I");
        addOption(app, "--peer", m_peers,
                  RosText::tr("Computer on which to look for programs besides this one; may be repeated. "
                              "Multicast is not used"),
                  "P")
            ->allow_extra_args(false);
    }

    [[nodiscard]] core::Expected<std::shared_ptr<const dds::Participant>> join() {
        if (!m_domain) {
            TELETA_TRY(m_domain, dds::defaultDomain());
        }
        return dds::Participant::open({*m_domain, m_interface, m_peers});
    }

    /// Where other programs were looked for.
    [[nodiscard]] QString places() const {
        QStringList peers{RosText::tr("this computer")};
        for (const std::string& peer : m_peers)
            peers << QString::fromStdString(peer);
        return peers.join(QStringLiteral(", "));
    }

    /// Waits, with looks at done(), until the time is over or the user interrupts.
    template <typename Done>
    static bool waitUntil(dds::WaitSet& waitSet, Clock::duration longest, const Done& done) {
        const auto end = Clock::now() + longest;
        while (!interrupted()) {
            if (done())
                return true;
            if (Clock::now() >= end)
                return false;
            waitSet.wait(std::chrono::nanoseconds(kWaitAtMost).count());
        }
        return false;
    }

    void warnIfAlone(const dds::Discovery& discovery) const {
        if (discovery.otherPrograms() == 0)
            warn(RosText::tr(
                     "no program of domain %1 was found on: %2. Name the robot's computer with --peer, "
                     "since multicast is not used.")
                     .arg(*m_domain)
                     .arg(places()));
    }

    [[nodiscard]] core::Expected<void> listTopics() {
        TELETA_TRY(const auto participant, join());
        TELETA_TRY(const dds::Discovery discovery, dds::Discovery::open(participant));
        dds::WaitSet waitSet(participant);
        (void)waitUntil(waitSet, kDiscovery, [] { return false; });
        std::map<std::pair<std::string, std::string>, std::vector<dds::FoundEnd>> topics;
        for (const dds::FoundEnd& end : discovery.ends()) {
            const std::optional<std::string> topic = ros::rosTopicOf(end.ddsTopic);
            if (topic && !end.own)
                topics[{*topic, ros::rosTypeOf(end.ddsType)}].push_back(end);
        }
        constexpr std::array<std::string_view, 6> kColumns{"topic",       "type",        "publishers",
                                                           "subscribers", "reliability", "durability"};
        TELETA_TRY(RowOutput rows, RowOutput::open(kColumns, {m_json, {}}));
        for (const auto& [name, ends] : topics) {
            rows.text(name.first);
            rows.text(name.second);
            const auto publishers = std::ranges::count(ends, true, &dds::FoundEnd::writes);
            rows.integer(publishers);
            rows.integer(static_cast<long long>(ends.size()) - publishers);
            for (const auto& word :
                 {common(ends, &ros::QosProfile::reliability, {"best_effort", "reliable"}),
                  common(ends, &ros::QosProfile::durability, {"volatile", "transient_local"})}) {
                if (word)
                    rows.text(*word);
                else
                    rows.number(std::optional<double>());
            }
            rows.endRow();
        }
        TELETA_CHECK(unlessCut(rows.finish()));
        warnIfAlone(discovery);
        return {};
    }

    [[nodiscard]] core::Expected<void> listNodes() {
        TELETA_TRY(const auto participant, join());
        TELETA_TRY(const dds::Discovery discovery, dds::Discovery::open(participant));
        // More than one program tells its nodes, each with one message.
        const ros::QosProfile profile = ros::kLatchedReader;
        TELETA_TRY(auto jazzy, dds::Reader<ros::JazzyNodes>::open(participant, ros::kNodesTopic,
                                                                  profile.withDepth(kProgramsKept)));
        TELETA_TRY(auto humble, dds::Reader<ros::HumbleNodes>::open(participant, ros::kNodesTopic,
                                                                    profile.withDepth(kProgramsKept)));
        dds::WaitSet waitSet(participant);
        waitSet.attach(jazzy);
        waitSet.attach(humble);
        // The newest message of a program counts.
        std::map<std::string, std::vector<ros::Node>> programs;
        const auto take = [&programs](const auto& message, const dds::SampleInfo&) {
            // The first 16 bytes name the program, in both.
            const auto nodes = ros::nodesOf(message);
            if (nodes)
                programs[std::string(reinterpret_cast<const char*>(message.gid.data), 16)] = *nodes;
        };
        (void)waitUntil(waitSet, kDiscovery, [&] {
            (void)jazzy.take(take);
            (void)humble.take(take);
            return false;
        });
        std::vector<ros::Node> nodes;
        for (const auto& [gid, own] : programs)
            nodes.insert(nodes.end(), own.begin(), own.end());
        std::ranges::sort(nodes, {}, &ros::Node::name);
        constexpr std::array<std::string_view, 3> kColumns{"node", "publishers", "subscribers"};
        TELETA_TRY(RowOutput rows, RowOutput::open(kColumns, {m_json, {}}));
        for (const ros::Node& node : nodes) {
            rows.text(node.name);
            rows.integer(static_cast<long long>(node.publishers));
            rows.integer(static_cast<long long>(node.subscribers));
            rows.endRow();
        }
        TELETA_CHECK(unlessCut(rows.finish()));
        warnIfAlone(discovery);
        return {};
    }

    [[nodiscard]] core::Expected<void> printMessages() {
        const std::string topic = m_topic.starts_with('/') ? m_topic : "/" + m_topic;
        if (!ros::isTopicName(topic))
            refuse("topic",
                   RosText::tr("\"%1\" is no name of a topic; expected parts of letters, digits and _ "
                               "after slashes, for example /joint_states")
                       .arg(QString::fromStdString(m_topic)));
        TELETA_TRY(const auto participant, join());
        TELETA_TRY(const dds::Discovery discovery, dds::Discovery::open(participant));
        dds::WaitSet waitSet(participant);
        std::vector<dds::FoundEnd> writers;
        const bool found = waitUntil(waitSet, kTopicWait, [&] {
            writers = discovery.endsOf(ros::ddsTopicOf(topic));
            std::erase_if(writers, [](const dds::FoundEnd& end) { return !end.writes || end.own; });
            return !writers.empty();
        });
        if (interrupted())
            return core::Unexpected(interruption());
        if (!found)
            return core::failed(core::ErrorKind::unavailable,
                                RosText::tr("nobody published %1 in domain %2 within %3 s; looked for on: %4")
                                    .arg(QString::fromStdString(topic))
                                    .arg(*m_domain)
                                    .arg(kTopicWait.count())
                                    .arg(places()));
        const std::string typeName = ros::rosTypeOf(writers.front().ddsType);
        const ros::MessageType* type = ros::findMessageType(typeName);
        if (type == nullptr)
            return core::refused(RosText::tr("%1 has the type %2, which is not known")
                                     .arg(QString::fromStdString(topic), QString::fromStdString(typeName)),
                                 knownTypes());
        return echo(participant, waitSet, topic, *type, writers);
    }

    [[nodiscard]] static QString knownTypes() {
        QStringList names;
        for (const ros::MessageType& type : ros::messageTypes())
            names << QString::fromUtf8(type.name.data(), static_cast<qsizetype>(type.name.size()));
        return names.join(QStringLiteral(", "));
    }

    [[nodiscard]] core::Expected<void> echo(const std::shared_ptr<const dds::Participant>& participant,
                                            dds::WaitSet& waitSet, const std::string& topic,
                                            const ros::MessageType& type,
                                            const std::vector<dds::FoundEnd>& writers) const {
        // What was said before this program came is wanted as well, where a writer keeps it.
        const bool latched = std::ranges::any_of(writers, [](const dds::FoundEnd& end) {
            return end.profile.durability == ros::Durability::transientLocal &&
                   end.profile.reliability == ros::Reliability::reliable;
        });
        const ros::QosProfile profile =
            (latched ? ros::kLatchedReader : ros::kSensorReader).withDepth(kMessagesKept);
        TELETA_TRY(auto reader,
                   dds::AnyReader::open(participant, ros::ddsTopicOf(topic), *type.descriptor, profile));
        waitSet.attach(reader);
        core::OutputFile output = core::OutputFile::standardOutput();
        long long printed = 0;
        if (m_json)
            output.write("[");
        const auto print = [&](const void* message, const dds::SampleInfo&) {
            if (m_count && printed >= *m_count)
                return;
            const nlohmann::ordered_json json = type.json(message);
            if (m_json)
                output.write((printed > 0 ? ",\n" : "\n") +
                             json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
            else
                output.write(echoText(json));
            ++printed;
        };
        const auto silentFrom = Clock::now() + kTopicWait;
        bool warned = false;
        while (!interrupted() && !output.failed() && (!m_count || printed < *m_count)) {
            if (printed == 0 && !warned && Clock::now() >= silentFrom) {
                const std::optional<ros::QosMismatch> mismatch = reader.incompatible();
                warn(RosText::tr("nothing was sent on %1 within %2 s")
                         .arg(QString::fromStdString(topic))
                         .arg(kTopicWait.count()) +
                     (mismatch ? QStringLiteral(": ") + dds::describe(*mismatch) : QString()));
                warned = true;
            }
            if (reader.takeAny(print) > 0)
                output.flush();
            else
                waitSet.wait(std::chrono::nanoseconds(kWaitAtMost).count());
        }
        if (m_json)
            output.write("\n]\n");
        return unlessCut(output.finish());
    }

    static constexpr int kProgramsKept = 64;
    static constexpr int kMessagesKept = 64;

    std::optional<int> m_domain;
    std::string m_interface;
    std::vector<std::string> m_peers;
    std::string m_topic;
    std::string m_armPath;
    std::optional<long long> m_count;
    bool m_json = false;
};

} // namespace

Command rosCommand() {
    return makeCommand<RosCommand>("ros", RosText::tr("Topics and nodes of ROS 2, without ROS"),
                                   "teleta ros topics --interface lo --json\n"
                                   "  teleta ros nodes --interface lo");
}

} // namespace teleta::cli
