// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/base/picture_property.h"
#include "widgets/chrome/message_bar.h"

#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <chrono>

using teleta::chrome::Message;
using teleta::chrome::MessageBar;

namespace {

/// A view with a field before its notices and one after them.
struct View : public QWidget {
    explicit View(QWidget* parent = nullptr)
        : QWidget(parent)
        , before(new QPushButton(QStringLiteral("before"), this))
        , bar(new MessageBar(this))
        , after(new QPushButton(QStringLiteral("after"), this)) {
        auto* column = new QVBoxLayout(this);
        column->addWidget(before);
        column->addWidget(bar);
        column->addWidget(after, 1);
    }

    QPushButton* before;
    MessageBar* bar;
    QPushButton* after;
};

} // namespace

/// Notices above a view.
class MessageBarTest : public QObject {
    Q_OBJECT

    static Message message(const QString& text) {
        return {Message::Severity::error, text, QStringLiteral("do this"), QStringLiteral("file.csv:3:1")};
    }

    static QList<QWidget*> rows(const MessageBar& bar) {
        QList<QWidget*> visible;
        for (auto* row : bar.findChildren<QWidget*>("message")) {
            if (!row->isHidden())
                visible << row;
        }
        return visible;
    }

    static bool showsText(const QWidget* row, const QString& text) {
        const auto labels = row->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* label) { return label->text().contains(text); });
    }

private slots:
    void isHiddenWhileThereIsNothingToSay() {
        MessageBar bar;
        QVERIFY(bar.isHidden());
        bar.post(message("one"));
        QVERIFY(!bar.isHidden());
        bar.clear();
        QVERIFY(bar.isHidden());
    }

    void nothingStaysInAnotherLanguage() {
        View view;
        view.bar->post({Message::Severity::information, QStringLiteral("It was recorded."), {}, {}});
        view.bar->post(message(QStringLiteral("It failed.")));
        QCOMPARE(rows(*view.bar).size(), 2);
        QEvent change(QEvent::LanguageChange);
        QApplication::sendEvent(view.bar, &change);
        QCOMPARE(rows(*view.bar).size(), 0);
        QVERIFY(!view.bar->isVisible());
    }

    void countsUpInsteadOfRepeating() {
        MessageBar bar;
        for (int time = 0; time < 12; ++time)
            bar.post(message("lost"));
        QCOMPARE(bar.count(), 1);
        QCOMPARE(bar.repeats(), 12);
        QCOMPARE(rows(bar).size(), 1);
        QVERIFY(showsText(rows(bar).first(), "12"));
    }

    void showsTheNewestFirstAndKeepsOlderOnesBehind() {
        MessageBar bar;
        for (int number = 1; number <= 5; ++number)
            bar.post(message(QString("message %1").arg(number)));
        QCOMPARE(rows(bar).size(), MessageBar::kShown);
        QVERIFY(showsText(rows(bar).first(), "message 5"));
        QCOMPARE(bar.count(), 5);
        bar.post(message("message 1"));
        QVERIFY(showsText(rows(bar).first(), "message 1"));
        QCOMPARE(bar.count(), 5);
    }

    void opensDetailsOnDemandAndDismissesOne() {
        MessageBar bar;
        bar.post(message("first"));
        bar.post(message("second"));
        QVERIFY(!showsText(rows(bar).first(), "file.csv:3:1"));
        QTest::mouseClick(rows(bar).first()->findChildren<QToolButton*>().first(), Qt::LeftButton);
        QVERIFY(showsText(rows(bar).first(), "file.csv:3:1"));
        QTest::mouseClick(rows(bar).first()->findChildren<QToolButton*>().last(), Qt::LeftButton);
        QCOMPARE(bar.count(), 1);
        QVERIFY(showsText(rows(bar).first(), "first"));
    }

    void staysBoundedUnderAFloodOfDifferentMessages() {
        MessageBar bar;
        for (int number = 0; number < 3 * MessageBar::kKept; ++number)
            bar.post(message(QString::number(number)));
        QCOMPARE(bar.count(), MessageBar::kKept);
        QVERIFY(showsText(rows(bar).first(), QString::number(3 * MessageBar::kKept - 1)));
    }

    void movesNothingAwayUnderTheMouse() {
        View view;
        view.resize(view.fontMetrics().height() * 40, view.fontMetrics().height() * 30);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        const QRect before = view.before->geometry();
        const QRect after = view.after->geometry();
        view.bar->post(message("one"));
        view.bar->post(message("two"));
        QTRY_VERIFY(view.bar->isVisible());
        QCoreApplication::processEvents();
        QCOMPARE(view.before->geometry(), before);
        QCOMPARE(view.after->geometry(), after);
        QVERIFY(view.rect().contains(view.bar->geometry()));
        for (const QWidget* row : rows(*view.bar))
            QVERIFY(row->height() >= row->minimumSizeHint().height());
    }

    void liesOverThePartOfAViewThatIsSeen() {
        QScrollArea room;
        auto* view = new View;
        const int line = room.fontMetrics().height();
        view->setFixedSize(line * 60, line * 60);
        room.setWidget(view);
        room.resize(line * 30, line * 30);
        room.show();
        QVERIFY(QTest::qWaitForWindowExposed(&room));
        view->bar->post(message("one"));
        const auto seen = [&] {
            return QRect(view->bar->mapTo(room.viewport(), QPoint()), view->bar->size());
        };
        QVERIFY(room.viewport()->rect().contains(seen()));
        room.verticalScrollBar()->setValue(line * 20);
        QTRY_VERIFY(room.viewport()->rect().contains(seen()));
        room.resize(line * 50, line * 30);
        QTRY_COMPARE(seen().bottom(), room.viewport()->rect().bottom());
        QVERIFY(room.viewport()->rect().contains(seen()));
    }

    void coversNoControlWhereACornerIsFree() {
        QWidget view;
        const int line = view.fontMetrics().height();
        view.resize(line * 100, line * 30);
        MessageBar bar(&view);
        QPushButton play(QStringLiteral("Play"), &view);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        const std::array corners{QRect(0, line * 28, line * 5, line),
                                 QRect(line * 94, line * 28, line * 5, line), QRect(0, line, line * 5, line),
                                 QRect(line * 94, line, line * 5, line)};
        for (const QRect& corner : corners) {
            play.setGeometry(corner);
            bar.clear();
            bar.post(message("one"));
            QVERIFY(bar.isVisible());
            QVERIFY2(!bar.geometry().intersects(play.geometry()), qPrintable(QString::number(corner.x())));
        }
        // One that cannot be used yet will be, under a notice that stays.
        play.setEnabled(false);
        for (const QRect& corner : corners) {
            play.setGeometry(corner);
            bar.clear();
            bar.post(message("one"));
            QVERIFY2(!bar.geometry().intersects(play.geometry()), qPrintable(QString::number(corner.x())));
        }
    }

    void coversAPictureRatherThanAText() {
        QWidget view;
        auto* line = new QHBoxLayout(&view);
        auto* picture = new QWidget(&view);
        picture->setFocusPolicy(Qt::StrongFocus);
        line->addWidget(picture, 1);
        auto* column = new QVBoxLayout;
        line->addLayout(column, 1);
        for (const char* text : {"Nothing is plugged in.", "Nothing is held."})
            column->addWidget(new QLabel(QString::fromLatin1(text), &view), 0,
                              column->isEmpty() ? Qt::AlignTop : Qt::AlignBottom);
        MessageBar bar(&view);
        const int height = view.fontMetrics().height();
        view.resize(height * 120, height * 40);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        bar.post(message("one"));
        QCoreApplication::processEvents();
        for (const auto* text : view.findChildren<QLabel*>(Qt::FindDirectChildrenOnly))
            QVERIFY(!bar.geometry().intersects(text->geometry()));
        QVERIFY(picture->geometry().intersects(bar.geometry()));
    }

    void coversNoTitleOfADock() {
        QWidget view;
        const int line = view.fontMetrics().height();
        view.resize(line * 60, line * 30);
        auto* column = new QVBoxLayout(&view);
        auto* docks = new QMainWindow(&view);
        docks->setWindowFlags(Qt::Widget);
        docks->setCentralWidget(new QWidget(docks));
        column->addWidget(docks);
        auto* dock = new QDockWidget(QStringLiteral("Stiffness"), docks);
        dock->setWidget(new QWidget(dock));
        docks->addDockWidget(Qt::BottomDockWidgetArea, dock);
        dock->setFixedHeight(line * 3); // its title is where notices are first looked for a place
        MessageBar bar(&view);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        QTRY_VERIFY(dock->widget()->y() > 0);
        bar.post(message("one"));
        const QRect title(dock->mapTo(&view, QPoint()), QSize(dock->width(), dock->widget()->y()));
        QVERIFY(!bar.geometry().intersects(title));
    }

    void aTableMakesRoomInsteadOfBeingCovered() {
        QWidget view;
        auto* column = new QVBoxLayout(&view);
        column->setContentsMargins(3, 4, 5, 6);
        auto* button = new QPushButton(QStringLiteral("Play"), &view);
        auto* table = new QTableWidget(20, 3, &view);
        column->addWidget(button);
        column->addWidget(table, 1);
        MessageBar bar(&view);
        const int line = view.fontMetrics().height();
        view.resize(line * 50, line * 40);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        const QRect before = table->geometry();
        bar.post(message("one"));
        const auto isClear = [&] {
            return !bar.geometry().intersects(table->geometry()) &&
                   !bar.geometry().intersects(button->geometry());
        };
        QTRY_VERIFY(isClear());
        QVERIFY(view.rect().contains(bar.geometry()));
        QCOMPARE(table->geometry().topLeft(), before.topLeft());
        bar.post(message("two")); // higher now
        QTRY_VERIFY(isClear());
        // The last row can be clicked.
        table->scrollToBottom();
        const QModelIndex last = table->model()->index(19, 1);
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(last).center());
        QCOMPARE(table->currentIndex(), last);
        for (int i = 0; i < 2; ++i)
            QTest::mouseClick(rows(bar).front()->findChild<QToolButton*>("dismiss"), Qt::LeftButton);
        QVERIFY(!bar.isVisible());
        QTRY_COMPARE(table->geometry(), before);
    }

    void aPictureIsCoveredInACornerAndKeepsItsSize() {
        QWidget view;
        auto* column = new QVBoxLayout(&view);
        auto* picture = new QWidget(&view);
        picture->setFocusPolicy(Qt::StrongFocus);
        column->addWidget(picture);
        MessageBar bar(&view);
        const int line = view.fontMetrics().height();
        view.resize(line * 80, line * 40);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        const QRect before = picture->geometry();
        bar.post(message("one"));
        QCoreApplication::processEvents();
        QCOMPARE(picture->geometry(), before);
        QVERIFY(bar.geometry().intersects(before));
    }

    void liesOverAPictureWhereEachCornerHasControls() {
        QWidget view;
        auto* column = new QVBoxLayout(&view);
        const auto addButtons = [&] {
            auto* line = new QHBoxLayout;
            for (const char* text : {"One", "Two"})
                line->addWidget(new QPushButton(QString::fromLatin1(text), &view));
            column->addLayout(line);
        };
        addButtons();
        auto* picture = new QWidget(&view);
        picture->setFocusPolicy(Qt::StrongFocus);
        picture->setProperty(teleta::base::kPictureProperty, true);
        column->addWidget(picture, 1);
        addButtons();
        MessageBar bar(&view);
        const int line = view.fontMetrics().height();
        view.resize(line * 60, line * 40);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        const QRect before = picture->geometry();
        bar.post(message("one"));
        QCoreApplication::processEvents();
        QCOMPARE(picture->geometry(), before);
        QVERIFY(before.contains(bar.geometry()));
        // Too narrow for a sentence: the view makes room again.
        picture->setMaximumWidth(line * 10);
        bar.post(message("two"));
        QTRY_VERIFY(!bar.geometry().intersects(picture->geometry()));
        QVERIFY(view.rect().contains(bar.geometry()));
        for (const auto* button : view.findChildren<QPushButton*>())
            QVERIFY(!bar.geometry().intersects(button->geometry()));
    }

    void informationLeavesByItselfAndTroubleStays() {
        View view;
        view.bar->setShowing(std::chrono::milliseconds(300));
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        view.bar->post(message("trouble"));
        view.bar->post({Message::Severity::warning, QStringLiteral("a warning"), {}, {}});
        view.bar->post({Message::Severity::information, QStringLiteral("done"), {}, {}});
        QCOMPARE(view.bar->count(), 3);
        QTRY_COMPARE(view.bar->count(), 2);
        QVERIFY(showsText(rows(*view.bar).first(), "a warning"));
        // What nobody can see does not leave.
        view.hide();
        view.bar->post({Message::Severity::information, QStringLiteral("unseen"), {}, {}});
        QElapsedTimer hidden;
        hidden.start();
        QTRY_VERIFY(hidden.elapsed() > 700);
        QCOMPARE(view.bar->count(), 3);
    }

    void informationStaysWhileItIsUsed() {
        View view;
        view.bar->setShowing(std::chrono::milliseconds(300));
        view.show();
        view.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&view));
        view.bar->post({Message::Severity::information, QStringLiteral("done"), {}, QStringLiteral("/file")});
        auto* details = rows(*view.bar).first()->findChild<QToolButton*>(QStringLiteral("details"));
        details->setFocus(Qt::TabFocusReason);
        QElapsedTimer used;
        used.start();
        QTRY_VERIFY(used.elapsed() > 700);
        QCOMPARE(view.bar->count(), 1);
        view.before->setFocus(Qt::TabFocusReason);
        QTRY_COMPARE(view.bar->count(), 0);
    }

    void doesWhatItsButtonsSayAndGoes() {
        View view;
        view.show();
        view.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&view));
        QStringList done;
        view.bar->post({Message::Severity::information,
                        QStringLiteral("a.teleta was recorded."),
                        {},
                        {},
                        {{QStringLiteral("Play it"), [&] { done << QStringLiteral("play"); }},
                         {QStringLiteral("Show in folder"), [&] { done << QStringLiteral("show"); }}}});
        const auto buttons = rows(*view.bar).first()->findChildren<QToolButton*>(QStringLiteral("action"));
        QCOMPARE(buttons.size(), 2);
        QCOMPARE(buttons[1]->text(), QStringLiteral("Show in folder"));
        QTest::mouseClick(buttons[1], Qt::LeftButton);
        QCOMPARE(done, QStringList{QStringLiteral("show")});
        QCOMPARE(view.bar->count(), 0);
    }

    void isReachedByTheKeyboardWhichItKeeps() {
        View view;
        view.show();
        view.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&view));
        view.bar->post(message("first"));
        view.bar->post(message("second"));
        const auto button = [&](int row, const char* name) {
            return rows(*view.bar)[row]->findChild<QWidget*>(QLatin1String(name));
        };
        view.before->setFocus(Qt::TabFocusReason);
        QTest::keyClick(view.before, Qt::Key_Tab);
        QCOMPARE(QApplication::focusWidget(), button(0, "details"));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
        QVERIFY(showsText(rows(*view.bar).first(), "file.csv:3:1"));
        QCOMPARE(QApplication::focusWidget(), button(0, "details"));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QCOMPARE(QApplication::focusWidget(), button(0, "dismiss"));
        QCOMPARE(QApplication::focusWidget()->accessibleDescription(), QStringLiteral("second"));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
        QCOMPARE(view.bar->count(), 1);
        QCOMPARE(QApplication::focusWidget(), button(0, "dismiss"));
        view.bar->post(message("third"));
        QCOMPARE(QApplication::focusWidget(), button(1, "dismiss"));
    }

    void showsTextAsItIsAndNotAsMarkup() {
        MessageBar bar;
        bar.post(message("<b>file</b>"));
        const auto labels = rows(bar).first()->findChildren<QLabel*>();
        for (const QLabel* label : labels)
            QVERIFY(label->textFormat() == Qt::PlainText || !label->text().contains("<b>"));
    }
};

QTEST_MAIN(MessageBarTest)
#include "message_bar_test.moc"
