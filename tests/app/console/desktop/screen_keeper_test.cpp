// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/desktop/screen_keeper.h"

#include <QCoreApplication>
#include <QDBusArgument>
#include <QDBusConnection>
#include <QDBusConnectionInterface>
#include <QDBusInterface>
#include <QDBusReply>
#include <QProcess>
#include <QSignalSpy>
#include <QTest>

#include <memory>
#include <unistd.h>
#include <vector>

using teleta::console::ScreenKeeper;

namespace {

constexpr int kPatience_ms = 20'000;
constexpr char kSaver[] = "org.freedesktop.ScreenSaver";
constexpr char kPortal[] = "org.freedesktop.portal.Desktop";
constexpr char kPortalPath[] = "/org/freedesktop/portal/desktop";

/// A service of python3-dbusmock on the session bus.
class MockedService {
public:
    MockedService(const QString& name, const QString& path, const QString& interface)
        : m_name(name)
        , m_path(path)
        , m_interface(interface) {
        m_process.start(QStringLiteral("/usr/bin/python3"),
                        {"-m", "dbusmock", "--session", name, path, interface});
    }
    ~MockedService() { end(); }

    [[nodiscard]] bool answers() const {
        return QDBusConnection::sessionBus().interface()->isServiceRegistered(m_name).value();
    }
    void addMethod(const QString& name, const QString& in, const QString& out, const QString& code) {
        QDBusInterface mock(m_name, m_path, QStringLiteral("org.freedesktop.DBus.Mock"));
        const QDBusMessage done = mock.call(QStringLiteral("AddMethod"), m_interface, name, in, out, code);
        QVERIFY2(done.type() == QDBusMessage::ReplyMessage, qPrintable(done.errorMessage()));
    }
    /// "Method argument argument" of each call, but those of the mock itself.
    [[nodiscard]] QStringList calls() const {
        QDBusInterface mock(m_name, m_path, QStringLiteral("org.freedesktop.DBus.Mock"));
        const QDBusMessage answer = mock.call(QStringLiteral("GetCalls"));
        QStringList calls;
        const auto list = answer.arguments().value(0).value<QDBusArgument>();
        list.beginArray();
        while (!list.atEnd()) {
            qulonglong time = 0;
            QString method;
            QVariantList arguments;
            list.beginStructure();
            list >> time >> method >> arguments;
            list.endStructure();
            QStringList words{method};
            for (const QVariant& argument : arguments)
                words << (argument.canConvert<QString>() ? argument.toString() : QStringLiteral("{}"));
            calls << words.join(QLatin1Char(' '));
        }
        list.endArray();
        return calls;
    }
    void end() {
        m_process.kill();
        m_process.waitForFinished();
    }

private:
    QString m_name;
    QString m_path;
    QString m_interface;
    QProcess m_process;
};

} // namespace

/// Against services of python3-dbusmock; runs on a session bus of its own.
class ScreenKeeperTest : public QObject {
    Q_OBJECT

    static std::unique_ptr<MockedService> screenSaver() {
        auto saver = std::make_unique<MockedService>(kSaver, "/org/freedesktop/ScreenSaver", kSaver);
        if (!QTest::qWaitFor([&] { return saver->answers(); }, kPatience_ms))
            qFatal("dbusmock does not start");
        saver->addMethod("Inhibit", "ss", "u", "ret = 4711");
        saver->addMethod("UnInhibit", "u", "", "");
        return saver;
    }

private slots:
    void initTestCase() {
        QCoreApplication::setApplicationName(QStringLiteral("teleta-console"));
        if (!QDBusConnection::sessionBus().isConnected())
            QSKIP("there is no session bus, and no dbus-run-session");
        QProcess python;
        python.start(QStringLiteral("/usr/bin/python3"), {"-c", "import dbusmock"});
        python.waitForFinished();
        if (python.exitCode() != 0)
            QSKIP("python3-dbusmock is not installed");
    }

    void asksOnceWhileItIsWantedAndGivesTheCookieBack() {
        const auto saver = screenSaver();
        ScreenKeeper keeper(ScreenKeeper::Service::screenSaver);
        QSignalSpy failed(&keeper, &ScreenKeeper::failed);
        QCOMPARE(keeper.state(), ScreenKeeper::State::idle);
        for (int tick = 0; tick < 3; ++tick)
            keeper.setWanted(true, "a session is running");
        QTRY_COMPARE_WITH_TIMEOUT(keeper.state(), ScreenKeeper::State::held, kPatience_ms);
        QCOMPARE(saver->calls(), QStringList{"Inhibit teleta-console a session is running"});
        keeper.setWanted(false, {});
        QCOMPARE(keeper.state(), ScreenKeeper::State::idle);
        QTRY_COMPARE_WITH_TIMEOUT(
            saver->calls(), (QStringList{"Inhibit teleta-console a session is running", "UnInhibit 4711"}),
            kPatience_ms);
        QCOMPARE(failed.count(), 0);
    }

    void anAnswerThatComesTooLateIsGivenBack() {
        const auto saver = screenSaver();
        ScreenKeeper keeper(ScreenKeeper::Service::screenSaver);
        keeper.setWanted(true, "first");
        keeper.setWanted(false, {});
        keeper.setWanted(true, "second");
        QTRY_COMPARE_WITH_TIMEOUT(keeper.state(), ScreenKeeper::State::held, kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(saver->calls().filter("UnInhibit").size(), 1, kPatience_ms);
        QCOMPARE(saver->calls().filter("Inhibit teleta").size(), 2);
    }

    void itsEndGivesTheCookieBack() {
        const auto saver = screenSaver();
        {
            ScreenKeeper keeper(ScreenKeeper::Service::screenSaver);
            keeper.setWanted(true, "recording");
            QTRY_COMPARE_WITH_TIMEOUT(keeper.state(), ScreenKeeper::State::held, kPatience_ms);
        }
        QTRY_COMPARE_WITH_TIMEOUT(saver->calls().value(1), QString("UnInhibit 4711"), kPatience_ms);
    }

    void aServiceThatGoesAwayIsToldOnce() {
        const auto saver = screenSaver();
        ScreenKeeper keeper(ScreenKeeper::Service::screenSaver);
        QSignalSpy failed(&keeper, &ScreenKeeper::failed);
        keeper.setWanted(true, "recording");
        QTRY_COMPARE_WITH_TIMEOUT(keeper.state(), ScreenKeeper::State::held, kPatience_ms);
        saver->end();
        QTRY_COMPARE_WITH_TIMEOUT(keeper.state(), ScreenKeeper::State::unavailable, kPatience_ms);
        keeper.setWanted(false, {});
        keeper.setWanted(true, "another recording");
        QTRY_COMPARE_WITH_TIMEOUT(keeper.state(), ScreenKeeper::State::unavailable, kPatience_ms);
        QCOMPARE(failed.count(), 1);
    }

    void withoutAServiceItSaysSoOnce() {
        ScreenKeeper keeper(ScreenKeeper::Service::screenSaver);
        QSignalSpy failed(&keeper, &ScreenKeeper::failed);
        keeper.setWanted(true, "recording");
        QTRY_COMPARE_WITH_TIMEOUT(keeper.state(), ScreenKeeper::State::unavailable, kPatience_ms);
        QCOMPARE(failed.count(), 1);
        QVERIFY(!failed.front().front().toString().isEmpty());
        keeper.setWanted(false, {});
        QCOMPARE(keeper.state(), ScreenKeeper::State::idle);
    }

    void inAFlatpakThePortalIsAskedAndItsRequestClosed() {
        MockedService portal(kPortal, kPortalPath, "org.freedesktop.portal.Inhibit");
        QTRY_VERIFY_WITH_TIMEOUT(portal.answers(), kPatience_ms);
        portal.addMethod(
            "Inhibit", "sua{sv}", "o",
            "self.AddObject('/request/1', 'org.freedesktop.portal.Request', {}, [('Close', '', '', '')])\n"
            "ret = dbus.ObjectPath('/request/1')");
        ScreenKeeper keeper(ScreenKeeper::Service::portal);
        keeper.setWanted(true, "recording");
        QTRY_COMPARE_WITH_TIMEOUT(keeper.state(), ScreenKeeper::State::held, kPatience_ms);
        QVERIFY2(portal.calls().value(0).startsWith("Inhibit  8 "), qPrintable(portal.calls().join('\n')));
        keeper.setWanted(false, {});
        QDBusInterface request(kPortal, "/request/1", "org.freedesktop.DBus.Mock");
        QTRY_COMPARE_WITH_TIMEOUT(closed(request), 1, kPatience_ms);
    }

private:
    static int closed(QDBusInterface& request) {
        const auto calls =
            request.call("GetMethodCalls", "Close").arguments().value(0).value<QDBusArgument>();
        int count = 0;
        calls.beginArray();
        while (!calls.atEnd()) {
            qulonglong time = 0;
            QVariantList arguments;
            calls.beginStructure();
            calls >> time >> arguments;
            calls.endStructure();
            ++count;
        }
        calls.endArray();
        return count;
    }
};

int main(int argc, char** argv) {
    // A bus of its own, where it can be had.
    if (qEnvironmentVariableIsEmpty("TELETA_TEST_BUS")) {
        qputenv("TELETA_TEST_BUS", "1");
        std::vector<char*> words{const_cast<char*>("dbus-run-session"), const_cast<char*>("--")};
        words.insert(words.end(), argv, argv + argc);
        words.push_back(nullptr);
        execvp(words.front(), words.data());
    }
    QCoreApplication application(argc, argv);
    ScreenKeeperTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "screen_keeper_test.moc"
