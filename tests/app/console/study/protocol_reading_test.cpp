// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/forms/protocol_reading.h"

#include <QApplication>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTextBrowser>

using namespace teleta;
using console::ProtocolReading;

/// A protocol in words.
class ProtocolReadingTest : public QObject {
    Q_OBJECT

    static QString textOf(const study::Protocol& protocol) {
        const ProtocolReading reading(protocol);
        return reading.findChild<QTextBrowser*>("protocolText")->toPlainText().simplified();
    }

private slots:
    void thePapersProtocolSaysWhatThePaperSays() {
        const QString text = textOf(study::paperProtocol().value());
        for (const char* part : {"lasts 2 s at most", "within 10 s of its onset",
                                 "Each stimulus 3 time(s). The right answer is shown",
                                 "Each stimulus 5 time(s). The right answer is not shown", "Pink, 65 dBA",
                                 "Object shape", "A circle, B rectangle, C triangle, D arc, E line, F point",
                                 "Object stiffness", "A sponge, B rubber sponge, C rubber, D wood, E metal",
                                 "static, dynamic", "110 for each participant"})
            QVERIFY2(text.contains(QLatin1String(part)), qPrintable(QLatin1String(part) + "\n" + text));
    }

    void everyProtocolThatComesWithTheProgramIsReadable() {
        const auto all = study::builtInProtocols();
        QVERIFY(all.has_value());
        for (const study::Protocol& protocol : *all) {
            const QString text = textOf(protocol);
            QVERIFY2(text.contains(QString::fromStdString(protocol.name)), qPrintable(text));
            QVERIFY2(!text.contains(u'%') || text.contains(QLatin1String(" %")), qPrintable(text));
        }
    }

    void showsTextsAsTheyAreWithRulesAndRests() {
        study::Protocol protocol = study::paperProtocol().value();
        protocol.name = "<b>mine</b>";
        protocol.rest = {.everyTrials = 12, .atLeast_s = 30.0};
        protocol.practice.repetitions = 0;
        protocol.exclusions = {{"hasty", study::ExclusionKind::responseTimeBelow_s, 0.2},
                               {"absent", study::ExclusionKind::timeoutsShareAbove, 0.25}};
        const QString text = textOf(protocol);
        for (const char* part : {"<b>mine</b>", "After every 12 trial(s), at least 30 s.", "Practice None.",
                                 "hasty Trials answered earlier than 0.2 s.",
                                 "absent Sessions in which more than 25 % of the trials have no answer."})
            QVERIFY2(text.contains(QLatin1String(part)), qPrintable(QLatin1String(part) + "\n" + text));
    }

    void offersAStudyAndACopyToChange_data() {
        QTest::addColumn<QString>("button");
        QTest::newRow("study") << QStringLiteral("makeStudy");
        QTest::newRow("copy") << QStringLiteral("changeProtocol");
    }
    void offersAStudyAndACopyToChange() {
        QFETCH(QString, button);
        ProtocolReading reading(study::paperProtocol().value());
        QSignalSpy studies(&reading, &ProtocolReading::studyRequested);
        QSignalSpy copies(&reading, &ProtocolReading::changeRequested);
        reading.show();
        QVERIFY(QTest::qWaitForWindowExposed(&reading));
        QTest::mouseClick(reading.findChild<QPushButton*>(button), Qt::LeftButton);
        QCOMPARE(studies.size(), button == QLatin1String("makeStudy") ? 1 : 0);
        QCOMPARE(copies.size(), button == QLatin1String("changeProtocol") ? 1 : 0);
        QVERIFY(!reading.isVisible());
    }
};

QTEST_MAIN(ProtocolReadingTest)
#include "protocol_reading_test.moc"
