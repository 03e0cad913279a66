// SPDX-License-Identifier: GPL-3.0-or-later
// A console of another program at teleta-site: it speaks the topics of the protocol and commands what this
// project's console never does, a twist of the tip and positions of the joints. The robot is Fast DDS and
// MuJoCo; its log says where the arm was.
#include "backend/arm_model/serial_chain.h"
#include "backend/arm_model/urdf_reader.h"
#include "devices/site/boot_name.h"
#include "devices/site/console_ends.h"
#include "devices/site/lent_texts.h"
#include "devices/site/remote_site_file.h"
#include "robot_fixture.h"
#include "tests/peer/site/site_process.h"

#include <QByteArray>
#include <QCryptographicHash>

#include <Eigen/Geometry>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <iterator>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace teleta {
namespace {

using namespace std::chrono_literals;

/// Writes below console/other/ by itself.
class OtherConsole {
public:
    explicit OtherConsole(const std::string& path) {
        const auto file = site_link::readRemoteSite(path);
        EXPECT_TRUE(file) << core::describe(file.error());
        m_thread = std::jthread(
            [this, meeting = file->meeting](const std::stop_token& stop) { run(stop, *meeting.join()); });
    }

    struct Motion {
        std::uint8_t kind = 0;
        std::vector<double> values;
        std::string frame;
    };
    /// The switch is pressed from now on and asks for this.
    void press(Motion motion) {
        const std::scoped_lock lock(m_mutex);
        m_motion = std::move(motion);
        ++m_presses;
    }
    /// Asks for something else with the switch still held.
    void ask(Motion motion) {
        const std::scoped_lock lock(m_mutex);
        m_motion = std::move(motion);
    }
    void letGo() { ask({}); }
    [[nodiscard]] std::string controller() const {
        const std::scoped_lock lock(m_mutex);
        return m_controller;
    }
    [[nodiscard]] std::uint64_t accepted() const { return m_accepted; }
    [[nodiscard]] unsigned lastRefusal() const { return m_lastRefusal; }

private:
    void run(const std::stop_token& stop, const std::shared_ptr<const dds::Participant>& participant) {
        const site_link::SiteTopics topics("lab");
        auto states = *dds::Reader<ros::SiteState>::open(participant, topics.state(), site_link::kState);
        auto presence = *dds::Writer<ros::ConsolePresence>::open(participant, topics.presence(kName),
                                                                 site_link::kPresenceProfile);
        auto request =
            *dds::Writer<ros::ControlRequest>::open(participant, topics.request(kName), site_link::kRequests);
        auto command =
            *dds::Writer<ros::SiteArmCommand>::open(participant, topics.command(kName), site_link::kNewest);
        const site::BootName boot = site_link::newBootName();
        std::int64_t echo_ns = 0;
        std::uint64_t epoch = 0;
        for (std::uint64_t turn = 1; !stop.stop_requested(); ++turn) {
            (void)states.take([&](const ros::SiteState& state, const dds::SampleInfo&) {
                echo_ns = state.site_ns;
                epoch = state.epoch;
                m_accepted = state.commands_accepted;
                m_lastRefusal = state.last_refusal;
                const std::scoped_lock lock(m_mutex);
                m_controller = state.controller;
            });
            site_link::LentTexts texts;
            if (turn % 5 == 0) {
                ros::ConsolePresence here{};
                std::ranges::copy(boot, std::begin(here.console_boot));
                here.number = turn;
                here.console = texts(kName);
                here.person = texts({});
                here.version = texts("other");
                here.epoch = epoch;
                here.echo_site_ns = echo_ns;
                (void)presence.write(here);
            }
            if (turn % 10 == 0 && controller() != kName) {
                ros::ControlRequest ask{};
                std::ranges::copy(boot, std::begin(ask.console_boot));
                ask.request = 1;
                ask.kind = 1;
                ask.target = texts({});
                ask.epoch = epoch;
                (void)request.write(ask);
            }
            write(command, boot, turn, epoch, echo_ns);
            std::this_thread::sleep_for(20ms);
        }
    }
    void write(dds::Writer<ros::SiteArmCommand>& command, const site::BootName& boot, std::uint64_t number,
               std::uint64_t epoch, std::int64_t echo_ns) {
        const std::scoped_lock lock(m_mutex);
        site_link::LentTexts texts;
        ros::SiteArmCommand message{};
        std::ranges::copy(boot, std::begin(message.console_boot));
        message.number = number;
        message.epoch = epoch;
        message.press = m_presses;
        message.kind = m_motion.kind;
        message.arm = texts("arm");
        message.frame_id = texts(m_motion.frame);
        message.echo_site_ns = echo_ns;
        ros::lend(message.values, std::span(m_motion.values));
        (void)command.write(message);
    }

    static constexpr const char* kName = "other";

    mutable std::mutex m_mutex;
    Motion m_motion;
    std::uint32_t m_presses = 0;
    std::string m_controller;
    std::atomic<std::uint64_t> m_accepted{0};
    std::atomic<unsigned> m_lastRefusal{0};
    std::jthread m_thread;
};

class SiteOtherConsole : public RosArmPeer {
protected:
    void SetUp() override {
        start(150);
        writeFile("", "announce = false\n");
        m_site = std::make_unique<test::SiteProcess>(151, "[[device]]\nfile = \"" + path() + "\"\n");
        m_site->start();
        m_console = std::make_unique<OtherConsole>(m_site->fileOf("other"));
        ASSERT_TRUE(eventually([this] { return m_console->controller() == "other"; }));
        const auto model = arm_model::readUrdf(kUrdf);
        ASSERT_TRUE(model) << core::describe(model.error());
        const auto chain = arm_model::SerialChain::create(std::make_shared<const arm_model::ArmModel>(*model),
                                                          "base_link", "tool0");
        ASSERT_TRUE(chain) << core::describe(chain.error());
        m_chain = std::make_unique<arm_model::SerialChain>(*chain);
    }

    [[nodiscard]] core::JointVector angles() {
        const std::vector<json> states = logOf("state");
        const auto values =
            states.empty() ? std::vector<double>(7) : states.back()["position"].get<std::vector<double>>();
        return core::JointVector::of(values).value_or(core::JointVector::zeros(7));
    }
    [[nodiscard]] double distanceTo(const core::JointVector& target) {
        const core::JointVector now = angles();
        double largest = 0.0;
        for (std::size_t i = 0; i < target.size(); ++i)
            largest = std::max(largest, std::abs(now[i] - target[i]));
        return largest;
    }
    /// Presses again where this computer was so busy that the arm was held.
    template <typename Holds>
    [[nodiscard]] bool pressUntil(const OtherConsole::Motion& motion, const Holds& holds) {
        for (int presses = 0; presses < 20; ++presses) {
            m_console->press(motion);
            for (const auto end = std::chrono::steady_clock::now() + 2s;
                 std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(20ms)) {
                if (holds())
                    return true;
            }
            m_console->letGo();
            std::this_thread::sleep_for(100ms);
        }
        return false;
    }

    std::unique_ptr<test::SiteProcess> m_site;
    std::unique_ptr<OtherConsole> m_console;
    std::unique_ptr<arm_model::SerialChain> m_chain;
};

TEST_F(SiteOtherConsole, setsPositionsMovesTheTipAndIsHeldWhenItLetsGo) {
    const core::JointVector bent{0.0, 0.2, 0.0, 0.4, 0.0, 0.1, 0.0};
    ASSERT_TRUE(pressUntil({3, {bent.begin(), bent.end()}, {}}, [&] { return distanceTo(bent) < 3e-3; }))
        << distanceTo(bent) << " rad away, last refusal " << m_console->lastRefusal();
    m_console->letGo();
    std::this_thread::sleep_for(500ms);

    const Eigen::Vector3d from = m_chain->X_Base_Tip(angles()).translation();
    ASSERT_TRUE(
        pressUntil({2, {0.0, 0.04, 0.0, 0.0, 0.0, 0.0}, "base_link"},
                   [&] { return (m_chain->X_Base_Tip(angles()).translation() - from).norm() > 0.03; }))
        << "last refusal " << m_console->lastRefusal();
    m_console->letGo();
    std::this_thread::sleep_for(700ms);
    const core::JointVector rest = angles();
    const Eigen::Vector3d way = m_chain->X_Base_Tip(rest).translation() - from;
    EXPECT_GT(way.y(), 0.03);
    EXPECT_LT(std::hypot(way.x(), way.z()), 0.1 * way.y()) << way.transpose();
    const Eigen::AngleAxisd turn(m_chain->X_Base_Tip(bent).linear().transpose() *
                                 m_chain->X_Base_Tip(rest).linear());
    EXPECT_LT(turn.angle(), 0.02);

    std::this_thread::sleep_for(500ms);
    EXPECT_LT(distanceTo(rest), 1e-3) << "nothing moves without the switch";
}

TEST_F(SiteOtherConsole, isToldWhyAnArmDoesNotMove) {
    const std::vector<double> twist{0.0, 0.0, 0.05, 0.0, 0.0, 0.0};
    const auto refusedAs = [this](const OtherConsole::Motion& motion, site::CommandRefusal why) {
        m_console->press(motion);
        const bool isTold =
            eventually([&] { return m_console->lastRefusal() == static_cast<unsigned>(why); });
        m_console->letGo();
        return isTold;
    };
    const core::JointVector before = angles();
    EXPECT_TRUE(refusedAs({2, twist, "camera"}, site::CommandRefusal::unknownArm)) << "no such frame";
    EXPECT_TRUE(refusedAs({3, {0.1, 0.1}, {}}, site::CommandRefusal::unknownArm)) << "two angles of seven";
    EXPECT_TRUE(refusedAs({9, twist, {}}, site::CommandRefusal::unknownArm)) << "no such kind";
    EXPECT_TRUE(refusedAs({2, {0.0, 0.0, std::nan(""), 0.0, 0.0, 0.0}, {}}, site::CommandRefusal::notFinite));
    EXPECT_LT(distanceTo(before), 1e-3);
}

/// The press of before does not move it on, however the rates that are asked for come and go.
TEST_F(SiteOtherConsole, anArmThatItsEffortHasHeldWantsANewPressWhateverIsAskedBetween) {
    m_site->kill();
    writeFile("", "announce = false\n", "effort_stop = [4.0, 4.0, 4.0, 4.0, 4.0, 4.0, 4.0]\n");
    m_site->start();
    ASSERT_TRUE(eventually([this] { return m_console->controller() == "other"; }));
    const OtherConsole::Motion turn{site_link::kRatesCommand, {0.0, 0.0, 0.2, 0.0, 0.0, 0.0, 0.0}, {}};
    const OtherConsole::Motion none{site_link::kRatesCommand, std::vector<double>(7), {}};
    core::JointVector from = angles();
    ASSERT_TRUE(pressUntil(turn, [&] { return distanceTo(from) > 0.05; }))
        << "last refusal " << m_console->lastRefusal();
    ASSERT_TRUE(m_robot.command("push 10 0 0"));
    ASSERT_TRUE(eventually([this] {
        const std::size_t commands = logOf("trajectory").size();
        std::this_thread::sleep_for(300ms);
        return logOf("trajectory").size() == commands;
    }));
    ASSERT_TRUE(m_robot.command("push 0 0 0"));
    // What has held it is over, also in the mean of the efforts at rest.
    std::this_thread::sleep_for(1500ms);
    from = angles();
    m_console->ask(none);
    std::this_thread::sleep_for(300ms);
    m_console->ask(turn);
    std::this_thread::sleep_for(1s);
    EXPECT_LT(distanceTo(from), 5e-3);
    EXPECT_EQ(m_console->lastRefusal(), static_cast<unsigned>(site::CommandRefusal::pressAnew));
    m_console->letGo();
    EXPECT_TRUE(pressUntil(turn, [&] { return distanceTo(from) > 0.05; }))
        << "last refusal " << m_console->lastRefusal();
}

TEST_F(SiteOtherConsole, isToldWhatTheArmIs) {
    const auto participant = site_link::readRemoteSite(m_site->fileOf("other"))->meeting.join();
    ASSERT_TRUE(participant) << core::describe(participant.error());
    auto reader = *dds::Reader<ros::SiteInfo>::open(*participant, site_link::SiteTopics("lab").info(),
                                                    site_link::kLatched);
    std::ifstream file(kUrdf, std::ios::binary);
    const QByteArray urdf = QByteArray::fromStdString(std::string(std::istreambuf_iterator<char>(file), {}));
    const QByteArray sum = QCryptographicHash::hash(urdf, QCryptographicHash::Sha256);
    bool isTold = false;
    EXPECT_TRUE(eventually([&] {
        (void)reader.take([&](const ros::SiteInfo& info, const dds::SampleInfo&) {
            const auto arms = ros::view(info.arms);
            ASSERT_EQ(arms.size(), 1U);
            EXPECT_STREQ(arms[0].tip_frame, "tool0");
            EXPECT_STREQ(arms[0].adapter, "trajectory");
            EXPECT_EQ(arms[0].tip_linear_m_per_s, 0.1);
            EXPECT_EQ(arms[0].tip_angular_rad_per_s, 1.0);
            EXPECT_TRUE(std::ranges::equal(arms[0].description_sha256, sum, [](auto one, char other) {
                return static_cast<char>(one) == other;
            }));
            for (const auto& stream : ros::view(info.streams))
                EXPECT_FALSE(stream.simulated) << stream.name;
            isTold = true;
        });
        return isTold;
    }));
}

} // namespace
} // namespace teleta
