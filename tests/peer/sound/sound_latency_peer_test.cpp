// SPDX-License-Identifier: GPL-3.0-or-later
// teleta devices --latency against PipeWire: what is played on a sink that nobody hears comes back at its
// monitor, directly and through a line that is known to delay it. Runs in with_sound_session.sh.
#include "tests/backend/core/temporary_folder.h"
#include "tests/peer/sound/sample_delay.h"
#include "tests/peer/sound/sound_server.h"

#include <QProcess>
#include <QStringList>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <limits>
#include <memory>
#include <string>

namespace teleta::peer {
namespace {

constexpr std::uint32_t kPeriod = 128;
constexpr double kRate_Hz = 48'000.0;

class SoundLatencyPeer : public testing::Test {
protected:
    static void SetUpTestSuite() {
        s_server = std::make_unique<SoundServer>();
        ASSERT_TRUE(s_server->start());
    }
    static void TearDownTestSuite() { s_server.reset(); }

    /// What the program prints about this input, and how it ends.
    struct Run {
        int code = -1;
        nlohmann::json device;
        std::string errors;
        /// NaN where it tells none.
        [[nodiscard]] double value(const std::string& name) const {
            for (const nlohmann::json& each : device["values"])
                if (each["name"] == name)
                    return each["value"];
            return std::numeric_limits<double>::quiet_NaN();
        }
    };
    Run measure(const std::string& input, const std::string& more = {}) {
        const std::string path = m_folder.write(
            "coils.toml", "kind = 'sound_bracelet'\nname = 'coils'\ndevice = 'pipewire:tactors'\n"
                          "channels = [1, 2, 3, 4, 5, 6]\n" +
                              more);
        QProcess teleta;
        QStringList arguments{QStringLiteral("devices"), QStringLiteral("--probe"),
                              QString::fromStdString(path), QStringLiteral("--json")};
        if (!input.empty())
            arguments << QStringLiteral("--latency") << QString::fromStdString(input);
        teleta.start(QStringLiteral(TELETA_PROGRAM), arguments);
        EXPECT_TRUE(teleta.waitForFinished(60'000));
        const auto printed =
            nlohmann::json::parse(teleta.readAllStandardOutput().toStdString(), nullptr, false);
        Run run{teleta.exitCode(), {}, teleta.readAllStandardError().toStdString()};
        if (printed.contains("devices"))
            run.device = printed["devices"][0];
        return run;
    }
    /// The same until all clicks were heard: a busy machine may miss too many periods.
    Run heard(const std::string& input) {
        Run run;
        for (int attempt = 0; attempt < 3 && run.code != 0; ++attempt)
            run = measure(input);
        EXPECT_EQ(run.code, 0) << run.errors;
        return run;
    }

    static std::unique_ptr<SoundServer> s_server;
    test::TemporaryFolder m_folder;
};
std::unique_ptr<SoundServer> SoundLatencyPeer::s_server;

TEST_F(SoundLatencyPeer, aLineThatDelaysBySoMuchAddsSoMuch) {
    constexpr std::size_t kDelay = 9600; // samples: 200 ms
    const Run direct = heard("tactors:monitor_AUX0");
    ASSERT_EQ(direct.code, 0);
    EXPECT_GT(direct.value("latency"), 0.0);
    EXPECT_GE(direct.value("latency_spread"), 0.0);
    SampleDelay line(kDelay);
    ASSERT_TRUE(line.start(sound::pipeWireLibraries().front(), "tactors:monitor_AUX0", kPeriod));
    const Run delayed = heard("delay:out");
    ASSERT_EQ(delayed.code, 0);
    const double added_s = delayed.value("latency") - direct.value("latency");
    EXPECT_NEAR(added_s, kDelay / kRate_Hz, 0.1 * kDelay / kRate_Hz);
    std::printf("direct %.2f ms, spread %.2f ms; the line of 200 ms adds %.2f ms\n",
                1e3 * direct.value("latency"), 1e3 * direct.value("latency_spread"), 1e3 * added_s);
}

TEST_F(SoundLatencyPeer, anInputAtWhichNothingIsHeardIsRefusedWithItsNoise) {
    const Run silent = measure("tactors:monitor_AUX5"); // of tactor 6
    EXPECT_NE(silent.code, 0);
    EXPECT_NE(silent.errors.find("only 0 of 10 clicks"), std::string::npos) << silent.errors;
    const Run missing = measure("tactors:nothing");
    EXPECT_NE(missing.code, 0);
    EXPECT_NE(missing.errors.find("tactors:monitor_AUX0"), std::string::npos) << missing.errors;
}

TEST_F(SoundLatencyPeer, whatTheFileHasOfItIsToldAsMeasured) {
    const Run run = measure({}, "latency_ms = 7.5\nlatency_spread_ms = 1.25\n");
    ASSERT_EQ(run.code, 0) << run.errors;
    EXPECT_DOUBLE_EQ(run.value("measured_latency"), 0.0075);
    EXPECT_DOUBLE_EQ(run.value("measured_latency_spread"), 0.00125);
    EXPECT_GT(run.value("stated_latency"), 0.0);
}

} // namespace
} // namespace teleta::peer
