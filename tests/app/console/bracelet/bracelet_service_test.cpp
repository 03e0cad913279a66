// SPDX-License-Identifier: GPL-3.0-or-later
// A Modbus bracelet in the console, against a server that somebody else wrote (python3-pymodbus).
#include "app/console/base/console_settings.h"
#include "app/console/bracelet/bracelet_menu.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/playback/pattern_program.h"
#include "tests/app/console/bracelet/patient_bracelet.h"
#include "tests/support/peer_process.h"

#include <QAction>
#include <QFile>
#include <QMenu>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QWidget>

#include <memory>

using namespace teleta;
using console::BraceletChoice;
using console::BraceletMenu;
using console::BraceletService;
using console::ConsoleSettings;
using core::DeviceState;

class BraceletServiceTest : public QObject {
    Q_OBJECT

    core::StopSwitch m_stop;
    std::unique_ptr<BraceletService> m_station;
    test::PeerProcess m_server;
    QTemporaryDir m_folder;
    QTimer m_clock;

    QString deviceFile(const QString& port) {
        const QString path = m_folder.filePath(QStringLiteral("driver.toml"));
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly))
            qFatal("cannot write the device file");
        file.write("kind = 'modbus'\nname = 'Driver'\n[link]\nkind = 'tcp'\nhost = '127.0.0.1'\nport = " +
                   port.toUtf8() +
                   "\n[tactors]\naddress = 10\ntype = 'uint16'\nunit = '1'\nfull = 4095\n[watchdog]\naddress "
                   "= 20\n");
        return path;
    }
    QString serve(const QString& port = QStringLiteral("0")) {
        m_server.start(
            QStringLiteral("/usr/bin/python3"),
            {QStringLiteral(TELETA_SOURCE_DIR "/tests/peer/modbus_server.py"), QStringLiteral("tcp"), port});
        const auto ready = m_server.waitFor("ready ");
        return ready ? QString::fromStdString(ready->substr(6)) : QString();
    }
    [[nodiscard]] DeviceState state() const {
        const auto reading = m_station->reading();
        return reading ? reading->state : DeviceState::closed;
    }

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        if (!test::runs(QStringLiteral("/usr/bin/python3"),
                        {QStringLiteral("-c"), QStringLiteral("import pymodbus.server.async_io")}))
            QSKIP("python3-pymodbus or python3-serial-asyncio is not installed");
    }
    void init() {
        m_stop.release();
        m_station = test::patientBracelet(m_stop);
        connect(&m_clock, &QTimer::timeout, m_station.get(), &BraceletService::tick);
        m_clock.start(10);
    }
    void cleanup() {
        m_clock.stop();
        m_station.reset();
        m_server.kill();
    }

    void showsAModbusBraceletLiveLostAndLiveAgain() {
        const QString port = serve();
        QVERIFY(!port.isEmpty());
        m_station->choose(BraceletChoice::file, deviceFile(port));
        QTRY_COMPARE_WITH_TIMEOUT(state(), DeviceState::live, 20'000);
        QVERIFY(m_station->isReady());
        QVERIFY(!m_station->isSimulated());
        m_server.kill();
        QTRY_VERIFY_WITH_TIMEOUT(state() == DeviceState::lost || state() == DeviceState::reconnecting,
                                 20'000);
        QVERIFY(!m_station->isReady());
        QVERIFY(!m_station->note().isEmpty());
        QVERIFY(!serve(port).isEmpty());
        QTRY_COMPARE_WITH_TIMEOUT(state(), DeviceState::live, 20'000);
    }

    void playsOnItAndStopZeroesItsMotors() {
        const QString port = serve();
        m_station->choose(BraceletChoice::file, deviceFile(port));
        QTRY_VERIFY_WITH_TIMEOUT(m_station->isReady(), 20'000);
        // On the playback thread alone: while the test waits for the server no tick comes.
        m_station->play(playback::programOf(*pattern::findBuiltIn("stiffness.E.static")), true);
        QVERIFY(m_server.waitFor("write 10 4095 4095 4095 4095 4095 4095"));
        m_stop.engage();
        QVERIFY(m_server.waitFor("write 10 0 0 0 0 0 0"));
    }

    void saysWhyADriverCannotBeOpened() {
        QSignalSpy failures(m_station.get(), &BraceletService::failed);
        m_station->choose(BraceletChoice::file, m_folder.filePath(QStringLiteral("none.toml")));
        QTRY_COMPARE_WITH_TIMEOUT(failures.size(), 1, 20'000);
        QCOMPARE(m_station->choice(), BraceletChoice::none);
        m_station->choose(BraceletChoice::file, deviceFile(QStringLiteral("9")));
        QTRY_COMPARE_WITH_TIMEOUT(failures.size(), 2, 20'000);
    }

    void aBraceletThatCannotBeOpenedDoesNotCostTheOneThatWorks() {
        QSignalSpy failures(m_station.get(), &BraceletService::failed);
        m_station->choose(BraceletChoice::simulated);
        QTRY_COMPARE_WITH_TIMEOUT(state(), DeviceState::live, 20'000);
        m_station->choose(BraceletChoice::file, m_folder.filePath(QStringLiteral("none.toml")));
        QTRY_COMPARE_WITH_TIMEOUT(failures.size(), 1, 20'000);
        QCOMPARE(m_station->choice(), BraceletChoice::simulated);
        QTRY_COMPARE_WITH_TIMEOUT(state(), DeviceState::live, 20'000);
        QVERIFY(m_station->play(playback::programOf(*pattern::findBuiltIn("stiffness.E.static")), false) !=
                0);
        // None that is chosen is none.
        m_station->choose(BraceletChoice::none);
        m_station->choose(BraceletChoice::file, m_folder.filePath(QStringLiteral("none.toml")));
        QTRY_COMPARE_WITH_TIMEOUT(failures.size(), 2, 20'000);
        QCOMPARE(m_station->choice(), BraceletChoice::none);
    }

    void theMenuRemembersDriversAndTheCommandLineNamesOne() {
        ConsoleSettings settings(true);
        QWidget window;
        BraceletMenu menu(*m_station, settings, &window);
        QMenu shown;
        menu.fill(shown);
        QStringList texts;
        for (const QAction* action : shown.actions())
            texts.append(action->text().remove(QLatin1Char('&')));
        QVERIFY(texts.contains(QStringLiteral("Device file\u2026")));
        menu.restore(QStringLiteral("none"));
        QCOMPARE(m_station->choice(), BraceletChoice::none);
        menu.restore({});
        QVERIFY2(m_station->choice() == BraceletChoice::simulated, "the default");
        menu.restore(m_folder.filePath(QStringLiteral("my.toml")));
        QCOMPARE(m_station->choice(), BraceletChoice::file);
        QCOMPARE(m_station->deviceFile(), m_folder.filePath(QStringLiteral("my.toml")));
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
        for (const char* kept : {"file:/kept.toml", "modbus:/kept.toml"}) {
            ConsoleSettings written(false);
            written.setBracelet(QLatin1String(kept));
            BraceletMenu again(*m_station, written, &window);
            again.restore(QStringLiteral("none"));
            again.restore({});
            QCOMPARE(m_station->choice(), BraceletChoice::file);
            QCOMPARE(m_station->deviceFile(), QStringLiteral("/kept.toml"));
        }
    }
};

QTEST_MAIN(BraceletServiceTest)
#include "bracelet_service_test.moc"
