// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/message_bar.h"
#include "widgets/chrome/message_log.h"

#include <QRegularExpression>
#include <QTest>

#include <thread>

using namespace teleta;
using chrome::Message;
using chrome::MessageLog;

class MessageLogTest : public QObject {
    Q_OBJECT

    static QString last(int column) {
        const MessageLog& log = MessageLog::instance();
        return log.index(log.rowCount() - 1, column).data().toString();
    }

private slots:
    void keepsWhatAnyViewTellsWithAllOfItsParts() {
        chrome::MessageBar bar;
        const int before = MessageLog::instance().rowCount();
        bar.post({Message::Severity::warning, "The motors are warm.", "Let them rest.", "motor 3"});
        bar.post({Message::Severity::warning, "The motors are warm.", "Let them rest.", "motor 3"});
        bar.clear();
        QTRY_COMPARE(MessageLog::instance().rowCount(), before + 2);
        QCOMPARE(last(MessageLog::kKind), QStringLiteral("Warning"));
        QCOMPARE(last(MessageLog::kText),
                 QStringLiteral("The motors are warm. \u00b7 Let them rest. \u00b7 motor 3"));
        QVERIFY(QRegularExpression(QStringLiteral("^\\d\\d:\\d\\d:\\d\\d\\.\\d{3}$"))
                    .match(last(MessageLog::kTime))
                    .hasMatch());
    }

    void takesMessagesOfAnyThread() {
        const int before = MessageLog::instance().rowCount();
        std::thread([] {
            MessageLog::instance().append(Message::Severity::error, QStringLiteral("from elsewhere"));
        }).join();
        QTRY_COMPARE(MessageLog::instance().rowCount(), before + 1);
        QCOMPARE(last(MessageLog::kText), QStringLiteral("from elsewhere"));
        QCOMPARE(last(MessageLog::kKind), QStringLiteral("Error"));
    }

    void takesMessagesOfQt() {
        MessageLog::instance().takeQtMessages();
        MessageLog::instance().takeQtMessages(); // once is enough
        const int before = MessageLog::instance().rowCount();
        QTest::ignoreMessage(QtWarningMsg, "a library is not content");
        qWarning("a library is not content");
        QTRY_COMPARE(MessageLog::instance().rowCount(), before + 1);
        QCOMPARE(last(MessageLog::kText), QStringLiteral("a library is not content"));
        QCOMPARE(last(MessageLog::kKind), QStringLiteral("Warning"));
    }

    void theOldestGo() {
        MessageLog& log = MessageLog::instance();
        for (int i = 0; i < MessageLog::kKept + 3; ++i)
            log.append(Message::Severity::information, QString::number(i));
        QTRY_COMPARE(last(MessageLog::kText), QString::number(MessageLog::kKept + 2));
        QCOMPARE(log.rowCount(), MessageLog::kKept);
        QCOMPARE(log.index(0, MessageLog::kText).data().toString(), QStringLiteral("3"));
        const QString text = log.asText();
        QCOMPARE(text.count(u'\n'), MessageLog::kKept);
        QVERIFY(QRegularExpression(QStringLiteral("^\\d{4}-\\d\\d-\\d\\dT[0-9:.]+ Information: 3\n"))
                    .match(text)
                    .hasMatch());
    }
};

QTEST_MAIN(MessageLogTest)
#include "message_log_test.moc"
