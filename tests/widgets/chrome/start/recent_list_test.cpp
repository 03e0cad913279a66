// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/start/recent_list.h"

#include <QImage>
#include <QLayout>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include <algorithm>
#include <memory>

using namespace teleta;
using chrome::RecentList;

/// The files that were opened before.
class RecentListTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_list = std::make_unique<RecentList>();
        m_list->setFiles({QStringLiteral("/a/one.mcap"), QStringLiteral("/a/two.toml")});
        m_list->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_list.get()));
    }

    void aFileIsAskedForByAClickAndByTheKeyboard() {
        const QSignalSpy asked(m_list.get(), &RecentList::fileRequested);
        QTest::mouseClick(files()[0], Qt::LeftButton);
        QTest::keyClick(files()[1], Qt::Key_Space);
        QCOMPARE(asked.size(), 2);
        QCOMPARE(asked[0][0].toString(), QStringLiteral("/a/one.mcap"));
        QCOMPARE(asked[1][0].toString(), QStringLiteral("/a/two.toml"));
    }

    void aPictureComesAndTheFocusStays() {
        files()[1]->setFocus();
        QTRY_VERIFY(files()[1]->hasFocus());
        QImage red(40, 30, QImage::Format_RGB32);
        red.fill(Qt::red);
        m_list->setPicture(QStringLiteral("/a/two.toml"), red);
        m_list->setPicture(QStringLiteral("/a/unknown.toml"), red);
        QVERIFY(files()[1]->hasFocus());
        const QImage shown = files()[1]->icon().pixmap(files()[1]->iconSize()).toImage();
        QCOMPARE(shown.pixelColor(shown.width() / 2, shown.height() / 2), QColor(Qt::red));
    }

    void aNewFileIsTheFirstAndTheOthersKeepTheirButtons() {
        QToolButton* const one = files()[0];
        one->setFocus();
        QTRY_VERIFY(one->hasFocus());
        m_list->setFiles({QStringLiteral("/a/new.csv"), QStringLiteral("/a/one.mcap"),
                          QStringLiteral("/a/two.toml"), QStringLiteral("/a/beyond.toml")});
        QCOMPARE(files().size(), RecentList::kFiles);
        QVERIFY(one->hasFocus());
        QCOMPARE(files()[0]->toolTip(), QStringLiteral("/a/new.csv"));
        QCOMPARE(files()[1], one);
        QTRY_VERIFY(files()[0]->x() < one->x());
        QTRY_VERIFY(one->x() < files()[2]->x());
    }

    void withNothingToOpenItIsHidden() {
        m_list->setFiles({});
        QVERIFY(m_list->isHidden());
        m_list->setSession(QStringLiteral("arm, camera"));
        QVERIFY(!m_list->isHidden());
        const QSignalSpy asked(m_list.get(), &RecentList::sessionRequested);
        QTest::mouseClick(m_list->findChild<QToolButton*>(QStringLiteral("reopenSession")), Qt::LeftButton);
        QCOMPARE(asked.size(), 1);
    }

private:
    /// From left to right.
    [[nodiscard]] QList<QToolButton*> files() const {
        QList<QToolButton*> found = m_list->findChildren<QToolButton*>(QStringLiteral("recentFile"));
        std::ranges::sort(found, {},
                          [this](const QToolButton* button) { return m_list->layout()->indexOf(button); });
        return found;
    }

    std::unique_ptr<RecentList> m_list;
};

QTEST_MAIN(RecentListTest)
#include "recent_list_test.moc"
