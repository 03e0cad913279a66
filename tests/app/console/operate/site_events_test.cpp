// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/operate/site/site_events.h"

#include <QTest>

using namespace teleta;
using console::isNotice;
using console::siteEventText;
using site_link::RemoteEvent;

/// What a site tells, in words.
class SiteEventsTest : public QObject {
    Q_OBJECT

private slots:
    void eachCodeHasASentence_data() {
        QTest::addColumn<int>("severity");
        QTest::addColumn<QString>("code");
        QTest::addColumn<QString>("source");
        QTest::addColumn<QString>("sentence");
        QTest::addColumn<bool>("notice");
        QTest::newRow("console") << 0 << "console"
                                 << "b"
                                 << "lab: the console b is there." << false;
        QTest::newRow("refused") << 2 << "console_refused"
                                 << "b"
                                 << "lab cannot listen to the console b: why" << true;
        QTest::newRow("name") << 1 << "name_in_use"
                              << "b"
                              << "lab: another program named b is connected; it is ignored." << true;
        QTest::newRow("out") << 1 << "kept_out"
                             << ""
                             << "lab kept a program out: why" << true;
        QTest::newRow("granted") << 0 << "granted"
                                 << "b"
                                 << "lab: b is in control." << false;
        QTest::newRow("free") << 0 << "free"
                              << "b"
                              << "lab: b is no longer in control." << false;
        QTest::newRow("stop") << 1 << "stop"
                              << "b"
                              << "lab: STOP is held by b." << false;
        QTest::newRow("withdrawn") << 0 << "stop_withdrawn"
                                   << "b"
                                   << "lab: b withdrew STOP." << false;
        QTest::newRow("fault") << 2 << "fault"
                               << "arm"
                               << "lab: fault of arm: why" << true;
        QTest::newRow("device live") << 0 << "device"
                                     << "pad"
                                     << "lab: pad is live." << false;
        QTest::newRow("device") << 1 << "device"
                                << "pad"
                                << "lab: pad: why" << true;
        QTest::newRow("recording") << 0 << "recording"
                                   << ""
                                   << "lab: why" << false;
        QTest::newRow("recording failed") << 2 << "recording_failed"
                                          << ""
                                          << "lab: its recording failed: why" << true;
        QTest::newRow("keys") << 1 << "keys"
                              << ""
                              << "lab: its keys: why" << true;
        // A site that is newer than this program.
        QTest::newRow("unknown") << 1 << "flood"
                                 << "cellar"
                                 << "lab: cellar: why" << true;
    }
    void eachCodeHasASentence() {
        QFETCH(int, severity);
        QFETCH(QString, code);
        QFETCH(QString, source);
        QFETCH(QString, sentence);
        QFETCH(bool, notice);
        const RemoteEvent event{0, severity, source.toStdString(), code.toStdString(), "why"};
        QCOMPARE(siteEventText("lab", event), sentence);
        QCOMPARE(isNotice(event), notice);
    }
};

QTEST_GUILESS_MAIN(SiteEventsTest)
#include "site_events_test.moc"
