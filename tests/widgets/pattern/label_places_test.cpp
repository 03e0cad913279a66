// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/pattern/timeline/label_places.h"

#include <QTest>

using namespace teleta;
using namespace teleta::pattern;

/// Labels of objects that begin together stand below each other.
class LabelPlacesTest : public QObject {
    Q_OBJECT

private slots:
    void aLabelGoesBelowThoseThatAreThere() {
        LabelPlaces places;
        const QRectF first(10.0, 0.0, 40.0, 12.0);
        QCOMPARE(places.place(first, 60.0), std::optional(first));
        QCOMPARE(places.place(first, 60.0), std::optional(first.translated(0.0, 12.0)));
        QCOMPARE(places.place(first.translated(20.0, 0.0), 60.0),
                 std::optional(first.translated(20.0, 24.0)));
        QCOMPARE(places.place(first.translated(100.0, 0.0), 60.0),
                 std::optional(first.translated(100.0, 0.0)));
    }

    void oneWithoutAPlaceIsNotWritten() {
        LabelPlaces places;
        const QRectF first(10.0, 0.0, 40.0, 12.0);
        QVERIFY(places.place(first, 20.0));
        QVERIFY(!places.place(first, 20.0));
        // It has taken nothing.
        QVERIFY(places.place(first.translated(60.0, 0.0), 20.0));
    }
};

static const test::Registration<LabelPlacesTest> registration;
#include "label_places_test.moc"
