// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/running/participant_placement.h"

#include <QApplication>
#include <QFile>
#include <QScreen>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QWidget>

using namespace teleta;
using console::ParticipantPlacement;
using console::participantScreen;
using console::placeBeside;

/// With two screens of Qt's offscreen platform. Unplugging one is simulated by Qt's signal.
class ParticipantPlacementTest : public QObject {
    Q_OBJECT

    QWidget m_console;
    QWidget m_controls{&m_console};
    QWidget m_participant;

private slots:
    void init() {
        QCOMPARE(QGuiApplication::screens().size(), 2);
        m_console.setGeometry(100, 100, 400, 300);
        m_console.show();
        QCOMPARE(m_console.screen(), QGuiApplication::screens()[0]);
        m_participant.hide();
    }

    void choosesAnotherScreenThanTheConsoles() {
        const QRect left(0, 0, 1280, 800);
        const QRect right(1280, 0, 1024, 768);
        const QRect below(0, 800, 1280, 800);
        QCOMPARE(participantScreen({left}, 0), -1);
        QCOMPARE(participantScreen({}, -1), -1);
        QCOMPARE(participantScreen({left, right}, 0), 1);
        QCOMPARE(participantScreen({left, right}, 1), 0);
        QCOMPARE(participantScreen({left, right, below}, 0), 1);
        QCOMPARE(participantScreen({left, below}, 0), 1);
        QCOMPARE(participantScreen({left, left}, 0), -1); // mirrored
    }

    void thePlaceBesideIsTheLargestOne() {
        const QRect room(0, 0, 1280, 800);
        const QSize wanted(640, 500);
        const QSize least(300, 400);
        const QRect right = placeBeside(room, QRect(100, 0, 600, 800), wanted, least);
        QCOMPARE(right.size(), QSize(580, 500));
        QVERIFY(room.contains(right) && right.left() >= 700);
        const QRect left = placeBeside(room, QRect(900, 100, 600, 800), wanted, least);
        QCOMPARE(left.size(), wanted);
        QVERIFY(room.contains(left) && left.right() < 900);
        const QRect below = placeBeside(room, QRect(0, 0, 1280, 390), wanted, least);
        QCOMPARE(below.size(), QSize(640, 410));
        QVERIFY(room.contains(below) && below.top() >= 390);
        QVERIFY(placeBeside(room, QRect(200, 0, 900, 800), wanted, least).isNull());
        QVERIFY(placeBeside(room, room, wanted, least).isNull());
    }

    void fillsTheSecondScreen() {
        ParticipantPlacement placement(m_participant, m_console, m_controls);
        placement.show();
        QVERIFY(m_participant.isFullScreen());
        QCOMPARE(m_participant.screen(), QGuiApplication::screens()[1]);
        QCOMPARE(m_participant.geometry(), QGuiApplication::screens()[1]->geometry());
    }

    void comesBackBesideTheConsoleWhenItsScreenIsLost() {
        ParticipantPlacement placement(m_participant, m_console, m_controls);
        QSignalSpy lost(&placement, &ParticipantPlacement::screenLost);
        placement.show();
        emit qGuiApp->screenRemoved(QGuiApplication::screens()[0]);
        QCOMPARE(lost.count(), 0);
        QVERIFY(m_participant.isFullScreen());
        emit qGuiApp->screenRemoved(QGuiApplication::screens()[1]);
        QCOMPARE(lost.count(), 1);
        QVERIFY(m_participant.isVisible());
        QVERIFY(!m_participant.isFullScreen());
        QVERIFY(m_console.screen()->geometry().contains(m_participant.geometry()));
        QVERIFY(!m_console.frameGeometry().intersects(m_participant.frameGeometry()));
        emit qGuiApp->screenRemoved(QGuiApplication::screens()[1]);
        QCOMPARE(lost.count(), 1);
        placement.show();
        QVERIFY2(m_participant.isFullScreen(), "the screen is there again");
    }

    void aWindowThatIsNotShownStaysHidden() {
        ParticipantPlacement placement(m_participant, m_console, m_controls);
        QSignalSpy lost(&placement, &ParticipantPlacement::screenLost);
        placement.show();
        m_participant.hide();
        emit qGuiApp->screenRemoved(QGuiApplication::screens()[1]);
        QVERIFY(!m_participant.isVisible());
        QCOMPARE(lost.count(), 0);
    }
};

int main(int argumentCount, char* arguments[]) {
    const QTemporaryDir folder;
    QFile screens(folder.filePath(QStringLiteral("screens.json")));
    if (!screens.open(QIODevice::WriteOnly))
        return 1;
    screens.write(R"({"screens":[{"name":"one","x":0,"y":0,"width":1280,"height":800,"logicalDpi":96,"dpr":1},
        {"name":"two","x":1280,"y":0,"width":1024,"height":768,"logicalDpi":96,"dpr":1}]})");
    screens.close();
    qputenv("QT_QPA_PLATFORM", "offscreen:configfile=" + QFile::encodeName(screens.fileName()));
    QApplication application(argumentCount, arguments);
    ParticipantPlacementTest test;
    return QTest::qExec(&test, argumentCount, arguments);
}
#include "participant_placement_test.moc"
