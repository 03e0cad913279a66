// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/test_registry.h"
#include "widgets/base/controls/provenance_stripe.h"
#include "widgets/base/theme.h"

#include <QApplication>
#include <QPainter>
#include <QPicture>
#include <QTest>

using namespace teleta::base;

/// How views say that their data are not live.
class ProvenanceTest : public QObject {
    Q_OBJECT

private slots:
    void aViewHasAStripeInTheColourOfItsProvenance() {
        QWidget view;
        view.resize(200, 100);
        view.show();
        showProvenance(&view, Provenance::live);
        QVERIFY(view.findChild<ProvenanceStripe*>() == nullptr);
        showProvenance(&view, Provenance::simulated);
        const StatusColours& colours = statusColours(view.palette());
        const auto* stripe = view.findChild<ProvenanceStripe*>();
        QCOMPARE(stripe->size(), QSize(200, stripe->height()));
        QVERIFY(stripe->height() >= 2 && stripe->height() <= 4);
        QCOMPARE(stripe->accessibleName(), QString("SIMULATED"));
        QCOMPARE(view.grab().toImage().pixelColor(100, 1), colours.simulated);
        view.resize(300, 100);
        QCOMPARE(stripe->width(), 300);
        showProvenance(&view, Provenance::recorded);
        QCOMPARE(view.grab().toImage().pixelColor(290, 1), colours.recorded);
        showProvenance(&view, Provenance::recordedSimulation);
        QCOMPARE(view.grab().toImage().pixelColor(290, 1), colours.simulated);
        showProvenance(&view, Provenance::live);
        QVERIFY(stripe->isHidden());
    }

    /// A picture that leaves the program has the word in it.
    void aPictureThatIsSavedHasTheBadge() {
        const QRectF line(0, 0, 400, 30);
        QImage image(400, 30, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPicture vector;
        QPixmap screen(400, 30);
        for (QPaintDevice* device : std::initializer_list<QPaintDevice*>{&image, &vector}) {
            QPainter painter(device);
            QVERIFY(!paintsScreen(painter));
            QVERIFY(
                paintProvenance(painter, line, Provenance::simulated, QApplication::palette(), 4.0).width() <
                line.width() - 50.0);
            QCOMPARE(paintProvenance(painter, line, Provenance::live, QApplication::palette(), 4.0), line);
        }
        QPainter painter(&screen);
        QVERIFY(paintsScreen(painter));
        QCOMPARE(paintProvenance(painter, line, Provenance::simulated, QApplication::palette(), 4.0), line);
        QCOMPARE(image.pixelColor(395, 15), statusColours(QApplication::palette()).simulated);
    }
};

static const teleta::test::Registration<ProvenanceTest> registration;

#include "provenance_test.moc"
