// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/input_events.h"
#include "tests/widgets/test_registry.h"
#include "widgets/base/controls/provenance_stripe.h"
#include "widgets/base/theme.h"
#include "widgets/signal/signal_plot.h"

#include <qcustomplot.h>
#include <QDateTime>
#include <QImage>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>

#include <cmath>

using namespace teleta;
using namespace teleta::signal;
using teleta::test::turnWheel;

class SignalPlotTest : public QObject {
    Q_OBJECT

    std::unique_ptr<SignalPlot> m_view;
    std::shared_ptr<Series> m_force;
    std::shared_ptr<Series> m_angle;

    void draw() {
        m_view->refresh();
        QCoreApplication::processEvents();
    }
    [[nodiscard]] QPoint pointAt(double time_s, double share = 0.5) const {
        const QRect inside = m_view->plot()->axisRect()->rect();
        return {qRound(m_view->xOf(time_s)), inside.top() + qRound(share * inside.height())};
    }
    void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {}) {
        QCustomPlot* plot = m_view->plot();
        QTest::mousePress(plot, Qt::LeftButton, modifiers, from);
        QMouseEvent move(QEvent::MouseMove, to, plot->mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                         modifiers);
        QApplication::sendEvent(plot, &move);
        QTest::mouseRelease(plot, Qt::LeftButton, modifiers, to);
        draw();
    }

private slots:
    void init() {
        m_force = std::make_shared<Series>();
        m_angle = std::make_shared<Series>();
        for (int i = 0; i <= 20'000; ++i) {
            m_force->append(0.001 * i, std::sin(0.01 * i));
            m_angle->append(0.001 * i, 0.1 * i);
        }
        m_view = std::make_unique<SignalPlot>();
        m_view->resize(900, 500);
        m_view->setCurves(
            {{"force_n", "N", 1, m_force, nullptr, false}, {"q1", "rad", 2, m_angle, nullptr, false}});
        m_view->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_view.get()));
        draw();
    }
    void cleanup() { m_view.reset(); }

    void aPictureOfDataThatAreNotLiveHasALabelAboveThem() {
        const base::Figure live = m_view->figure();
        m_view->setProvenance(base::Provenance::simulated);
        const auto* stripe = m_view->findChild<base::ProvenanceStripe*>();
        QVERIFY(stripe != nullptr && stripe->isVisible());
        const base::Figure labelled = m_view->figure();
        QCOMPARE(labelled.size_px.width(), live.size_px.width());
        const int line_px = qRound(labelled.size_px.height() - live.size_px.height());
        QVERIFY(line_px > 0);
        QImage page(labelled.size_px.toSize(), QImage::Format_RGB32);
        page.fill(Qt::white);
        QPainter painter(&page);
        labelled.paint(painter);
        painter.end();
        const QColor violet =
            base::provenanceColour(base::Provenance::simulated, base::designedPalette(false));
        int violetAbove = 0, violetBelow = 0;
        for (int y = 0; y < page.height(); ++y)
            for (int x = 0; x < page.width(); ++x)
                if (page.pixelColor(x, y) == violet)
                    ++(y < line_px ? violetAbove : violetBelow);
        QVERIFY(violetAbove > 100);
        QCOMPARE(violetBelow, 0);
        m_view->setProvenance(base::Provenance::live);
        QVERIFY(!stripe->isVisible());
        QCOMPARE(m_view->figure().size_px, live.size_px);
    }

    void followsTheNewestSampleUntilItIsHeld() {
        QCOMPARE(m_view->to_s(), 20.0);
        m_force->append(21.0, 0.0);
        draw();
        QCOMPARE(m_view->to_s(), 21.0);
        QSignalSpy changed(m_view.get(), &SignalPlot::followingChanged);
        QTest::keyClick(m_view.get(), Qt::Key_Space);
        QCOMPARE(changed.count(), 1);
        m_force->append(22.0, 0.0);
        draw();
        QCOMPARE(m_view->to_s(), 21.0);
        QTest::keyClick(m_view.get(), Qt::Key_End);
        draw();
        QCOMPARE(m_view->to_s(), 22.0);
    }

    void whatGrowsIsFollowedAndNotALongerRecording() {
        auto live = std::make_shared<Series>();
        for (int i = 0; i <= 3000; ++i)
            live->append(0.001 * i, 0.0);
        m_view->setCurves({{"q1", "rad", 2, m_angle, nullptr, false, 0.0, false},
                           {"q1", "rad", 3, live, nullptr, false, 0.0, true}});
        m_view->setRange(-10.0, 0.0);
        m_view->setFollowing(true);
        draw();
        QCOMPARE(m_view->to_s(), 3.0);
        m_view->setCurves({{"q1", "rad", 2, m_angle, nullptr, false, 0.0, false}});
        draw();
        QCOMPARE(m_view->to_s(), 20.0);
    }

    void clockTimesAreDrawnAtTheirPlace() {
        const QDateTime begin(QDate(2026, 11, 30), QTime(9, 10, 14));
        const auto begin_s = static_cast<double>(begin.toSecsSinceEpoch());
        const QString label = m_view->plot()->xAxis->label();
        m_view->setCurves({{"q1", "rad", 2, m_angle, nullptr, false, begin_s, false}});
        m_view->setClockTime(true);
        m_view->showEverything();
        draw();
        QCOMPARE(m_view->from_s(), begin_s);
        QCOMPARE(m_view->to_s(), begin_s + 20.0);
        QVERIFY(m_view->plot()->xAxis->label() != label);
        QVERIFY(m_view->plot()->xAxis->tickVectorLabels().contains(QStringLiteral("09:10:20")));
        const auto data = m_view->plot()->graph(0)->data();
        QCOMPARE(data->constBegin()->key, begin_s);
        m_view->setRange(begin_s + 1.0, begin_s + 1.5);
        draw();
        QVERIFY(m_view->plot()->xAxis->tickVectorLabels().contains(QStringLiteral("09:10:15.200")));
        m_view->setClockTime(false);
        QCOMPARE(m_view->plot()->xAxis->label(), label);
    }

    void aUnitHasAnAxis() {
        QCOMPARE(m_view->axes().count(), std::size_t{2});
        QCPAxis* force = m_view->axes().axisOf("N");
        QCPAxis* angle = m_view->axes().axisOf("rad");
        QVERIFY(force && angle);
        QCOMPARE(force->axisType(), QCPAxis::atLeft);
        QCOMPARE(angle->axisType(), QCPAxis::atRight);
        QCOMPARE(force->label(), QString("N"));
        QVERIFY(force->range().contains(-1.0) && force->range().contains(1.0));
        QVERIFY2(angle->range().contains(2000.0), "it follows its own values");
        m_view->setCurves({{"q1", "rad", 2, m_angle, nullptr, false}});
        draw();
        QCOMPARE(m_view->axes().count(), std::size_t{1});
        m_view->setCurves({{"temperature_0_degc", "degC", 1, m_force, nullptr, false}});
        draw();
        QCOMPARE(m_view->axes().axisOf("degC")->label(), QStringLiteral("\u00b0C"));
    }

    void zerosHaveAnAxisToOne() {
        auto zeros = std::make_shared<Series>();
        for (int i = 0; i <= 100; ++i)
            zeros->append(0.2 * i, 0.0);
        m_view->setCurves({{"contact_type", "", 1, zeros, nullptr, false}});
        draw();
        const QCPRange range = m_view->axes().axisOf("")->range();
        QCOMPARE(range.lower, 0.0);
        QCOMPARE(range.upper, 1.0);
        zeros->append(20.2, 0.004); // values of their own are seen as large as before
        draw();
        m_view->showEverything();
        draw();
        QVERIFY(m_view->axes().axisOf("")->range().upper < 0.01);
    }

    void drawsFewPointsOfManySamples() {
        m_view->setRange(0.0, 20.0);
        draw();
        const int points = m_view->plot()->graph(0)->data()->size();
        QVERIFY2(points > 500 && points < 2 * m_view->width() + 10, qPrintable(QString::number(points)));
    }

    void theWheelZoomsAtThePointer() {
        m_view->setRange(0.0, 20.0);
        draw();
        const QPoint at = pointAt(5.0);
        QVERIFY(turnWheel(m_view->plot(), at, 2));
        draw();
        QVERIFY(m_view->span_s() < 20.0 / 1.5);
        QVERIFY(std::abs(m_view->xOf(5.0) - at.x()) < 2.0);
        QVERIFY(turnWheel(m_view->plot(), at, 1, Qt::ShiftModifier));
        draw();
        QVERIFY2(std::abs(m_view->span_s() - 20.0 / 1.25 / 1.25) < 1e-6, "Shift scrolls");
    }

    void theWheelOverAnAxisZoomsThatAxis() {
        QCPAxis* force = m_view->axes().axisOf("N");
        const double before = force->range().size();
        const QRect inside = m_view->plot()->axisRect()->rect();
        const double span = m_view->span_s();
        QVERIFY(turnWheel(m_view->plot(), QPointF(inside.left() - 4, inside.center().y()), 1));
        draw();
        QVERIFY(force->range().size() < before);
        QCOMPARE(m_view->span_s(), span);
        QVERIFY(m_view->axes().isFixed());
    }

    void aRectangleIsZoomedIntoAndEverythingShownAgain() {
        m_view->setRange(0.0, 20.0);
        draw();
        drag(pointAt(5.0, 0.25), pointAt(10.0, 0.75), Qt::ControlModifier);
        QVERIFY(std::abs(m_view->from_s() - 5.0) < 0.1);
        QVERIFY(std::abs(m_view->to_s() - 10.0) < 0.1);
        QVERIFY(m_view->axes().isFixed());
        QTest::mouseDClick(m_view->plot(), Qt::LeftButton, {}, pointAt(7.0));
        draw();
        QCOMPARE(m_view->from_s(), 0.0);
        QCOMPARE(m_view->to_s(), 20.0);
        QVERIFY(!m_view->axes().isFixed());
    }

    void aDragScrolls() {
        m_view->setRange(5.0, 10.0);
        draw();
        drag(pointAt(7.0), pointAt(6.0));
        QVERIFY(std::abs(m_view->from_s() - 6.0) < 0.05);
        QCOMPARE(m_view->isFollowing(), false);
    }

    void cursorsAreMovedByMouseAndKeys() {
        m_view->setRange(0.0, 10.0);
        draw();
        QVERIFY(!m_view->hasCursors());
        QTest::keyClick(m_view.get(), Qt::Key_C);
        QVERIFY(m_view->hasCursors());
        const auto before = *m_view->cursors_s();
        QVERIFY(before[0] > 0.0 && before[1] > before[0] && before[1] < 10.0);
        QSignalSpy moved(m_view.get(), &SignalPlot::cursorsChanged);
        drag(pointAt(before[0]), pointAt(1.0));
        QVERIFY(moved.count() > 0);
        QVERIFY(std::abs((*m_view->cursors_s())[0] - 1.0) < 0.05);
        QCOMPARE((*m_view->cursors_s())[1], before[1]);
        QTest::keyClick(m_view.get(), Qt::Key_Right, Qt::ControlModifier);
        QVERIFY((*m_view->cursors_s())[1] > before[1]);
        const double a = (*m_view->cursors_s())[0];
        QTest::keyClick(m_view.get(), Qt::Key_Left);
        QVERIFY((*m_view->cursors_s())[0] < a);
        QTest::keyClick(m_view.get(), Qt::Key_C);
        QVERIFY(!m_view->hasCursors());
    }

    void keysZoomAndScroll() {
        m_view->setRange(0.0, 10.0);
        QTest::keyClick(m_view.get(), Qt::Key_Plus);
        QCOMPARE(m_view->span_s(), 8.0);
        QTest::keyClick(m_view.get(), Qt::Key_Minus);
        QCOMPARE(m_view->span_s(), 10.0);
        QTest::keyClick(m_view.get(), Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(m_view->from_s(), 1.0);
        QTest::keyClick(m_view.get(), Qt::Key_Home);
        QCOMPARE(m_view->from_s(), 0.0);
        QCOMPARE(m_view->to_s(), 20.0);
    }

    void spectraHaveAPlotBelow() {
        QCOMPARE(m_view->plot()->axisRectCount(), 1);
        const auto spectrum = std::make_shared<const Spectrum>(*spectrumOf(*m_force, 0.0, 20.0, 1000.0));
        m_view->setCurves({{"force_n", "N", 1, m_force, spectrum, false}});
        draw();
        QCOMPARE(m_view->plot()->axisRectCount(), 2);
        QVERIFY(m_view->plot()->axisRect(1)->axis(QCPAxis::atLeft)->label().contains("(N)"));
        m_view->setDensity(true);
        QVERIFY(m_view->plot()->axisRect(1)->axis(QCPAxis::atLeft)->label().contains("Hz"));
        m_view->setCurves({{"force_n", "N", 1, m_force, nullptr, false}});
        draw();
        QCOMPARE(m_view->plot()->axisRectCount(), 1);
    }

    void thePictureIsOnWhiteAndTheViewKeepsItsColours() {
        const base::Figure figure = m_view->figure();
        QImage image(figure.size_px.toSize(), QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        figure.paint(painter);
        painter.end();
        int coloured = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                coloured += QColor(image.pixel(x, y)).saturation() > 100 ? 1 : 0;
        QVERIFY2(coloured > 200, qPrintable(QString::number(coloured)));
        QCOMPARE(m_view->axes().count(), std::size_t{2});
    }
};

static const test::Registration<SignalPlotTest> kSignalPlotTest;
#include "signal_plot_test.moc"
