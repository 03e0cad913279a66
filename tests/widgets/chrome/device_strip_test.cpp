// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/device_strip.h"

#include <QApplication>
#include <QHelpEvent>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>

using teleta::base::Provenance;
using teleta::chrome::DeviceReading;
using teleta::chrome::DeviceStrip;
using teleta::core::DeviceState;

/// The devices in the status bar.
class DeviceStripTest : public QObject {
    Q_OBJECT

    static DeviceReading live(const QString& name) {
        DeviceReading reading;
        reading.name = name;
        reading.state = DeviceState::live;
        reading.rate_Hz = 199.7;
        return reading;
    }

private slots:
    void saysNameWordRateAndLosses() {
        DeviceStrip strip;
        DeviceReading reading = live("array");
        reading.lost = 1234;
        strip.setReadings({reading});
        const QString text = strip.text(0);
        for (const char* part : {"array", "live", "200", "Hz", "1.23", "lost"})
            QVERIFY2(text.contains(QLatin1String(part)), qPrintable(text));
        QVERIFY(strip.accessibleDescription().contains("array"));
    }

    void aRecordingIsPlayingAndNotLive() {
        DeviceStrip strip;
        DeviceReading reading = live("run");
        for (const Provenance provenance : {Provenance::recorded, Provenance::recordedSimulation}) {
            reading.provenance = provenance;
            strip.setReadings({reading});
            QVERIFY2(strip.text(0).contains("playing") && !strip.text(0).contains("live"),
                     qPrintable(strip.text(0)));
        }
    }

    void saysThatTheSensorDoesNotCountItsLosses() {
        DeviceStrip strip;
        strip.resize(400, 40);
        strip.show();
        QVERIFY(QTest::qWaitForWindowExposed(&strip));
        const auto toolTip = [&strip](const DeviceReading& reading) {
            strip.setReadings({reading});
            const QPoint inside(5, strip.height() / 2);
            QHelpEvent help(QEvent::ToolTip, inside, strip.mapToGlobal(inside));
            QApplication::sendEvent(&strip, &help);
            return QToolTip::text();
        };
        DeviceReading skin = live("skin");
        QVERIFY2(toolTip(skin).contains("Frames lost: 0"), qPrintable(QToolTip::text()));
        skin.countsLosses = false;
        QVERIFY2(toolTip(skin).contains("Frames lost: not counted by the sensor"),
                 qPrintable(QToolTip::text()));
        skin.lost = 3; // here, after they had arrived
        QVERIFY2(toolTip(skin).contains("Frames lost: 3"), qPrintable(QToolTip::text()));
    }

    void saysHowLongAfterATouchTheSkinFeltIt() {
        DeviceStrip strip;
        DeviceReading reading = live("bracelet");
        strip.setReadings({reading});
        QVERIFY(!strip.text(0).contains("skin"));
        reading.touchToSkin_s = 0.0032;
        strip.setReadings({reading});
        QVERIFY2(strip.text(0).contains("touch to skin 3.20 ms"), qPrintable(strip.text(0)));
    }

    void saysHowOldStaleDataAre() {
        DeviceStrip strip;
        DeviceReading reading = live("array");
        reading.state = DeviceState::stale;
        reading.age_s = 12.0;
        strip.setReadings({reading});
        QVERIFY2(strip.text(0).contains("12 s"), qPrintable(strip.text(0)));
        QVERIFY(!strip.text(0).contains("Hz"));
    }

    void doesNotFlickerWhileARateMovesLessThanItsResolution() {
        DeviceStrip strip;
        strip.setReadings({live("array")});
        const QString before = strip.text(0);
        for (const double rate_Hz : {199.9, 200.3, 199.8}) {
            DeviceReading reading = live("array");
            reading.rate_Hz = rate_Hz;
            strip.setReadings({reading});
            QCOMPARE(strip.text(0), before);
        }
    }

    void activatesTheDeviceThatIsClicked() {
        DeviceStrip strip;
        strip.setReadings({live("first"), live("second")});
        strip.resize(strip.sizeHint());
        QSignalSpy activations(&strip, &DeviceStrip::deviceActivated);
        QTest::mouseClick(&strip, Qt::LeftButton, {}, QPoint(strip.width() - 4, strip.height() / 2));
        QCOMPARE(activations.size(), 1);
        QCOMPARE(activations[0][0].toInt(), 1);
        QTest::mouseClick(&strip, Qt::LeftButton, {}, QPoint(4, strip.height() / 2));
        QCOMPARE(activations[1][0].toInt(), 0);
    }

    void marksSimulatedAndRecordedData() {
        DeviceStrip plain;
        plain.setReadings({live("array")});
        DeviceReading reading = live("array");
        reading.provenance = Provenance::simulated;
        DeviceStrip marked;
        marked.setReadings({reading});
        QVERIFY(marked.sizeHint().width() > plain.sizeHint().width());
    }

    void saysLessWhereThereIsLittleRoom() {
        DeviceStrip strip;
        DeviceReading bracelet = live("bracelet");
        bracelet.touchToSkin_s = 0.0032;
        DeviceReading lost = live("joints of the arm");
        lost.state = DeviceState::lost;
        lost.age_s = 12.0;
        strip.show(); // a hidden one is told of its size later
        strip.setReadings({live("array"), lost, bracelet});
        strip.resize(strip.sizeHint());
        for (int i = 0; i < 3; ++i)
            QCOMPARE(strip.shownText(i), strip.text(i));
        strip.resize(strip.width() - 1, strip.height());
        QVERIFY(!strip.shownText(2).contains("skin"));
        QVERIFY(strip.shownText(2).contains("Hz"));
        QString before = strip.shownText(2);
        for (int width = strip.width(); width > 160; width -= 7) {
            strip.resize(width, strip.height());
            QVERIFY(strip.shownText(2).size() <= before.size());
            before = strip.shownText(2);
            // What is lost is told as long as names are.
            QVERIFY(strip.shownText(1).contains("12 s") || strip.shownText(1).endsWith(QChar(0x2026)));
            const QImage picture = strip.grab().toImage();
            const QColor background = strip.palette().color(QPalette::Window);
            for (int y = 0; y < picture.height(); ++y)
                QVERIFY2(picture.pixelColor(picture.width() - 1, y) == background, qPrintable(before));
        }
        QVERIFY(before.endsWith(QChar(0x2026)));
        QVERIFY(strip.text(2).contains("touch to skin 3.20 ms"));
        QVERIFY(strip.accessibleDescription().contains("touch to skin 3.20 ms"));
        strip.resize(strip.sizeHint());
        QCOMPARE(strip.shownText(2), strip.text(2));
    }

    void theWordForWhatIsNotLiveIsCutOnlyAfterTheLatencies() {
        DeviceReading reading = live("array");
        reading.provenance = Provenance::simulated;
        DeviceStrip without;
        without.show();
        without.setReadings({reading});
        without.resize(without.sizeHint());
        reading.touchToSkin_s = 0.0032;
        DeviceStrip strip;
        strip.show();
        strip.setReadings({reading});
        strip.resize(without.size());
        QVERIFY(strip.shownText(0) != strip.text(0));
        QVERIFY(strip.grab().toImage() == without.grab().toImage());
    }

    void aNameIsWholeAsLongAsAnyWordIsThere() {
        DeviceStrip strip;
        DeviceReading arm = live("teleoperation");
        arm.provenance = Provenance::simulated;
        DeviceReading bracelet = live("Bracelet");
        bracelet.provenance = Provenance::simulated;
        strip.show();
        strip.setReadings({arm, bracelet});
        QVERIFY2(!strip.text(0).contains("lost"), "nothing is");
        const int whole = strip.sizeHint().width();
        strip.resize(whole - 1, strip.height());
        int least = whole;
        while (least > 0 && strip.shownText(0).contains("teleoperation"))
            strip.resize(--least, strip.height());
        // The names and what stands before them without a word: glyph and margins.
        const int names = strip.fontMetrics().horizontalAdvance("teleoperation") +
                          strip.fontMetrics().horizontalAdvance("Bracelet");
        QVERIFY2(least < names + 12 * strip.fontMetrics().height() / 2,
                 qPrintable(QStringLiteral("%1 for %2").arg(least).arg(names)));
    }

    void whatIsLostIsToldLongerThanTheName() {
        DeviceStrip strip;
        DeviceReading camera = live("a camera with a long name");
        camera.lost = 103;
        strip.show();
        strip.setReadings({camera, live("joints")});
        strip.resize(strip.sizeHint());
        while (!strip.shownText(0).contains(QChar(0x2026)) && strip.width() > 0)
            strip.resize(strip.width() - 1, strip.height());
        for (int step = 0; step < 20; ++step) {
            QVERIFY2(strip.shownText(0).endsWith("103 lost"), qPrintable(strip.shownText(0)));
            QVERIFY(strip.shownText(1).startsWith("joints")); // a short one makes no room
            strip.resize(strip.width() - 1, strip.height());
        }
        QVERIFY(strip.text(0).contains("a camera with a long name"));
    }

    void aLongNameIsCutInTheMiddleBeforeARateGoes() {
        DeviceStrip strip;
        const QString recording =
            QStringLiteral("20261130T091014Z-teleoperation (Teleoperation: unknown objects)");
        strip.show();
        strip.setReadings({live(recording), live("Bracelet")});
        strip.resize(strip.sizeHint());
        const QString ellipsis(QChar(0x2026));
        while (!strip.shownText(0).contains(ellipsis) && strip.width() > 0)
            strip.resize(strip.width() - 1, strip.height());
        QString shortest;
        for (; strip.shownText(0).contains("Hz") && strip.width() > 0;
             strip.resize(strip.width() - 1, strip.height())) {
            shortest = strip.shownText(0);
            QVERIFY2(shortest.startsWith("202611") && strip.shownText(1).contains("Hz"),
                     qPrintable(shortest));
        }
        QVERIFY2(shortest.section(QStringLiteral("  "), 0, 0).size() == 16, qPrintable(shortest));
    }

    void longNamesThatBeginAlikeStayApart() {
        DeviceStrip strip;
        const QString recording =
            QStringLiteral("20261130T091014Z-teleoperation (Teleoperation: unknown objects)");
        strip.show();
        strip.setReadings({live(recording), live(recording + ": joints")});
        strip.resize(strip.sizeHint());
        while (!strip.shownText(0).contains(QChar(0x2026)) && strip.width() > 0)
            strip.resize(strip.width() - 1, strip.height());
        for (int step = 0; step < 20; ++step) {
            QVERIFY2(strip.shownText(0).startsWith("20261130"), qPrintable(strip.shownText(0)));
            QVERIFY2(strip.shownText(1).contains(": joints"), qPrintable(strip.shownText(1)));
            QVERIFY(strip.shownText(0) != strip.shownText(1));
            strip.resize(strip.width() - 10, strip.height());
        }
    }

    void hasADefinedTextForAnIndexThatIsNotThere() {
        DeviceStrip strip;
        QCOMPARE(strip.text(0), QString());
        strip.setReadings({live("array")});
        strip.setReadings({});
        QCOMPARE(strip.text(0), QString());
        QVERIFY(!strip.grab().isNull());
    }
};

QTEST_MAIN(DeviceStripTest)
#include "device_strip_test.moc"
