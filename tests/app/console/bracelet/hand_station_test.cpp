// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/hand_station.h"
#include "backend/core/steady_time.h"
#include "tests/devices/mouse3d/played_mouse.h"

#include <QTest>

#include <atomic>

using namespace teleta;
using console::HandStation;
using test::kPressed;
using test::kReleased;
using test::kRight;
using test::PlayedMouse;

namespace {

constexpr std::int64_t kPatience_ns = 60'000'000'000;

/// Looks for a mouse without long pauses, and forgets no deflection while the test looks at it.
mouse3d::Mouse3dConfig quick() {
    return {.axesLifetime_ns = kPatience_ns,
            .restLifetime_ns = kPatience_ns,
            .firstRetry_ns = 1'000'000,
            .longestRetry_ns = 10'000'000};
}

/// The real clock, which a test puts forward.
class SkippingClock : public core::PacingClock {
public:
    [[nodiscard]] std::int64_t now_ns() const override { return core::steadyNow_ns() + m_skipped_ns.load(); }
    void skip(std::int64_t duration_ns) { m_skipped_ns += duration_ns; }

private:
    std::atomic<std::int64_t> m_skipped_ns{0};
};

} // namespace

/// The 3D mouse of the console, which comes and goes.
class HandStationTest : public QObject {
    Q_OBJECT

private slots:
    void tellsOfAMouseThatIsPluggedInLaterAndUnpluggedWhileItMoves() {
        PlayedMouse mouse(false);
        HandStation station(quick(), mouse.opener());
        QVERIFY(!station.motion().has_value());
        QVERIFY2(!station.reading().has_value(), "none was ever there");
        QVERIFY(station.text().contains(QLatin1String("none is plugged in")));

        mouse.plug(true);
        QTRY_VERIFY(station.motion().has_value());
        QCOMPARE(station.reading()->state, core::DeviceState::live);
        QVERIFY(station.text().contains(QLatin1String("played mouse")));
        QVERIFY(!station.motion()->deadManHeld);

        mouse.send({kReleased, kPressed, kRight});
        QTRY_VERIFY(station.motion()->deadManHeld && station.motion()->velocity[0] == 1.0);
        mouse.plug(false);
        QTRY_VERIFY(!station.motion().has_value());
        QTRY_VERIFY(station.reading()->state == core::DeviceState::lost ||
                    station.reading()->state == core::DeviceState::reconnecting);

        mouse.plug(true);
        QTRY_VERIFY(station.motion().has_value());
        QVERIFY2(!station.motion()->deadManHeld, "the button has to be pressed anew");
        QCOMPARE(station.motion()->velocity[0], 0.0);
    }

    void aDeflectedHandThatFallsSilentLetsGoInTheSameLook() {
        PlayedMouse mouse(false);
        mouse.plug(true);
        mouse3d::Mouse3dConfig config = quick();
        const auto clock = std::make_shared<SkippingClock>();
        config.clock = clock;
        HandStation station(config, mouse.opener());
        QTRY_VERIFY(station.motion().has_value());
        mouse.send({kReleased, kPressed, kRight});
        QTRY_VERIFY(station.motion()->deadManHeld && station.motion()->velocity[0] == 1.0);
        clock->skip(2 * kPatience_ns);
        const auto silent = station.motion();
        QVERIFY2(!silent->deadManHeld, "it would be held at rest, and lead the tip back");
        QCOMPARE(silent->velocity[0], 0.0);
        mouse.send({kRight, kReleased, kPressed, kRight});
        QTRY_VERIFY(station.motion()->deadManHeld && station.motion()->velocity[0] == 1.0);
    }
};

QTEST_MAIN(HandStationTest)
#include "hand_station_test.moc"
