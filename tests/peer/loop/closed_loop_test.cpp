// SPDX-License-Identifier: GPL-3.0-or-later
// The closed loop over a link of 20 ms and 1 % loss. One namespace has a robot of Fast DDS and MuJoCo with a
// pad on its forearm, three balls on springs, and teleta-site; the other one has the operator, who feels for
// the balls. It prints what was found beside what is true. TELETA_LOOP_SEEDS sets the number of runs (10).
// The true stiffness is the constant of the ball's spring, which MuJoCo is given. Force over depth, both from
// the robot's own log, shows that the contact itself hardly yields.
#include "backend/core/quantile.h"
#include "backend/core/steady_time.h"
#include "backend/stiffness/material.h"
#include "loop_place.h"
#include "tests/peer/site/site_over_link.h"

#include <QFile>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <random>

namespace teleta {
namespace {

using nlohmann::json;
using peer::DelayLine;
using test::LinkProgram;

constexpr double kBall_m = 0.012;
constexpr std::array<double, 3> kStiffness_NPerM{282.0, 1325.9, 5000.0};
/// As pipeline::FoundObjects tells objects apart.
constexpr double kNear_m = 0.05;
constexpr int kLongestRun_ms = 400'000;

/// 20 ms, the delay of the link, and the 8 ms of a simulated link.
constexpr double kTarget_s = 0.020 + test::kLinkDelay_s + 0.008;

struct Ball {
    double x_m = 0.0;
    double y_m = 0.0;
    double z_m = 0.0;
    double stiffness_NPerM = 0.0;
};

/// Each seed has another order of the balls, and slightly other places.
std::vector<Ball> world(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::array<double, 3> stiffness_NPerM = kStiffness_NPerM;
    std::ranges::shuffle(stiffness_NPerM, random);
    std::uniform_real_distribution<double> along(-0.007, 0.007);
    std::uniform_real_distribution<double> across(-0.002, 0.002);
    std::uniform_real_distribution<double> high(-0.0005, 0.0005);
    std::vector<Ball> balls;
    for (std::size_t i = 0; i < stiffness_NPerM.size(); ++i) {
        const double far_m = test::kUpperArm_m + test::kPad_m + along(random);
        const double side_m = across(random);
        const double c = std::cos(test::kBearing_rad[i]);
        const double s = std::sin(test::kBearing_rad[i]);
        balls.push_back({.x_m = c * far_m - s * side_m,
                         .y_m = s * far_m + c * side_m,
                         .z_m = -test::kHalfThickness_m - kBall_m - 0.0005 + high(random),
                         .stiffness_NPerM = stiffness_NPerM[i]});
    }
    return balls;
}

/// What came of one ball, as loop_operator tells it.
struct Outcome {
    std::uint64_t seed = 0;
    Ball ball;
    double logged_NPerM = 0.0; ///< force over depth in the robot's log, the median
    std::vector<json> touches{};
    std::optional<json> found{};

    [[nodiscard]] std::string material() const {
        return found && (*found)["material"].is_string() ? (*found)["material"].get<std::string>() : "";
    }
    /// Nothing told is no wrong answer.
    [[nodiscard]] bool isWrong() const { return !material().empty() && !recognised(); }
    [[nodiscard]] bool recognised() const {
        return material() == stiffness::toString(stiffness::classify(ball.stiffness_NPerM));
    }
};

bool covers(const json& touch, double truth_NPerM) {
    return touch["lower"].get<double>() <= truth_NPerM && truth_NPerM <= touch.value("upper", HUGE_VAL);
}

/// Median; 0 of nothing.
double median(std::vector<double> values) {
    return values.empty() ? 0.0 : core::medianOf(values);
}

/// So many of n intervals, each of which holds with 95 %, hold at least, but once in a thousand times.
int leastCovered(int n) {
    namespace policies = boost::math::policies;
    using Policy = policies::policy<policies::discrete_quantile<policies::integer_round_up>>;
    return n == 0 ? 0
                  : static_cast<int>(
                        quantile(boost::math::binomial_distribution<double, Policy>(n, 0.95), 0.001));
}

class ClosedLoop : public test::SiteOverLink {
protected:
    void SetUp() override {
        // The limits of a bracelet's wearer are kept there.
        qputenv("XDG_CONFIG_HOME", QByteArray::fromStdString(path("config")));
    }

    /// The arm of four joints with a pad below its forearm, its columns along it.
    static void writeFiles() {
        QFile shipped(QStringLiteral(TELETA_SOURCE_DIR "/resources/arms/four-joints.urdf"));
        ASSERT_TRUE(shipped.open(QIODevice::ReadOnly));
        std::string urdf = shipped.readAll().toStdString();
        urdf.insert(urdf.rfind("</robot>"),
                    "<link name=\"pad\"/><joint name=\"pad_place\" type=\"fixed\"><parent link=\"forearm\"/>"
                    "<child link=\"pad\"/><origin xyz=\"0.175 0 -0.03\" rpy=\"3.141592653589793 0 0\"/>"
                    "</joint>");
        std::ofstream(path("arm.urdf")) << urdf;
        const char* ros = "[ros]\ndomain = 128\ninterface = \"lo\"\n";
        std::ofstream(path("arm.toml"))
            << "kind = \"ros_arm\"\nname = \"Robot\"\nbase_frame = \"base_link\"\ntip_frame = \"tool0\"\n"
               "controller = \"/arm_controller\"\neffort_unit = \"Nm\"\njoint_timeout_s = 0.25\n"
            << ros
            << "announce = false\n[limits]\nspeed_scale = 0.5\n"
            // A taxel tells where a point is to within a pitch.
            << "[touch]\ncentre_se_mm = " << 1e3 * test::kPitch_m / std::sqrt(12.0) << "\n";
        std::ofstream(path("pad.toml"))
            << "kind = \"ros_tactile\"\nname = \"pad\"\ntopic = \"/pad/tactile\"\n"
               "format = \"Float64MultiArray\"\nrows = 14\ncols = 6\npitch_mm = 3.4\nrate_Hz = 200\n"
               "threshold = 0.02\n"
            << ros;
    }

    void startRobot(std::uint64_t seed, const std::vector<Ball>& balls) {
        QStringList arguments = {"--domain",
                                 "128",
                                 "--urdf",
                                 QString::fromStdString(path("arm.urdf")),
                                 "--tip",
                                 "pad",
                                 "--start-from",
                                 "desired",
                                 "--rate",
                                 "1000",
                                 "--pad",
                                 "--pad-rate",
                                 "200",
                                 "--position",
                                 "0,0,0,-0.1",
                                 "--torque-sensors",
                                 "--effort-noise",
                                 "0.0005",
                                 "--position-noise",
                                 "0.000005",
                                 "--seed",
                                 QString::number(seed),
                                 "--seconds",
                                 "600",
                                 "--json",
                                 QString::fromStdString(path("log"))};
        for (const Ball& ball : balls)
            arguments << "--object"
                      << QString("%1,%2,%3,%4")
                             .arg(ball.x_m, 0, 'g', 12)
                             .arg(ball.y_m, 0, 'g', 12)
                             .arg(ball.z_m, 0, 'g', 12)
                             .arg(ball.stiffness_NPerM, 0, 'g', 12);
        m_robot =
            std::make_unique<LinkProgram>(*m_line, DelayLine::A, QStringLiteral(TELETA_ROS_ROBOT), arguments);
        ASSERT_TRUE(m_robot->waitFor("ready"));
    }

    [[nodiscard]] static std::vector<json> states() {
        std::vector<json> found;
        std::ifstream file(path("log"));
        for (std::string line; std::getline(file, line);) {
            json one = json::parse(line, nullptr, false);
            if (!one.is_discarded() && one["event"] == "state")
                found.push_back(std::move(one));
        }
        return found;
    }

    /// Farthest way of a joint while the switch was let go, by the robot's log.
    static double movedAtRest_rad(const std::vector<json>& states, const json& rests) {
        double farthest_rad = 0.0;
        for (const json& rest : rests) {
            const json* first = nullptr;
            for (const json& state : states) {
                const auto time_ns = state["steady_ns"].get<std::int64_t>();
                if (time_ns < rest[0].get<std::int64_t>() || time_ns > rest[1].get<std::int64_t>())
                    continue;
                first = first == nullptr ? &state : first;
                for (std::size_t i = 0; i < state["position"].size(); ++i)
                    farthest_rad = std::max(farthest_rad, std::abs(state["position"][i].get<double>() -
                                                                   (*first)["position"][i].get<double>()));
            }
        }
        return farthest_rad;
    }

    static double loggedStiffness_NPerM(const std::vector<json>& states, std::size_t ball) {
        constexpr double kLeast_N = 0.1;
        std::vector<double> ratios;
        for (const json& state : states) {
            const double depth_m = state["depth_m"][ball];
            const double force_N = state["pad_N"];
            if (force_N > kLeast_N && depth_m > 1e-5)
                ratios.push_back(force_N / depth_m);
        }
        return median(ratios);
    }

    void run(std::uint64_t seed) {
        const std::vector<Ball> balls = world(seed);
        connect(seed);
        if (IsSkipped())
            return;
        writeFiles();
        startRobot(seed, balls);
        startSite("[[device]]\nid = \"arm\"\nfile = \"" + path("arm.toml") +
                  "\"\n[[device]]\nid = \"pad\"\ntaxels = \"" + path("pad.toml") + "\"\nframe = \"pad\"\n");
        const std::int64_t began_ns = core::steadyNow_ns();
        LinkProgram hand(*m_line, DelayLine::B, QStringLiteral(TELETA_LOOP_OPERATOR),
                         {QString::fromStdString(path("console1.toml"))});
        const auto [code, out] = hand.wait(kLongestRun_ms);
        const auto rate_bitPerS = [&](DelayLine::End end) {
            return 8.0 * static_cast<double>(m_line->counts(end).bytes) /
                   core::elapsed_s(began_ns, core::steadyNow_ns());
        };
        m_fromSite_bitPerS.push_back(rate_bitPerS(DelayLine::A));
        m_fromConsole_bitPerS.push_back(rate_bitPerS(DelayLine::B));
        ASSERT_EQ(code, 0) << out;
        take(seed, balls, json::parse(out));
        m_robot->end();
        m_site->end();
        m_site.reset();
        m_robot.reset();
        m_line.reset();
        printRows(seed);
    }

    void take(std::uint64_t seed, const std::vector<Ball>& balls, const json& told) {
        const std::vector<json> logged = states();
        m_movedAtRest_rad = std::max(m_movedAtRest_rad, movedAtRest_rad(logged, told["rests"]));
        m_rests += told["rests"].size();
        m_presses += told["presses"].get<std::uint64_t>();
        m_lost += told["lost"].get<std::uint64_t>();
        m_notLocated += told["not_located"].get<int>();
        for (const json& latency_s : told["latency_s"])
            m_latency_s.push_back(latency_s);
        m_bound_s = std::max(m_bound_s, told["clock_bound_s"].get<double>());
        m_clockError_s = std::max(m_clockError_s, told["clock_offset_s"].get<double>());
        for (std::size_t i = 0; i < balls.size(); ++i) {
            Outcome outcome{.seed = seed, .ball = balls[i], .logged_NPerM = loggedStiffness_NPerM(logged, i)};
            for (const json& touch : told["places"][i])
                outcome.touches.push_back(touch);
            for (const json& object : told["objects"]) {
                if (std::hypot(object["x_m"].get<double>() - balls[i].x_m,
                               object["y_m"].get<double>() - balls[i].y_m) < kNear_m)
                    outcome.found = object;
            }
            m_outcomes.push_back(std::move(outcome));
        }
    }

    void printRows(std::uint64_t seed) const {
        for (const Outcome& outcome : m_outcomes) {
            if (outcome.seed != seed)
                continue;
            std::printf("%3llu %8.1f %8.1f %-6s %-14s", static_cast<unsigned long long>(outcome.seed),
                        outcome.ball.stiffness_NPerM, outcome.logged_NPerM, outcome.found ? "yes" : "no",
                        outcome.material().empty() ? "-" : outcome.material().c_str());
            for (const json& touch : outcome.touches) {
                if (!touch.contains("lower")) {
                    std::printf(" | %s", touch.value("refusal", "no interval").c_str());
                    continue;
                }
                std::printf(" | %.1f (%.1f to %.1f)%s%s", touch.value("value", 0.0),
                            touch["lower"].get<double>(), touch.value("upper", HUGE_VAL),
                            covers(touch, outcome.ball.stiffness_NPerM) ? "" : " misses",
                            touch["reliable"].get<bool>() ? "" : " unreliable");
                for (const json& warning : touch["warnings"])
                    std::printf(" %s", warning.get<std::string>().c_str());
            }
            std::printf("\n");
        }
        std::fflush(stdout);
    }

    std::unique_ptr<LinkProgram> m_robot;
    std::vector<Outcome> m_outcomes;
    std::vector<double> m_latency_s;
    double m_bound_s = 0.0;
    double m_clockError_s = 0.0;
    double m_movedAtRest_rad = 0.0;
    std::size_t m_rests = 0;
    std::uint64_t m_presses = 0;
    std::uint64_t m_lost = 0;
    std::vector<double> m_fromSite_bitPerS; ///< of each run, on the link
    std::vector<double> m_fromConsole_bitPerS;
    int m_notLocated = 0;
};

TEST_F(ClosedLoop, objectsOfUnknownMaterialAreFoundOverALink) {
    const char* wanted = std::getenv("TELETA_LOOP_SEEDS");
    const int seeds = wanted != nullptr ? std::max(1, std::atoi(wanted)) : 10;
    std::printf("seed, true N/m, N/m by the robot's log, found, material | a touch: N/m (95 %%)\n");
    for (int seed = 1; seed <= seeds; ++seed) {
        run(static_cast<std::uint64_t>(seed));
        if (IsSkipped() || HasFatalFailure())
            return;
    }
    int found = 0;
    int recognised = 0;
    int wrong = 0;
    int touches = 0;
    int estimates = 0;
    int covered = 0;
    std::vector<double> errors;
    for (const Outcome& outcome : m_outcomes) {
        found += outcome.found ? 1 : 0;
        recognised += outcome.recognised() ? 1 : 0;
        wrong += outcome.isWrong() ? 1 : 0;
        EXPECT_NEAR(outcome.logged_NPerM / outcome.ball.stiffness_NPerM, 1.0, 0.02);
        for (const json& touch : outcome.touches) {
            ++touches;
            if (!touch.contains("lower") || !touch["reliable"].get<bool>())
                continue;
            ++estimates;
            covered += covers(touch, outcome.ball.stiffness_NPerM) ? 1 : 0;
            if (touch.contains("value"))
                errors.push_back(std::abs(touch["value"].get<double>() / outcome.ball.stiffness_NPerM - 1.0));
        }
    }
    const int objects = static_cast<int>(m_outcomes.size());
    std::printf("objects %d: found %d, material right %d, wrong %d\n", objects, found, recognised, wrong);
    std::printf(
        "touches %d: with a reliable stiffness %d, whose 95 %% interval holds the truth %d (at least %d "
        "are asked for); error in the median %.1f %%, at most %.1f %%\n",
        touches, estimates, covered, leastCovered(estimates), 100.0 * median(errors),
        errors.empty() ? 0.0 : 100.0 * *std::ranges::max_element(errors));
    std::ranges::sort(m_latency_s);
    if (!m_latency_s.empty())
        std::printf(
            "touch to bracelet, %zu touches: median %.1f ms, 99 %% %.1f ms, longest %.1f ms, each +- %.1f "
            "ms; the clocks are one, and the offset was off by %.2f ms at most; target at 99 %%: %.0f ms\n",
            m_latency_s.size(), 1e3 * median(m_latency_s), 1e3 * core::quantileOf(m_latency_s, 0.99),
            1e3 * m_latency_s.back(), 1e3 * m_bound_s, 1e3 * m_clockError_s, 1e3 * kTarget_s);
    std::printf(
        "joint samples lost on the link: %llu; presses %llu; at rest %zu times, moved by %.1e rad at most; "
        "touches that the pad did not feel: %d\n",
        static_cast<unsigned long long>(m_lost), static_cast<unsigned long long>(m_presses), m_rests,
        m_movedAtRest_rad, m_notLocated);
    std::printf("on the link, 4 joints at 1 kHz and the pad at 200 Hz, encrypted: %.2f Mbit/s from the site, "
                "%.2f Mbit/s from the console\n",
                1e-6 * median(m_fromSite_bitPerS), 1e-6 * median(m_fromConsole_bitPerS));
    EXPECT_EQ(found, objects);
    // A touch may tell nothing, but what is told is right.
    EXPECT_GE(2 * recognised, objects);
    EXPECT_LE(20 * wrong, objects);
    EXPECT_GE(covered, leastCovered(estimates));
    // Others were told as not reliable, or refused.
    EXPECT_GE(2 * estimates, touches);
    EXPECT_GT(m_rests, 0U);
    EXPECT_LT(m_movedAtRest_rad, 1e-3);
}

} // namespace
} // namespace teleta
