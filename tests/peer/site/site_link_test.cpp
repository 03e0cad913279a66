// SPDX-License-Identifier: GPL-3.0-or-later
// A site and its consoles in two network namespaces, over a link with delay and loss, with certificates. Both
// ends run on this computer, so the true offset of their clocks is 0.
#include "backend/core/steady_time.h"
#include "tests/peer/site/site_over_link.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

namespace teleta {
namespace {

using namespace std::chrono_literals;
using peer::DelayLine;
using test::LinkProgram;

constexpr double kDelay_s = test::kLinkDelay_s;

class SiteLink : public test::SiteOverLink {
protected:
    void SetUp() override {
        connect();
        if (!IsSkipped())
            startSite("[[device]]\nid = \"practice\"\nscene = \":/scenes/teleoperation.toml\"\n");
    }
    [[nodiscard]] std::unique_ptr<LinkProgram> console(const QStringList& arguments) const {
        return std::make_unique<LinkProgram>(*m_line, DelayLine::B, QStringLiteral(TELETA_PROGRAM),
                                             arguments);
    }
    [[nodiscard]] static QString file(const char* name) {
        return QString::fromStdString(path(std::string(name) + ".toml"));
    }
    [[nodiscard]] std::unique_ptr<LinkProgram> jog() const {
        return console({"arm", "jog", file("console1"), "--joint", "joint_2", "--rate", "0.3", "--seconds",
                        "2", "--yes", "--json"});
    }
    /// Prints the site's state, at the site's end of the link: it does not suffer from it.
    [[nodiscard]] std::unique_ptr<LinkProgram> watch() const {
        return std::make_unique<LinkProgram>(
            *m_line, DelayLine::A, QStringLiteral(TELETA_PROGRAM),
            QStringList{QStringLiteral("site"), QStringLiteral("watch"), file("viewer1")});
    }
    static std::vector<std::string> fieldsOf(const std::string& row) {
        std::vector<std::string> fields(1);
        for (const char c : row)
            c == ',' ? fields.push_back({}) : fields.back().push_back(c);
        return fields;
    }
};

TEST_F(SiteLink, theBoundOfTheClockHoldsOverTheLink) {
    const auto [code, out] =
        console({"site", "clock", file("viewer1"), "--seconds", "6.5", "--json"})->wait();
    ASSERT_EQ(code, 0);
    const auto rows = nlohmann::json::parse(out);
    ASSERT_GE(rows.size(), 5U);
    for (const auto& row : rows) {
        EXPECT_LE(std::abs(row["offset_s"].get<double>()), row["bound_s"].get<double>()) << row;
        // Half of the way there and back at least, since how it is split cannot be seen.
        EXPECT_GE(row["bound_s"].get<double>(), kDelay_s) << row;
    }
}

TEST_F(SiteLink, anArmIsMovedOverTheLink) {
    const auto [code, out] = jog()->wait();
    ASSERT_EQ(code, 0);
    const auto told = nlohmann::json::parse(out);
    // All of 2 s at 0.3 rad/s, unless this machine was so busy that a command came too late and held the arm.
    EXPECT_GT(told["way"].get<double>(), 0.02) << out;
    EXPECT_LT(told["way"].get<double>(), 0.65) << out;
    EXPECT_FALSE(told["time_to_rest_s"].is_null()) << out;
}

TEST_F(SiteLink, aCutLinkHoldsTheArmAndABurstMovesNothing) {
    const auto watched = watch();
    ASSERT_TRUE(watched->waitFor(",free,"));
    for (const bool burst : {false, true}) {
        const auto moving = jog();
        ASSERT_TRUE(watched->waitFor(",moving,"));
        std::this_thread::sleep_for(500ms);
        const std::int64_t cut_ns = core::steadyNow_ns();
        setBoth({.delay_s = kDelay_s, .cut = !burst, .holds = burst});
        const auto held = watched->waitFor(",held,");
        ASSERT_TRUE(held);
        // What was on the way, the lease of 100 ms, the looks of the programs, and a busy machine. Control
        // lasts for 2 s.
        EXPECT_LT(core::elapsed_s(cut_ns, core::steadyNow_ns()), 1.5);
        const std::string accepted = fieldsOf(*held).at(6);
        // Longer than the control lease: the commands that come then are of nobody.
        ASSERT_TRUE(watched->waitFor(",free,"));
        std::this_thread::sleep_for(500ms);
        setBoth({.delay_s = kDelay_s});
        EXPECT_EQ(moving->wait().first, 1);
        std::this_thread::sleep_for(300ms);
        const auto after = console({"site", "watch", file("viewer1"), "--seconds", "0.5", "--json"})->wait();
        const auto rows = nlohmann::json::parse(after.second);
        ASSERT_FALSE(rows.empty());
        EXPECT_EQ(std::to_string(rows.back()["accepted"].get<int>()), accepted)
            << (burst ? "held and let go" : "cut");
    }
}

} // namespace
} // namespace teleta
