// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/console/study/study_bench.h"
#include "widgets/chrome/message_bar.h"

#include <QApplication>
#include <QFile>
#include <QScreen>
#include <QWindow>

using namespace teleta;
using test::kPatience_ms;

/// The participant's window where it shares the only screen with the console.
class SingleScreenTest : public QObject, protected test::StudyBench {
    Q_OBJECT

    [[nodiscard]] static QRect room() { return QGuiApplication::primaryScreen()->availableGeometry(); }
    [[nodiscard]] QRect controls() {
        QWidget& panel = sessionPanel();
        return {panel.mapToGlobal(QPoint()), panel.size()};
    }

    void openStudyIn(const QRect& place) {
        openStudy();
        m_page->setGeometry(place);
        QTRY_COMPARE_WITH_TIMEOUT(m_page->geometry(), place, kPatience_ms);
    }

private slots:
    void init() {
        QCOMPARE(QGuiApplication::screens().size(), 1);
        setUp();
    }
    void cleanup() { tearDown(); }

    void standsBesideTheConsoleWhereThereIsRoom() {
        openStudyIn(QRect(0, 0, 960, 700));
        beginSession();
        QVERIFY(room().contains(window()->frameGeometry()));
        QVERIFY(!window()->frameGeometry().intersects(m_page->frameGeometry()));
        QCOMPARE(m_page->messages().count(), 0);
        doTrial();
        QTRY_COMPARE_WITH_TIMEOUT(kept().size(), std::size_t(1), kPatience_ms);
    }

    void leavesTheSessionsButtonsFreeWhereThereIsNone() {
        openStudyIn(room());
        beginSession();
        QVERIFY(room().contains(window()->frameGeometry()));
        QVERIFY(!window()->frameGeometry().intersects(controls()));
        QCOMPARE(m_page->messages().count(), 0);
        // Where the experimenter has put it, it stays.
        window()->move(window()->pos() + QPoint(0, 11));
        const QRect moved = window()->geometry();
        m_page->bringForward(QStringLiteral("participant"));
        QCOMPARE(window()->geometry(), moved);
    }

    // Above all others, also when the console is clicked.
    void staysAboveTheConsole() {
        openStudyIn(room());
        beginSession();
        QVERIFY(window()->windowHandle() != nullptr);
        QVERIFY(window()->windowHandle()->flags().testFlag(Qt::WindowStaysOnTopHint));
    }

    void saysThatItCoversAPart() {
        openStudyIn(room());
        window()->setMinimumSize(1000, 600);
        beginSession();
        QVERIFY(window()->isVisible());
        QCOMPARE(m_page->messages().count(), 1);
    }
};

int main(int argumentCount, char* arguments[]) {
    const QTemporaryDir folder;
    QFile screens(folder.filePath(QStringLiteral("screens.json")));
    if (!screens.open(QIODevice::WriteOnly))
        return 1;
    screens.write(
        R"({"screens":[{"name":"one","x":0,"y":0,"width":1366,"height":768,"logicalDpi":96,"dpr":1}]})");
    screens.close();
    qputenv("QT_QPA_PLATFORM", "offscreen:configfile=" + QFile::encodeName(screens.fileName()));
    QApplication application(argumentCount, arguments);
    SingleScreenTest test;
    return QTest::qExec(&test, argumentCount, arguments);
}
#include "study_single_screen_test.moc"
