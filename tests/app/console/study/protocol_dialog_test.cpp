// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/new_study_dialog.h"
#include "app/console/study/protocol_dialog.h"
#include "tests/support/form_labels.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>

using namespace teleta;
using console::ProtocolDialog;

namespace {

study::Protocol paper() {
    return study::paperProtocol().value();
}

} // namespace

class ProtocolDialogTest : public QObject {
    Q_OBJECT

private slots:
    void changesNothingThatNobodyTouches() {
        study::Protocol protocol = paper();
        protocol.stimulus_s = 1.23456789;
        protocol.responseLimit_s = 20.0 / 3.0;
        protocol.noise_dBA = 64.987;
        protocol.tasks[0].patterns[0].name = "circle, large \"and\" round";
        const ProtocolDialog dialog(protocol);
        const auto read = dialog.protocol();
        QVERIFY2(read.has_value(), read ? "" : read.error().message.c_str());
        QCOMPARE(read->stimulus_s, protocol.stimulus_s);
        QCOMPARE(read->responseLimit_s, protocol.responseLimit_s);
        QCOMPARE(read->noise_dBA, protocol.noise_dBA);
        QCOMPARE(read->tasks.size(), protocol.tasks.size());
        for (std::size_t t = 0; t < read->tasks.size(); ++t) {
            QCOMPARE(read->tasks[t].conditions, protocol.tasks[t].conditions);
            QCOMPARE(read->tasks[t].patterns.size(), protocol.tasks[t].patterns.size());
            for (std::size_t p = 0; p < read->tasks[t].patterns.size(); ++p) {
                QCOMPARE(read->tasks[t].patterns[p].letter, protocol.tasks[t].patterns[p].letter);
                QCOMPARE(read->tasks[t].patterns[p].name, protocol.tasks[t].patterns[p].name);
            }
        }
    }

    void saysBeforeAStudyIsMadeThatItsStimuliAreMissing() {
        ProtocolDialog dialog(paper());
        auto* make = dialog.findChild<QPushButton*>("makeStudy");
        auto* verdict = dialog.findChild<QLabel*>("verdict");
        QVERIFY(make->isEnabled());
        auto* id = dialog.findChild<QLineEdit*>("taskId");
        id->setText("taste");
        QVERIFY(!make->isEnabled());
        QVERIFY2(verdict->text().contains("taste.A.static"), qPrintable(verdict->text()));
        id->setText("shape");
        QVERIFY(make->isEnabled());
    }

    void restsAreReadAndCanBeChanged() {
        study::Protocol protocol = paper();
        protocol.rest = {10, 12.3456};
        ProtocolDialog dialog(protocol);
        auto* seconds = dialog.findChild<QDoubleSpinBox*>("rest_s");
        QCOMPARE(dialog.protocol()->rest.atLeast_s, 12.3456);
        QVERIFY(seconds->isEnabled());
        seconds->setValue(20.0);
        auto* every = dialog.findChild<QSpinBox*>("restEvery");
        every->setValue(15);
        QCOMPARE(dialog.protocol()->rest.everyTrials, std::size_t(15));
        QCOMPARE(dialog.protocol()->rest.atLeast_s, 20.0);
        every->setValue(0);
        QVERIFY(!seconds->isEnabled());
        QCOMPARE(dialog.protocol()->rest.everyTrials, std::size_t(0));
    }

    void everyLetterOfItsLabelsReachesAField() {
        const ProtocolDialog dialog(paper());
        QCOMPARE(test::labelsWithBareMnemonic(dialog), QStringList());
        const console::NewStudyDialog form(paper(), QStringLiteral("study"));
        QCOMPARE(test::labelsWithBareMnemonic(form), QStringList());
    }

    void takesWhatIsTyped() {
        ProtocolDialog dialog(paper());
        auto* patterns = dialog.findChild<QPlainTextEdit*>("taskPatterns");
        patterns->selectAll();
        QTest::keyClicks(patterns, "A one, two");
        QTest::keyClick(patterns, Qt::Key_Return);
        QTest::keyClicks(patterns, "B  three ");
        auto* stimulus = dialog.findChild<QDoubleSpinBox*>("stimulus_s");
        stimulus->setValue(1.5);
        const auto read = dialog.protocol();
        QVERIFY2(read.has_value(), read ? "" : read.error().message.c_str());
        QCOMPARE(read->stimulus_s, 1.5);
        QCOMPARE(read->tasks[0].patterns.size(), std::size_t(2));
        QCOMPARE(read->tasks[0].patterns[0].name, std::string("one, two"));
        QCOMPARE(read->tasks[0].patterns[1].name, std::string("three"));
    }
};

QTEST_MAIN(ProtocolDialogTest)
#include "protocol_dialog_test.moc"
