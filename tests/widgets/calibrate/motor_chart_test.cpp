// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/backend/motors/measured_motor.h"
#include "tests/widgets/test_registry.h"
#include "widgets/base/theme.h"
#include "widgets/calibrate/motor_chart.h"

#include <qcustomplot.h>
#include <QImage>
#include <QPainter>
#include <QTest>

using namespace teleta;
using namespace teleta::calibrate;

namespace {

struct DarkChart {
    DarkChart() {
        chart.setPalette(base::designedPalette(true));
        chart.resize(1000, 400);
        chart.show();
        exposed = QTest::qWaitForWindowExposed(&chart);
        const motors::MotorRecording recording = test::measured(
            {.rise_s = 0.024, .fall_s = 0.033, .start = 0.163, .fullSpeed_Hz = 250.0, .bend = 0.8}, 1.0);
        fit = motors::fitMotor(recording).value();
        evidence = std::make_shared<const MotorChart::Evidence>(MotorChart::Evidence{recording, fit});
        motor.profile = fit.profile;
        chart.setMotor(2, motor, evidence, base::Provenance::simulated);
    }

    MotorChart chart;
    bool exposed = false;
    motors::MotorFit fit;
    motors::CalibratedMotor motor;
    std::shared_ptr<const MotorChart::Evidence> evidence;
};

/// As FigureExport draws it, on white.
QImage drawn(const base::Figure& figure) {
    QImage image(figure.size_px.toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    figure.paint(painter);
    return image;
}

/// Shares of light and of dark pixels.
std::pair<double, double> shares(const QImage& image) {
    double light = 0.0;
    double dark = 0.0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const int grey = qGray(image.pixel(x, y));
            light += grey > 230 ? 1.0 : 0.0;
            dark += grey < 80 ? 1.0 : 0.0;
        }
    }
    const double pixels = static_cast<double>(image.width()) * image.height();
    return {light / pixels, dark / pixels};
}

} // namespace

class MotorChartTest : public QObject {
    Q_OBJECT

private slots:
    void exportsForPaperWhateverTheTheme() {
        DarkChart shown;
        QVERIFY(shown.exposed);
        for (const base::Figure& figure : {shown.chart.curveFigure(), shown.chart.recordingFigure()}) {
            const auto [light, dark] = shares(drawn(figure));
            QVERIFY2(light > 0.5, qPrintable(figure.name));
            QVERIFY2(dark > 0.0 && dark < 0.2, qPrintable(figure.name));
        }
        // What is on the screen stays as it was.
        const auto [light, dark] = shares(shown.chart.grab().toImage());
        QVERIFY(dark > 0.5);
        QVERIFY(light < 0.2);
    }

    void itsTicksStayApartInALowChart() {
        DarkChart shown;
        for (const QSize size : {QSize(1000, 600), QSize(1000, 150), QSize(240, 300)}) {
            shown.chart.resize(size);
            (void)shown.chart.grab();
            for (QCustomPlot* plot : shown.chart.findChildren<QCustomPlot*>()) {
                plot->replot();
                const QFontMetrics metrics(plot->yAxis->tickLabelFont());
                const QVector<double> ticks = plot->yAxis->tickVector();
                QVERIFY(!ticks.isEmpty());
                for (qsizetype i = 1; i < ticks.size(); ++i)
                    QVERIFY2(plot->yAxis->coordToPixel(ticks[i - 1]) - plot->yAxis->coordToPixel(ticks[i]) >=
                                 metrics.ascent(),
                             qPrintable(QString::number(plot->height())));
                const QVector<double> across = plot->xAxis->tickVector();
                const QVector<QString> words = plot->xAxis->tickVectorLabels();
                for (qsizetype i = 1; i < across.size(); ++i)
                    QVERIFY(plot->xAxis->coordToPixel(across[i]) - plot->xAxis->coordToPixel(across[i - 1]) >=
                            0.5 * (metrics.horizontalAdvance(words[i - 1]) +
                                   metrics.horizontalAdvance(words[i])));
            }
        }
    }

    void keepsTheZoomWhenItIsExportedAndWhenTheThemeChanges() {
        DarkChart shown;
        auto* plot = shown.chart.findChildren<QCustomPlot*>().at(1);
        plot->xAxis->setRange(0.5, 0.75);
        (void)shown.chart.recordingFigure();
        QCOMPARE(plot->xAxis->range().lower, 0.5);
        shown.chart.setPalette(base::designedPalette(false));
        QCOMPARE(plot->xAxis->range().upper, 0.75);
        shown.chart.setMotor(2, shown.motor, shown.evidence, base::Provenance::simulated);
        QCOMPARE(plot->xAxis->range().upper, 0.75);
        QTest::mouseDClick(plot, Qt::LeftButton, {}, plot->rect().center());
        QCOMPARE(plot->xAxis->range().lower, shown.evidence->recording.time_s.front());
    }
};

namespace {
const test::Registration<MotorChartTest> registration;
}
#include "motor_chart_test.moc"
