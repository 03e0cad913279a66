// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/theme.h"
#include "widgets/pattern/pattern_library.h"

#include <QApplication>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

using namespace teleta;
using namespace teleta::pattern;

namespace {

QTreeWidget* treeOf(const PatternLibrary& library) {
    return library.findChild<QTreeWidget*>();
}

/// A pattern of the first group.
const QTreeWidgetItem& rowOf(const QTreeWidget& tree, int pattern) {
    const QTreeWidgetItem* row = tree.topLevelItem(0)->child(pattern);
    if (row == nullptr)
        qFatal("no such row");
    return *row;
}

} // namespace

/// The list of patterns.
class PatternLibraryTest : public QObject {
    Q_OBJECT

private slots:
    void theLibraryListsAllBuiltInsAndFilters() {
        PatternLibrary library;
        QCOMPARE(treeOf(library)->topLevelItem(0)->childCount(), 12);
        QCOMPARE(treeOf(library)->topLevelItem(1)->childCount(), 10);
        QTest::keyClicks(library.findChild<QLineEdit*>("filter"), "shape.A");
        int shown = 0;
        for (int i = 0; i < 12; ++i)
            shown += treeOf(library)->topLevelItem(0)->child(i)->isHidden() ? 0 : 1;
        QCOMPARE(shown, 2);
        QVERIFY(treeOf(library)->topLevelItem(1)->isHidden());
        QSignalSpy opened(&library, &PatternLibrary::openRequested);
        emit treeOf(library)->itemActivated(treeOf(library)->topLevelItem(0)->child(0), 0);
        QCOMPARE(opened[0][0].toString(), QString("shape.A.static"));
    }

    void whatIsOpenIsMarkedWhateverIsHighlighted() {
        PatternLibrary library;
        library.resize(300, 700);
        library.show();
        QTreeWidget* tree = treeOf(library);
        library.setCurrent(QStringLiteral("shape.A.static"));
        const QTreeWidgetItem* shapes = tree->topLevelItem(0);
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, {},
                          tree->visualItemRect(shapes->child(3)).center());
        QCOMPARE(tree->currentItem(), shapes->child(3));
        for (int i = 0; i < shapes->childCount(); ++i) {
            const QTreeWidgetItem* item = shapes->child(i);
            // Each has its picture; the bar in front of it marks the open one.
            const QImage picture = item->icon(0).pixmap(tree->iconSize()).toImage();
            QVERIFY(picture.pixelColor(picture.width() - 2, picture.height() / 2).alpha() > 0);
            QCOMPARE(picture.pixelColor(1, picture.height() / 2).alpha() > 0, i == 0);
            QCOMPARE(item->font(0).bold(), i == 0);
            QCOMPARE(!item->data(0, Qt::AccessibleDescriptionRole).toString().isEmpty(), i == 0);
        }
    }

    void aPictureIsSeenInASelectedRow() {
        PatternLibrary library;
        library.resize(300, 700);
        library.show();
        const QTreeWidget* tree = treeOf(library);
        const QColor row = library.palette().color(QPalette::Highlight);
        const QImage picture =
            rowOf(*tree, 0).icon(0).pixmap(tree->iconSize(), QIcon::Selected).toImage(); // on all the time
        int seen = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                seen += picture.pixelColor(x, y).alpha() == 255 &&
                                base::contrast(picture.pixelColor(x, y), row) >= 3.0
                            ? 1
                            : 0;
        QVERIFY2(3 * seen > picture.width() * picture.height(), qPrintable(QString::number(seen)));
    }

    void aClickOnARowOpensItsPattern() {
        PatternLibrary library;
        library.resize(400, 600);
        library.show();
        QVERIFY(QTest::qWaitForWindowExposed(&library));
        QTreeWidget* tree = treeOf(library);
        QSignalSpy opened(&library, &PatternLibrary::openRequested);
        const QTreeWidgetItem& row = rowOf(*tree, 4);
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, tree->visualItemRect(&row).center());
        QCOMPARE(opened.count(), 1);
        QCOMPARE(opened[0][0].toString(), row.toolTip(0));
    }

    void onlyTheOpenPatternIsHighlighted() {
        PatternLibrary library;
        library.resize(400, 600);
        library.show();
        QVERIFY(QTest::qWaitForWindowExposed(&library));
        QTreeWidget* tree = treeOf(library);
        library.setCurrent(rowOf(*tree, 2).toolTip(0));
        QVERIFY(tree->currentItem() == &rowOf(*tree, 2));
        library.setCurrent("imported"); // it is not in the list
        QVERIFY(tree->currentItem() == nullptr);
        QVERIFY(tree->selectedItems().isEmpty());
        library.setOwn({{"imported", "Dots", 2.0, {}, {}, {}, true}});
        QVERIFY(tree->currentItem() != nullptr);
        QCOMPARE(tree->currentItem()->text(0), QString("Dots"));
    }

    void lengthsGiveWayBeforePictures() {
        PatternLibrary library;
        QTreeWidget* tree = treeOf(library);
        library.resize(600, 600);
        library.show();
        QVERIFY(QTest::qWaitForWindowExposed(&library));
        const int large = tree->iconSize().width();
        QVERIFY(!tree->isColumnHidden(1));
        int hidden = 0;
        for (int width = 600; !hidden && width > 100; width -= 4) {
            library.resize(width, 600);
            QTest::qWait(0);
            if (tree->isColumnHidden(1))
                hidden = width;
        }
        QVERIFY(hidden > 0);
        QCOMPARE(tree->iconSize().width(), large);
    }

    void picturesGiveWayToNames() {
        PatternLibrary library;
        QTreeWidget* tree = treeOf(library);
        library.resize(500, 600);
        library.show();
        QVERIFY(QTest::qWaitForWindowExposed(&library));
        const int large = tree->iconSize().width();
        const QFontMetrics metrics(tree->font());
        const auto isNameWhole = [&](int pattern) {
            const QTreeWidgetItem& row = rowOf(*tree, pattern);
            // Picture, text, and what the style leaves beside both.
            const int margin = tree->style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1;
            return tree->visualItemRect(&row).width() >=
                   tree->iconSize().width() + metrics.horizontalAdvance(row.text(0)) + 4 * margin;
        };
        library.resize(base::em(&library, 12.4), 600); // as wide as in a window of 1024 px
        QTRY_VERIFY(tree->iconSize().width() < large);
        for (int pattern = 0; pattern < 12; ++pattern)
            QVERIFY2(isNameWhole(pattern), qPrintable(rowOf(*tree, pattern).text(0)));
        QVERIFY2(tree->isColumnHidden(1), "lengths give way, too");
        library.resize(500, 600);
        QTRY_COMPARE(tree->iconSize().width(), large);
        QVERIFY(!tree->isColumnHidden(1));
    }

    void aPictureIsDrawnOnce() {
        PatternLibrary library;
        QTreeWidget* tree = treeOf(library);
        const auto picture = [&](int pattern) { return rowOf(*tree, pattern).icon(0).cacheKey(); };
        const qint64 first = picture(0);
        const qint64 second = picture(1);
        const QString key = rowOf(*tree, 0).toolTip(0);
        library.setCurrent(key);
        QVERIFY2(picture(0) != first, "with a bar");
        QCOMPARE(picture(1), second);
        library.setCurrent(QString());
        QCOMPARE(picture(0), first);
        base::applyTheme(base::ThemeChoice::dark);
        QTRY_VERIFY(picture(1) != second);
        base::applyTheme(base::ThemeChoice::light);
    }

    void ownPatternsAreFoundByTagRenamedDeletedAndDamagedOnesSayWhy() {
        PatternLibrary library;
        library.setOwn({{"/p/wave.json", "Slow wave", 2.0, {"soft", "arm"}, "notes", {}, true},
                        {"/p/bad.json", "bad.json", 0.0, {}, {}, "/p/bad.json:3:1: damaged", true}});
        library.resize(300, 700);
        library.show();
        QTreeWidgetItem* mine = treeOf(library)->topLevelItem(2);
        QCOMPARE(mine->childCount(), 2);
        QVERIFY(mine->child(1)->toolTip(0).contains(":3:1"));
        QTest::keyClicks(library.findChild<QLineEdit*>("filter"), "soft wave");
        QVERIFY(!mine->child(0)->isHidden());
        QVERIFY(mine->child(1)->isHidden());
        library.findChild<QLineEdit*>("filter")->clear();
        QSignalSpy deletions(&library, &PatternLibrary::deleteRequested);
        QSignalSpy duplicates(&library, &PatternLibrary::duplicateRequested);
        QSignalSpy renames(&library, &PatternLibrary::renameRequested);
        QSignalSpy undos(&library, &PatternLibrary::undoRequested);
        treeOf(library)->setCurrentItem(mine->child(0));
        QTest::keyClick(treeOf(library), Qt::Key_F2);
        auto* line = treeOf(library)->findChild<QLineEdit*>();
        QVERIFY(line);
        line->selectAll();
        QTest::keyClicks(line, "Fast wave");
        QTest::keyClick(line, Qt::Key_Return);
        QTRY_COMPARE(renames.size(), 1);
        QCOMPARE(renames[0][0].toString(), QString("/p/wave.json"));
        QCOMPARE(renames[0][1].toString(), QString("Fast wave"));
        QTest::keyClick(treeOf(library), Qt::Key_D, Qt::ControlModifier);
        QCOMPARE(duplicates.size(), 1);
        QTest::keyClick(treeOf(library), Qt::Key_Delete);
        QCOMPARE(deletions[0][0].toString(), QString("/p/wave.json"));
        QTest::keyClick(treeOf(library), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(undos.size(), 1);
        library.setNotice("Slow wave was deleted.", true);
        QTest::mouseClick(library.findChild<QPushButton*>("undo"), Qt::LeftButton);
        QCOMPARE(undos.size(), 2);
        treeOf(library)->setCurrentItem(treeOf(library)->topLevelItem(0)->child(0));
        QTest::keyClick(treeOf(library), Qt::Key_Delete); // a built-in one stays
        QCOMPARE(deletions.size(), 1);
    }

    void theMenuOfAPatternRenamesItAlthoughTheFolderWasReadMeanwhile() {
        PatternLibrary library;
        const std::vector<OwnPattern> own{{"/p/wave.json", "Slow wave", 2.0, {}, {}, {}, true}};
        library.setOwn(own);
        library.resize(300, 700);
        library.show();
        QTreeWidget* tree = treeOf(library);
        const QTreeWidgetItem* item = tree->topLevelItem(2)->child(0);
        tree->scrollToItem(item);
        emit tree->customContextMenuRequested(tree->visualItemRect(item).center());
        auto* menu = library.findChild<QMenu*>();
        QVERIFY(menu);
        library.setOwn(own);
        const auto actions = menu->actions();
        const auto rename = std::find_if(actions.begin(), actions.end(), [](const QAction* action) {
            return action->shortcut() == QKeySequence(Qt::Key_F2);
        });
        QVERIFY(rename != actions.end());
        (*rename)->trigger();
        QVERIFY(tree->findChild<QLineEdit*>());
        menu->close();
    }
};

namespace {
const test::Registration<PatternLibraryTest> registration;
}
#include "pattern_library_test.moc"
