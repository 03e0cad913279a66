// SPDX-License-Identifier: GPL-3.0-or-later
// The program itself, with a bracelet behind a Modbus server that somebody else wrote, while it records and
// runs a rehearsal.
#include "backend/recording/recording.h"
#include "tests/support/peer_process.h"

#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <string>
#include <sys/types.h>
#include <utility>
#include <vector>

using namespace teleta;
using test::PeerProcess;

namespace {

constexpr int kPatience_ms = 120'000;
const QString kPython = QStringLiteral("/usr/bin/python3");

bool isOff(const std::string& write) {
    return write == "write 10 0 0 0 0 0 0";
}

} // namespace

/// The console ends without anybody who could be asked.
class SuddenEndTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    PeerProcess m_driver;  ///< of the motors
    PeerProcess m_display; ///< when it is not the offscreen one
    QProcess m_program;
    int m_run = 0;

    [[nodiscard]] QString path(const char* name) const {
        return m_folder.filePath(QStringLiteral("%1-%2").arg(m_run).arg(QLatin1String(name)));
    }

    /// Starts the program and waits until it drives the motors and records.
    void start(const std::vector<std::pair<QString, QString>>& variables) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME"})
            environment.insert(QLatin1String(name), path(name));
        environment.remove(QStringLiteral("WAYLAND_DISPLAY"));
        environment.remove(QStringLiteral("DISPLAY"));
        for (const auto& [name, value] : variables)
            environment.insert(name, value);
        m_program.setProcessEnvironment(environment);
        m_program.start(QStringLiteral(TELETA_CONSOLE_PROGRAM),
                        {QStringLiteral("--scene"), QStringLiteral("teleta-touch"),
                         QStringLiteral("--bracelet"), m_folder.filePath(QStringLiteral("driver.toml")),
                         QStringLiteral("--record"), path("run.teleta")});
        QVERIFY(m_program.waitForStarted());
        QTRY_VERIFY_WITH_TIMEOUT(
            QFile::exists(path("run.teleta")) || m_program.state() == QProcess::NotRunning, kPatience_ms);
        QVERIFY2(m_program.state() == QProcess::Running, m_program.readAllStandardError().constData());
        QVERIFY(m_driver.command("sync"));
        (void)m_driver.takeLines();
        for (;;) {
            const auto write = m_driver.waitFor("write 10 ");
            QVERIFY(write);
            if (!isOff(*write))
                break;
        }
    }

    /// After the program has ended.
    void verifyAllIsAtRestAndComplete(int exitCode) {
        QVERIFY(m_program.waitForFinished(kPatience_ms));
        const QByteArray said = m_program.readAllStandardError();
        QVERIFY2(m_program.exitStatus() == QProcess::NormalExit, said.constData());
        QVERIFY2(m_program.exitCode() == exitCode, said.constData());

        QVERIFY(m_driver.command("sync"));
        std::string last;
        for (const std::string& line : m_driver.takeLines())
            if (line.starts_with("write 10 "))
                last = line;
        QVERIFY2(isOff(last), last.c_str());

        const auto recording = recording::Recording::open(path("run.teleta").toStdString());
        QVERIFY2(recording, recording ? "" : core::describe(recording.error()).c_str());
        QVERIFY2(recording->isComplete(), "the recording was not completed");
    }

    /// The number of a new X server; empty: there is none here.
    [[nodiscard]] QString startXServer() {
        if (QStandardPaths::findExecutable(QStringLiteral("Xvfb")).isEmpty())
            return {};
        m_display.start(QStringLiteral("Xvfb"),
                        {QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-screen"),
                         QStringLiteral("0"), QStringLiteral("1280x1024x24"), QStringLiteral("-nolisten"),
                         QStringLiteral("tcp")});
        return QString::fromStdString(m_display.waitFor("").value_or(std::string()));
    }

private slots:
    void initTestCase() {
        if (!test::runs(kPython, {QStringLiteral("-c"), QStringLiteral("import pymodbus.server.async_io")}))
            QSKIP("python3-pymodbus or python3-serial-asyncio is not installed");
        m_driver.start(kPython, {QStringLiteral(TELETA_SOURCE_DIR "/tests/peer/modbus_server.py"),
                                 QStringLiteral("tcp"), QStringLiteral("0")});
        const auto ready = m_driver.waitFor("ready ");
        QVERIFY2(ready, m_driver.errors().c_str());
        QFile file(m_folder.filePath(QStringLiteral("driver.toml")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(
            ("kind = 'modbus'\nname = 'driver'\n[link]\nkind = 'tcp'\nhost = '127.0.0.1'\nport = " +
             ready->substr(6) +
             "\n[tactors]\naddress = 10\ntype = 'uint16'\nunit = '1'\nfull = 100\n[watchdog]\naddress = 20\n")
                .c_str());
    }
    void init() { ++m_run; }
    void cleanup() {
        if (m_program.state() != QProcess::NotRunning) {
            m_program.kill();
            m_program.waitForFinished();
        }
        m_display.kill();
    }

    void signal_data() {
        QTest::addColumn<int>("number");
        QTest::newRow("TERM") << SIGTERM;
        QTest::newRow("INT") << SIGINT;
        QTest::newRow("HUP") << SIGHUP;
    }
    void signal() {
        QFETCH(int, number);
        start({{QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen")}});
        if (QTest::currentTestFailed())
            return;
        ::kill(static_cast<pid_t>(m_program.processId()), number);
        verifyAllIsAtRestAndComplete(0);
    }

    void aStoppedProgramStopsTheMotorsFirstWhenItGoesOn() {
        start({{QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen")}});
        if (QTest::currentTestFailed())
            return;
        const auto process = static_cast<pid_t>(m_program.processId());
        ::kill(process, SIGSTOP);
        ::kill(process, SIGTERM);
        ::kill(process, SIGHUP);
        ::kill(process, SIGCONT);
        verifyAllIsAtRestAndComplete(0);
    }

    void theXServerDies() {
        const QString number = startXServer();
        if (number.isEmpty())
            QSKIP("Xvfb is not installed");
        start({{QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("xcb")},
               {QStringLiteral("DISPLAY"), QLatin1Char(':') + number}});
        if (QTest::currentTestFailed())
            return;
        m_display.kill();
        verifyAllIsAtRestAndComplete(EXIT_FAILURE);
    }

    void theWaylandCompositorDies() {
        const QString socket = QStringLiteral("teleta-test");
        const QTemporaryDir runtime; // has the mode that Wayland demands
        if (QStandardPaths::findExecutable(QStringLiteral("weston")).isEmpty())
            QSKIP("weston is not installed");
        qputenv("XDG_RUNTIME_DIR", runtime.path().toUtf8());
        m_display.start(QStringLiteral("weston"),
                        {QStringLiteral("--backend=headless-backend.so"),
                         QStringLiteral("--socket=") + socket, QStringLiteral("--idle-time=0")});
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(runtime.filePath(socket)), kPatience_ms);
        start({{QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("wayland")},
               {QStringLiteral("WAYLAND_DISPLAY"), socket},
               {QStringLiteral("XDG_RUNTIME_DIR"), runtime.path()}});
        if (QTest::currentTestFailed())
            return;
        m_display.kill();
        verifyAllIsAtRestAndComplete(EXIT_FAILURE);
    }

#ifdef TELETA_SESSION_MANAGER
    void theDesktopsSessionEnds() {
        const QString number = startXServer();
        if (number.isEmpty())
            QSKIP("Xvfb is not installed");
        PeerProcess manager;
        manager.start(QStringLiteral(TELETA_SESSION_MANAGER), {});
        const auto address = manager.waitFor("ready ");
        QVERIFY2(address, manager.errors().c_str());
        start({{QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("xcb")},
               {QStringLiteral("DISPLAY"), QLatin1Char(':') + number},
               {QStringLiteral("SESSION_MANAGER"), QString::fromStdString(address->substr(6))}});
        if (QTest::currentTestFailed())
            return;
        QVERIFY(manager.waitFor("joined"));
        manager.say("end");
        QVERIFY(manager.waitFor("saved"));
        verifyAllIsAtRestAndComplete(0);
        QVERIFY(manager.waitFor("gone"));
    }
#endif
};

QTEST_GUILESS_MAIN(SuddenEndTest)
#include "sudden_end_test.moc"
