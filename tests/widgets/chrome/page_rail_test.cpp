// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/page_rail.h"

#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

using teleta::base::Icon;
using teleta::chrome::PageRail;

/// The rail of pages.
class PageRailTest : public QObject {
    Q_OBJECT

    PageRail* m_rail = nullptr;

private slots:
    void init() {
        m_rail = new PageRail;
        m_rail->addPage("operate", Icon::operate, "Operate", "What the arm touches");
        m_rail->addPage("patterns", Icon::patterns, "Patterns", "What the bracelet plays");
        m_rail->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_rail));
    }
    void cleanup() { delete m_rail; }

    void startsWithTheFirstPage() { QCOMPARE(m_rail->currentPage(), QString("operate")); }

    void isAsWideAsItsLongestTitle() {
        const int usual = m_rail->width();
        const QString title = QStringLiteral("Calibration of everything");
        m_rail->setTitle("patterns", title, "What the bracelet plays");
        QVERIFY(m_rail->width() > m_rail->fontMetrics().horizontalAdvance(title));
        m_rail->setTitle("patterns", "Patterns", "What the bracelet plays");
        QCOMPARE(m_rail->width(), usual);
    }

    void inASmallWindowItHasIconsWhoseToolTipsNameThePages() {
        const int usual = m_rail->width();
        m_rail->setIconsOnly(true);
        QVERIFY(m_rail->width() < usual);
        auto* button = m_rail->findChildren<QToolButton*>().at(1);
        QVERIFY(button->text().isEmpty());
        QVERIFY(button->toolTip().startsWith("Patterns\nWhat the bracelet plays"));
        QCOMPARE(button->accessibleName(), QStringLiteral("Patterns"));
        QSignalSpy requests(m_rail, &PageRail::pageRequested);
        QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(requests.size(), 1);
        m_rail->setIconsOnly(false);
        QCOMPARE(m_rail->width(), usual);
        QCOMPARE(button->text(), QStringLiteral("Patterns"));
    }

    void asksForThePageThatIsClicked() {
        QSignalSpy requests(m_rail, &PageRail::pageRequested);
        QTest::mouseClick(m_rail->findChildren<QToolButton*>().at(1), Qt::LeftButton);
        QCOMPARE(requests.size(), 1);
        QCOMPARE(requests[0][0].toString(), QString("patterns"));
        QCOMPARE(m_rail->currentPage(), QString("patterns"));
    }

    void asksForThePageOfAShortcut() {
        QSignalSpy requests(m_rail, &PageRail::pageRequested);
        QTest::keyClick(m_rail, Qt::Key_2, Qt::ControlModifier);
        QCOMPARE(requests.size(), 1);
        QCOMPARE(requests[0][0].toString(), QString("patterns"));
    }

    void showsAPageWithoutAskingForIt() {
        QSignalSpy requests(m_rail, &PageRail::pageRequested);
        m_rail->setCurrentPage("patterns");
        QCOMPARE(m_rail->currentPage(), QString("patterns"));
        m_rail->setCurrentPage("nowhere");
        QCOMPARE(m_rail->currentPage(), QString("patterns"));
        QCOMPARE(requests.size(), 0);
    }

    void namesItsPagesForAssistiveToolsAndToolTips() {
        for (const auto* button : m_rail->findChildren<QToolButton*>()) {
            QVERIFY(!button->accessibleName().isEmpty());
            QVERIFY(button->toolTip().contains("Ctrl+"));
        }
    }
};

QTEST_MAIN(PageRailTest)
#include "page_rail_test.moc"
