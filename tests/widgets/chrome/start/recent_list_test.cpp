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

    void aNameIsCutOnlyWhereThereIsNoRoom() {
        m_list->setSession(QStringLiteral("teleoperation of 2026-11-30 00:27, 29 s"));
        const auto* reopen = m_list->findChild<QToolButton*>("reopenSession");
        const int line = m_list->fontMetrics().height();
        m_list->resize(90 * line, m_list->height());
        QTRY_COMPARE(reopen->text(), QStringLiteral("Reopen teleoperation of 2026-11-30 00:27, 29 s"));
        m_list->resize(40 * line, m_list->height());
        QTRY_VERIFY(reopen->text().contains(QChar(0x2026)));
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

    void aRecordingIsCalledByWhatIsInItAndTheTipKeepsThePath() {
        m_list->setNames(
            {{QStringLiteral("/a/one.mcap"), {QStringLiteral("mat & ball"), QStringLiteral("8 s"), {}}}});
        QCOMPARE(files()[0]->text(), QStringLiteral("mat && ball\n8 s"));
        QCOMPARE(files()[0]->accessibleName(), QStringLiteral("mat & ball, 8 s"));
        QCOMPARE(files()[0]->toolTip(), QStringLiteral("/a/one.mcap"));
        QCOMPARE(files()[1]->text(), QStringLiteral("two.toml"));
        // Both lines are seen.
        QTRY_VERIFY(files()[0]->height() >= 2 * files()[0]->fontMetrics().height());
        const QSignalSpy asked(m_list.get(), &RecentList::fileRequested);
        QTest::mouseClick(files()[0], Qt::LeftButton);
        QCOMPARE(asked.size(), 1);
        QCOMPARE(asked[0][0].toString(), QStringLiteral("/a/one.mcap"));
    }

    void filesOfTheSameNameAreToldApart() {
        const chrome::RecentName same{QStringLiteral("touches"), QStringLiteral("2026-11-29 10:22, 8 s"),
                                      QStringLiteral("2026-11-29 10:22:31, 8 s")};
        const QStringList paths{QStringLiteral("/a/x.teleta"), QStringLiteral("/a/y.teleta"),
                                QStringLiteral("/b/y.teleta"), QStringLiteral("/c/b/y.teleta"),
                                QStringLiteral("/a/z.teleta"), QStringLiteral("/a/v.teleta")};
        chrome::RecentNames known;
        for (const QString& path : paths.mid(0, 4))
            known.insert(path, same);
        known.insert(paths[4], {same.title, QStringLiteral("2026-11-29 10:22, 9 s"), {}});
        known.insert(paths[5], {same.title, same.about, QStringLiteral("2026-11-29 10:22:50, 8 s")});
        const QList<chrome::RecentName> names = chrome::recentNamesOf(paths, known);
        QCOMPARE(names[0].title, QStringLiteral("x.teleta"));
        QCOMPARE(names[1].title, QStringLiteral("y.teleta (a)"));
        QCOMPARE(names[2].title, QStringLiteral("/b/y.teleta"));
        QCOMPARE(names[3].title, QStringLiteral("/c/b/y.teleta"));
        QCOMPARE(names[4].title, same.title);
        QCOMPARE(names[4].about, QStringLiteral("2026-11-29 10:22, 9 s"));
        QCOMPARE(names[5].title, same.title);
        QCOMPARE(names[5].about, QStringLiteral("2026-11-29 10:22:50, 8 s"));
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
