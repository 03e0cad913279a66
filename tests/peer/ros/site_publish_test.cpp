// SPDX-License-Identifier: GPL-3.0-or-later
// teleta-site sends its arrays to programs of ROS 2. The reader is Fast DDS.
#include "dds_node.h"
#include "messagesPubSubTypes.h"
#include "tests/peer/site/site_process.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace teleta {
namespace {

namespace fast = eprosima::fastdds::dds;
using tactile_msgs::msg::TactileState;
using test::SiteProcess;
using test::TestConsole;

double secondsOf(const TactileState& state) {
    return state.header().stamp().sec() + 1e-9 * state.header().stamp().nanosec();
}

class SitePublish : public ::testing::Test {
protected:
    /// The site at domain, ROS 2 at the next one.
    void start(int domain, const std::string& keys) {
        m_site = std::make_unique<SiteProcess>(domain, "");
        m_site->setKeysOfFile(keys);
        m_site->setDevices("[ros]\ndomain = " + std::to_string(domain + 1) +
                           "\ninterface = \"lo\"\n[[device]]\nid = \"practice\"\n"
                           "scene = \":/scenes/tactile-two-contacts.toml\"\n");
        m_site->start();
        m_node = std::make_unique<peer::DdsNode>(domain + 1);
    }
    void read(peer::Inbox<TactileState>& inbox, bool reliable) {
        m_node->read("/practice/tactile_state",
                     fast::TypeSupport(new tactile_msgs::msg::TactileStatePubSubType),
                     {.reliable = reliable, .transientLocal = false, .depth = 64}, &inbox);
    }
    /// At least 100, and until the scene presses: at most 10 s.
    [[nodiscard]] static std::vector<TactileState> some(peer::Inbox<TactileState>& inbox) {
        std::vector<TactileState> got;
        (void)TestConsole::eventually([&] {
            for (TactileState& state : inbox.take())
                got.push_back(std::move(state));
            return got.size() >= 100 && std::ranges::any_of(got, [](const TactileState& state) {
                       return std::ranges::any_of(state.sensors()[0].values(),
                                                  [](float value) { return value > 0.1F; });
                   });
        });
        return got;
    }

    std::unique_ptr<SiteProcess> m_site;
    std::unique_ptr<peer::DdsNode> m_node;
};

TEST_F(SitePublish, anArrayIsATactileStateWithNameValuesAndTheTimeOfTheRead) {
    peer::Inbox<TactileState> inbox;
    start(152, "publish_tactile_state = true\n");
    read(inbox, false);
    const std::vector<TactileState> states = some(inbox);
    ASSERT_GE(states.size(), 100U);
    const double now_s =
        1e-9 * static_cast<double>(
                   std::chrono::nanoseconds(std::chrono::system_clock::now().time_since_epoch()).count());
    float largest = 0.0F;
    for (std::size_t i = 0; i < states.size(); ++i) {
        ASSERT_EQ(states[i].sensors().size(), 1U);
        EXPECT_EQ(states[i].sensors()[0].name(), "practice");
        EXPECT_EQ(states[i].header().frame_id(), "practice");
        const std::vector<float>& values = states[i].sensors()[0].values();
        ASSERT_EQ(values.size(), 84U) << "6 x 14 taxels";
        largest = std::max(largest, *std::ranges::max_element(values));
        EXPECT_LT(std::abs(secondsOf(states[i]) - now_s), 30.0);
        if (i > 0) {
            EXPECT_GT(secondsOf(states[i]), secondsOf(states[i - 1]));
        }
    }
    EXPECT_GT(largest, 0.1F) << "the scene presses";
}

TEST_F(SitePublish, aReaderThatAsksForReliableSamplesNeedsTheKeyForIt) {
    peer::Inbox<TactileState> without;
    start(154, "publish_tactile_state = true\n");
    read(without, true);
    EXPECT_TRUE(TestConsole::eventually([&] { return without.incompatible() > 0; }));
    EXPECT_TRUE(without.take().empty());
    m_node.reset();
    m_site.reset();

    peer::Inbox<TactileState> with;
    start(156, "publish_tactile_state = true\nros_reliable = true\n");
    read(with, true);
    EXPECT_GE(some(with).size(), 100U);
    EXPECT_EQ(with.incompatible(), 0);
}

} // namespace
} // namespace teleta
