// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/start/demo_card.h"
#include "widgets/chrome/start/demo_list.h"

#include <QLabel>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>

#include <set>

using teleta::chrome::DemoCard;
using teleta::chrome::DemoList;

namespace {

std::vector<teleta::chrome::SourceChooser::Demo> demos() {
    return {{":/a", "First", "about it", "One"},
            {":/b", "Second", "about it", "One"},
            {":/c", "Third", "about it", "Two"},
            {":/d", "Fourth", "about it", "Three"}};
}

/// The different left edges of the cards.
int columnsOf(const DemoList& list) {
    std::set<int> edges;
    for (const DemoCard* card : list.findChildren<DemoCard*>())
        edges.insert(card->mapTo(&list, QPoint()).x());
    return static_cast<int>(edges.size());
}

} // namespace

/// Demos on the start page.
class DemoListTest : public QObject {
    Q_OBJECT

private slots:
    void groupsStandInAsManyColumnsAsThereIsRoomFor() {
        DemoList list;
        list.setDemos(demos());
        list.resize(list.sizeHint().width() + 40, 400);
        list.show();
        QCOMPARE(list.findChildren<DemoCard*>().size(), 4);
        QTRY_COMPARE(columnsOf(list), 3);
        // A group is not torn apart: its second card is below its first one.
        const auto cards = list.findChildren<DemoCard*>();
        QCOMPARE(cards[0]->mapTo(&list, QPoint()).x(), cards[1]->mapTo(&list, QPoint()).x());
        QVERIFY(cards[0]->mapTo(&list, QPoint()).y() < cards[1]->mapTo(&list, QPoint()).y());
        list.resize(list.sizeHint().width() / 3 + 10, 400);
        QTRY_COMPARE(columnsOf(list), 1);
        QStringList headings;
        for (const QLabel* label : list.findChildren<QLabel*>())
            headings << label->text();
        QCOMPARE(headings, QStringList({"One", "Two", "Three"}));
    }

    void cardsAreSmallWhereLargeOnesDoNotFitAndLargeAgainLater() {
        DemoList list;
        list.setDemos(demos());
        list.resize(900, 1000);
        list.show();
        QVERIFY(QTest::qWaitForWindowExposed(&list));
        const DemoCard* card = list.findChildren<DemoCard*>().front();
        const int large = card->height();
        QCOMPARE(large, DemoCard::heightOf(list, DemoCard::Size::large));
        const int needed = list.sizeHint().height();
        list.resize(900, needed - 10);
        QTRY_COMPARE(card->height(), DemoCard::heightOf(list, DemoCard::Size::small));
        QVERIFY(card->height() < large);
        QTRY_VERIFY2(!list.verticalScrollBar()->isVisible(), "they fit");
        QVERIFY2(card->toolTip().contains("First") && card->toolTip().contains("about it"),
                 "what is cut is in the tool tip");
        QCOMPARE(list.sizeHint().height(), needed); // it would like to have large ones
        list.resize(900, needed + 10);
        QTRY_COMPARE(card->height(), large);
    }

    void aDemoIsOpenedByMouseAndKeys() {
        DemoList list;
        list.setDemos(demos());
        list.show();
        QVERIFY(QTest::qWaitForWindowExposed(&list));
        QSignalSpy asked(&list, &DemoList::demoRequested);
        const auto cards = list.findChildren<DemoCard*>();
        QTest::mouseClick(cards[2], Qt::LeftButton);
        QCOMPARE(asked.takeFirst()[0].toString(), QString(":/c"));
        cards[0]->setFocus();
        QTest::keyClick(cards[0], Qt::Key_Tab);
        QTRY_VERIFY2(cards[1]->hasFocus(), "Tab goes from card to card");
        QTest::keyClick(cards[1], Qt::Key_Space);
        QCOMPARE(asked.takeFirst()[0].toString(), QString(":/b"));
    }

    void aPictureTakesThePlaceOfTheIcon() {
        DemoList list;
        list.setDemos(demos());
        list.resize(1200, 400);
        list.show();
        DemoCard* card = list.findChildren<DemoCard*>().front();
        QVERIFY(!card->hasPicture());
        QImage picture(80, 52, QImage::Format_RGB32);
        picture.fill(Qt::magenta);
        list.setPicture(":/a", picture);
        list.setPicture(":/unknown", picture);
        QVERIFY(card->hasPicture());
        QCOMPARE(card->grab().toImage().pixelColor(card->height() / 2, card->height() / 2),
                 QColor(Qt::magenta));
        // Other texts, for example another language, make the cards anew; the pictures come again.
        list.setDemos(demos());
        QVERIFY(!list.findChildren<DemoCard*>().front()->hasPicture());
    }
};

QTEST_MAIN(DemoListTest)

#include "demo_list_test.moc"
