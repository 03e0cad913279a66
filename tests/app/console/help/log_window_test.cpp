// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/help/help_menu.h"
#include "app/console/help/log_window.h"
#include "widgets/chrome/message_log.h"

#include <QClipboard>
#include <QFile>
#include <QFileDialog>
#include <QGuiApplication>
#include <QMenu>
#include <QPushButton>
#include <QSysInfo>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

using namespace teleta;
using chrome::Message;
using chrome::MessageLog;

class LogWindowTest : public QObject {
    Q_OBJECT

    static void click(const QWidget& window, const QString& text) {
        for (auto* button : window.findChildren<QPushButton*>())
            if (button->text().remove(u'&') == text)
                QTest::mouseClick(button, Qt::LeftButton);
    }

private slots:
    void showsCopiesAndSavesWhatWasTold() {
        QWidget window;
        QMenu menu;
        console::HelpMenu help(window, [] { return QString(); });
        help.fill(menu);
        MessageLog::instance().append(Message::Severity::error, QStringLiteral("The arm was lost."));
        for (QAction* action : menu.actions())
            if (action->text().remove(u'&') == QLatin1String("Log"))
                action->trigger();
        auto* log = window.findChild<console::LogWindow*>();
        QVERIFY(log != nullptr);
        QVERIFY(QTest::qWaitForWindowExposed(log));
        auto* table = log->findChild<QTableView*>();
        QTRY_COMPARE(table->model()->rowCount(), 1);
        QCOMPARE(table->model()->index(0, MessageLog::kText).data().toString(),
                 QStringLiteral("The arm was lost."));

        click(*log, QStringLiteral("Copy"));
        QVERIFY(QGuiApplication::clipboard()->text().endsWith(QStringLiteral("Error: The arm was lost.\n")));

        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("log.txt"));
        click(*log, QStringLiteral("Save\u2026"));
        auto* dialog = log->findChild<QFileDialog*>();
        QVERIFY(dialog != nullptr);
        dialog->selectFile(path);
        emit dialog->fileSelected(path);
        QTRY_COMPARE(table->model()->rowCount(), 2); // that it was written
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().endsWith("Error: The arm was lost.\n"));
        dialog->close();

        // What cannot be written is told.
        click(*log, QStringLiteral("Save\u2026"));
        auto* again = log->findChild<QFileDialog*>();
        emit again->fileSelected(folder.filePath(QStringLiteral("none/log.txt")));
        QTRY_COMPARE(table->model()->rowCount(), 3);
        QCOMPARE(table->model()->index(2, MessageLog::kKind).data().toString(), QStringLiteral("Error"));
    }

    void opensAtTheNewestLine() {
        for (int i = 0; i < 100; ++i)
            MessageLog::instance().append(Message::Severity::information, QString::number(i));
        QWidget window;
        auto* log = new console::LogWindow(&window);
        const auto* table = log->findChild<QTableView*>();
        const auto isLastSeen = [&] {
            const QModelIndex last = table->model()->index(table->model()->rowCount() - 1, 0);
            return table->viewport()->rect().contains(table->visualRect(last).center());
        };
        for (int times = 0; times < 2; ++times) {
            log->show();
            QVERIFY(QTest::qWaitForWindowExposed(log));
            QTRY_VERIFY(isLastSeen());
            log->hide();
            for (int i = 0; i < 100; ++i)
                MessageLog::instance().append(Message::Severity::information, QString::number(i));
        }
    }

    void staysAtItsEndUnlessOneHasScrolledUp() {
        QWidget window;
        auto* log = new console::LogWindow(&window);
        log->resize(400, 300);
        log->show();
        QVERIFY(QTest::qWaitForWindowExposed(log));
        auto* table = log->findChild<QTableView*>();
        const auto tell = [&](int times) {
            const int before = table->model()->rowCount();
            for (int i = 0; i < times; ++i)
                MessageLog::instance().append(Message::Severity::information, QString::number(i));
            QTRY_COMPARE(table->model()->rowCount(), before + times);
        };
        const auto isLastSeen = [&] {
            const QModelIndex last = table->model()->index(table->model()->rowCount() - 1, 0);
            return table->viewport()->rect().intersects(table->visualRect(last));
        };
        tell(100);
        QTRY_VERIFY(isLastSeen());
        table->scrollToTop();
        tell(100);
        QVERIFY(!isLastSeen());
    }

    void beginsWithProgramQtAndSystem() {
        MessageLog& log = MessageLog::instance();
        const int before = log.rowCount();
        console::beginLog();
        QTRY_VERIFY(log.rowCount() > before);
        const QString line = log.data(log.index(before, MessageLog::kText), Qt::DisplayRole).toString();
        for (const QString& part : {QCoreApplication::applicationName(), QString::fromLatin1(qVersion()),
                                    QSysInfo::prettyProductName(), QGuiApplication::platformName()})
            QVERIFY2(line.contains(part), qPrintable(line));
    }
};

QTEST_MAIN(LogWindowTest)
#include "log_window_test.moc"
