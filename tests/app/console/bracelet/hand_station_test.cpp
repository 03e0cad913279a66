// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/hand_station.h"
#include "backend/core/steady_time.h"

#include <QTest>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>

using namespace teleta;
using console::HandStation;
using hid::HidDevice;

namespace {

using Report = std::vector<std::uint8_t>;
const Report kReleased{0x03, 0x00, 0x00};
const Report kPressed{0x03, 0x01, 0x00};
const Report kRight{0x01, 0x5E, 0x01, 0x00, 0x00, 0x00, 0x00};

/// A mouse that a test plugs in and moves. Thread: any.
struct PlayedMouse {
    std::mutex mutex;
    std::condition_variable changed;
    std::deque<Report> reports;
    bool plugged = false;

    void plug(bool now) {
        const std::scoped_lock lock(mutex);
        plugged = now;
        reports.clear();
        changed.notify_all();
    }
    void send(const std::vector<Report>& more) {
        const std::scoped_lock lock(mutex);
        reports.insert(reports.end(), more.begin(), more.end());
        changed.notify_all();
    }

    class Input : public HidDevice {
    public:
        explicit Input(PlayedMouse& mouse)
            : m_mouse(mouse) {}
        [[nodiscard]] int read(std::span<std::uint8_t> report, int timeout_ms) override {
            std::unique_lock lock(m_mouse.mutex);
            m_mouse.changed.wait_for(lock, std::chrono::milliseconds(timeout_ms),
                                     [this] { return !m_mouse.plugged || !m_mouse.reports.empty(); });
            if (!m_mouse.plugged)
                return -1;
            if (m_mouse.reports.empty())
                return 0;
            const Report next = m_mouse.reports.front();
            m_mouse.reports.pop_front();
            std::copy(next.begin(), next.end(), report.begin());
            return static_cast<int>(next.size());
        }
        [[nodiscard]] std::string name() const override { return "played mouse"; }

    private:
        PlayedMouse& m_mouse;
    };

    mouse3d::HidInputOpener opener() {
        return [this]() -> core::Expected<std::unique_ptr<HidDevice>> {
            const std::scoped_lock lock(mutex);
            if (!plugged)
                return core::Unexpected(core::Error{core::ErrorKind::unavailable, "none", {}, {}});
            return std::make_unique<Input>(*this);
        };
    }
};

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
        PlayedMouse mouse;
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
        PlayedMouse mouse;
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
