// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/message_bar.h"

#include <QFrame>
#include <QLabel>
#include <QTest>
#include <QToolButton>

using teleta::chrome::Message;
using teleta::chrome::MessageBar;

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
