// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/device_strip.h"

#include <QSignalSpy>
#include <QTest>

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
