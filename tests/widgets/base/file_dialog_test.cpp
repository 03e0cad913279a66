// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/file_dialog.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QScreen>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>

using namespace teleta::base;

/// The dialogs that ask for a file.
class FileDialogTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsSaidOfARecordingIsSeenWhole() {
        QTemporaryDir folder;
        const QString name = QStringLiteral("20261130T091014Z-teleoperation.teleta");
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.close();
        QWidget parent;
        QFileDialog* dialog =
            askToOpen(&parent, {.title = "Open", .folder = folder.path()}, [](const QString&) {});
        QVERIFY(QTest::qWaitForWindowExposed(dialog));
        auto* files = dialog->findChild<QTreeView*>("treeView");
        QVERIFY(files != nullptr);
        QTRY_COMPARE(files->model()->rowCount(files->rootIndex()), 1);
        const QModelIndex first = files->model()->index(0, 0, files->rootIndex());
        QCOMPARE(first.data().toString(), name);
        for (int column = 0; column < 4; ++column) {
            const QSize wanted = files->sizeHintForIndex(first.siblingAtColumn(column));
            QVERIFY2(files->header()->sectionSize(column) >= wanted.width(),
                     qPrintable(QString::number(column)));
        }
        QVERIFY(dialog->screen()->availableGeometry().contains(dialog->geometry()));
        dialog->reject();
    }

    void aFolderThatIsNotThereYetIsNotTakenForAFile() {
        QTemporaryDir folder;
        QWidget parent;
        QFileDialog* dialog = askToSave(
            &parent, {.title = "Save", .folder = folder.filePath("documents/TeleTA"), .name = "run.csv"},
            [](const QString&) {});
        QVERIFY(QTest::qWaitForWindowExposed(dialog));
        QCOMPARE(dialog->directory().canonicalPath(), QDir(folder.path()).canonicalPath());
        QCOMPARE(QFileInfo(dialog->selectedFiles().value(0)).fileName(), QStringLiteral("run.csv"));
        dialog->reject();
    }
};

static const teleta::test::Registration<FileDialogTest> registration;
#include "file_dialog_test.moc"
