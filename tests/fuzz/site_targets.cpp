// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/site/site_file.h"
#include "backend/arm_model/serial_chain.h"
#include "backend/arm_model/urdf_reader.h"
#include "backend/site_keys/signed_document.h"
#include "devices/site/asked_motion.h"
#include "devices/site/remote_site_file.h"
#include "devices/site/site_topics.h"
#include "devices/site/stream_descriptions.h"
#include "tests/backend/pipeline/scripted_arm_source.h"
#include "tests/fuzz/byte_source.h"
#include "tests/fuzz/fuzz_check.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/support/floating_point_traps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace teleta::fuzz {

namespace {

/// An arm with a joint of each kind; nothing moves it.
class FuzzedArm : public test::ScriptedArmSource {
public:
    static constexpr std::size_t kJoints = 3;

    FuzzedArm() {
        const auto model = arm_model::parseUrdf(
            "<robot name='r'><link name='base'/><link name='a'/><link name='b'/><link name='tool'/>"
            "<joint name='x' type='continuous'><parent link='base'/><child link='a'/><axis xyz='0 0 1'/>"
            "<limit effort='1' velocity='2'/></joint><joint name='y' type='revolute'><parent link='a'/>"
            "<child link='b'/><origin xyz='0.3 0 0'/><axis xyz='0 1 0'/>"
            "<limit lower='-2' upper='2' effort='1' velocity='1'/></joint><joint name='z' type='prismatic'>"
            "<parent link='b'/><child link='tool'/><origin xyz='0.2 0 0'/><axis xyz='1 0 0'/>"
            "<limit lower='0' upper='0.1' effort='1' velocity='0.2'/></joint></robot>",
            "fuzzed.urdf");
        require(model.has_value(), "the arm of the test can be read");
        auto chain = arm_model::SerialChain::create(std::make_shared<const arm_model::ArmModel>(*model),
                                                    "base", "tool");
        require(chain.has_value(), "it is a chain");
        m_chain = std::make_shared<const arm_model::SerialChain>(std::move(*chain));
        m_description.lowest_rad = m_chain->lowest();
        m_description.highest_rad = m_chain->highest();
        m_description.fastest_radPerS = m_chain->fastest();
    }
    [[nodiscard]] const core::ArmDescription& description() const override { return m_description; }
    [[nodiscard]] double fastest(std::size_t joint) const { return m_description.fastest_radPerS[joint]; }
    [[nodiscard]] site_link::SiteArm at(const core::JointVector& angles) {
        site_link::SiteArm arm;
        arm.source = this;
        arm.chain = m_chain;
        arm.angles = [angles] { return site_link::ArmReading{angles, 0}; };
        return arm;
    }

private:
    core::ArmDescription m_description;
    std::shared_ptr<const arm_model::SerialChain> m_chain;
};

} // namespace

bool sitePermissions(Bytes bytes) {
    const std::string text = textOf(bytes);
    bool accepted = false;
    for (const char* member : {"site", "console1", "viewer1"}) {
        const site_keys::PermissionsCheck check = site_keys::checkPermissions(
            text, member, std::string("CN=") + member + ",O=TeleTA site", 1'800'000'000);
        require(std::ranges::none_of(check.problems, &std::string::empty), "a problem has a text");
        require(!check.problems.empty() ||
                    (check.role.has_value() && !check.site.empty() && check.ends_unixS > 1'800'000'000),
                "what is accepted has a role, a site and an end");
        require((check.role == site_keys::MemberRole::site) <= (std::string_view(member) == "site"),
                "nobody else is the site");
        accepted = accepted || check.problems.empty();
    }
    return accepted;
}

bool siteGovernance(Bytes bytes) {
    const std::string text = textOf(bytes);
    const std::vector<std::string> problems = site_keys::checkGovernance(text);
    require(std::ranges::none_of(problems, &std::string::empty), "a problem has a text");
    require(!problems.empty() || text.find("ENCRYPT") != std::string::npos, "what is accepted is encrypted");
    return problems.empty();
}

bool siteFile(Bytes bytes) {
    const core::Expected<site_program::SiteFile> file = site_program::parseSite(textOf(bytes), kInput);
    if (!file) {
        requireExplained(file.error());
        return false;
    }
    require(site_link::isSiteName(file->name) && !file->devices.empty(), "a site has a name and a device");
    require(file->meeting.security || dds::isLoopback(file->meeting.domain.interface),
            "without security nobody else is reached");
    require(file->times.motion_ns >= 60'000'000 && file->times.motion_ns <= 300'000'000,
            "the motion lease has bounds");
    for (const site_program::SiteDevice& device : file->devices)
        require(site_link::isSiteName(device.id), "a device has a name");
    return true;
}

bool remoteSiteFile(Bytes bytes) {
    const core::Expected<site_link::RemoteSiteFile> file = site_link::parseRemoteSite(textOf(bytes), kInput);
    if (!file) {
        requireExplained(file.error());
        return false;
    }
    require(site_link::isSiteName(file->name) && site_link::isSiteName(file->console), "names are names");
    require(file->meeting.security || dds::isLoopback(file->meeting.domain.interface),
            "without security nobody else is reached");
    return true;
}

bool siteMotions(Bytes bytes) {
    static FuzzedArm arm;
    const test::FloatingPointTraps traps;
    ByteSource source(bytes);
    bool any = false;
    while (!source.atEnd()) {
        const auto kind = static_cast<std::uint8_t>(source.next<std::uint8_t>() % 5U);
        const std::array<std::string, 4> frames{"", "base", "tool", "elsewhere"};
        const std::string& frame = frames[source.next<std::uint8_t>() % frames.size()];
        const std::vector<double> values = source.numbers(source.next<std::uint8_t>() % 20U);
        core::JointVector angles = core::JointVector::zeros(FuzzedArm::kJoints);
        for (double& angle : angles)
            angle = source.next<std::int8_t>() / 40.0;
        const std::optional<site_link::AskedMotion> asked =
            site_link::AskedMotion::of(kind, frame, values, arm.at(angles));
        // A site refuses others before it asks for their rates.
        if (!asked || !std::ranges::all_of(values, [](double value) { return std::isfinite(value); }))
            continue;
        any = true;
        const core::JointVector rates = asked->rates(arm.at(angles), 0);
        require(rates.size() == FuzzedArm::kJoints, "each joint has a rate");
        require(std::ranges::none_of(rates, [](double rate) { return std::isnan(rate); }),
                "a rate is a number");
        for (std::size_t i = 0; kind == site_link::kPositionsCommand && i < rates.size(); ++i)
            require(std::abs(rates[i]) <= arm.fastest(i) * (1.0 + 1e-9),
                    "no joint is asked for more than it can");
    }
    return any;
}

bool siteStreams(Bytes bytes) {
    const auto streams = site_link::readStreams(textOf(bytes), kInput);
    if (!streams) {
        requireExplained(streams.error());
        return false;
    }
    const auto again = site_link::readStreams(site_link::describeStreams(*streams), kInput);
    require(again.has_value() && again->size() == streams->size(), "what is read can be told");
    return true;
}

} // namespace teleta::fuzz
