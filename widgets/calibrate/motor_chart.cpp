// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibrate/motor_chart.h"

#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/numbers/unit_title.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/plot/plot_style.h"

#include <QBoxLayout>
#include <qcustomplot.h>

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace teleta::calibrate {

namespace {

constexpr double kInterval95 = 1.96;
constexpr double kLowChart_em = 12.0;
/// Charts of less width stand one above the other.
constexpr double kNarrowCharts_em = 30.0;

QString row(std::initializer_list<double> values) {
    QString text;
    for (const double value : values) {
        if (!text.isEmpty())
            text += QLatin1Char(',');
        text += base::csvNumber(value);
    }
    return text + QLatin1Char('\n');
}

QString curveCsv(const motors::CalibratedMotor& motor, const MotorChart::Evidence* evidence) {
    QString text = QStringLiteral("drive,speed_hz,standard_error_hz\n");
    if (evidence != nullptr) {
        for (const motors::SpeedLevel& level : evidence->fit.levels)
            text += row({level.drive, level.speed_Hz, level.error_Hz});
        return text;
    }
    for (const pattern::SpeedPoint& point : motor.profile.curve)
        text += row({point.drive, point.speed_Hz, 0.0});
    return text;
}

QString recordingCsv(const MotorChart::Evidence& evidence) {
    QString text = QStringLiteral("time_s,commanded,speed_hz,model_hz\n");
    const motors::MotorRecording& recording = evidence.recording;
    for (std::size_t i = 0; i < recording.size(); ++i)
        text += row({recording.time_s[i], recording.drive[i],
                     recording.isKnown(i) ? recording.speed_Hz[i] : qQNaN(), evidence.fit.predicted_Hz[i]});
    return text;
}

QCPGraph* addGraph(QCustomPlot* plot, const QPen& pen, const QString& name) {
    QCPGraph* graph = plot->addGraph();
    graph->setPen(pen);
    graph->setName(name);
    graph->setAdaptiveSampling(true);
    return graph;
}

} // namespace

MotorChart::MotorChart(QWidget* parent)
    : SizedView(parent, {60, 18}, {10, 9})
    , m_layout(new QBoxLayout(QBoxLayout::LeftToRight, this))
    , m_curve(new QCustomPlot(this))
    , m_recording(new QCustomPlot(this)) {
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->addWidget(m_curve, 2);
    m_layout->addWidget(m_recording, 3);
    for (QCustomPlot* chart : {m_curve, m_recording})
        plot::keepTicksApart(*chart);
    m_recording->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    m_recording->axisRect()->setRangeZoom(Qt::Horizontal);
    m_recording->axisRect()->setRangeDrag(Qt::Horizontal);
    connect(m_recording, &QCustomPlot::mouseDoubleClick, this, &MotorChart::showAll);
    const auto addMenu = [this](QCustomPlot* plot, base::Figure (MotorChart::*make)()) {
        auto* exporter = new base::FigureExport(plot, [this, make] { return (this->*make)(); });
        connect(exporter, &base::FigureExport::failed, this, &MotorChart::exportFailed);
        exporter->setContextMenu();
    };
    addMenu(m_curve, &MotorChart::curveFigure);
    addMenu(m_recording, &MotorChart::recordingFigure);
    restyle(palette());
    base::onChange(this, &MotorChart::draw, {QEvent::LanguageChange});
    base::onChange(this, [this] { restyle(palette()); }, {QEvent::PaletteChange, QEvent::FontChange});
}

void MotorChart::setMotor(std::size_t number, const motors::CalibratedMotor& motor,
                          std::shared_ptr<const Evidence> evidence, base::Provenance provenance) {
    const bool isOther = evidence != m_evidence;
    m_number = number;
    m_motor = motor;
    m_evidence = std::move(evidence);
    m_provenance = provenance;
    draw();
    if (isOther)
        showAll();
}

void MotorChart::draw() {
    drawCurve();
    drawRecording();
    m_curve->setAccessibleName(tr("Speed of motor %1 over its drive").arg(m_number + 1));
    m_recording->setAccessibleName(tr("Recording of motor %1, and the model").arg(m_number + 1));
}

void MotorChart::resizeEvent(QResizeEvent* event) {
    SizedView::resizeEvent(event);
    const bool isNarrow = width() < base::em(this, kNarrowCharts_em);
    m_layout->setDirection(isNarrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    m_layout->setStretch(0, isNarrow ? 3 : 2);
    draw(); // the texts wrap
}

/// With line breaks, so that it stays inside the axes.
QString MotorChart::wrapped(const QCustomPlot& chart, const QString& text) const {
    // Before the chart is laid out its axes have no size yet.
    const int axes_px = base::em(this, 5);
    const double room_px = std::max(0.92 * (chart.width() - axes_px), 8.0 * base::em(this, 1));
    QStringList lines;
    for (const QString& paragraph : text.split(QLatin1Char('\n'))) {
        QTextLayout layout(paragraph, font()); // knows where each language may be broken
        layout.beginLayout();
        for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
            line.setLineWidth(room_px);
            lines << paragraph.mid(line.textStart(), line.textLength()).trimmed();
        }
        layout.endLayout();
    }
    return lines.join(QLatin1Char('\n'));
}

/// Above the grid lines.
QCPItemText* MotorChart::addText(QCustomPlot* chart, const QColor& colour) const {
    auto* text = new QCPItemText(chart);
    text->position->setType(QCPItemPosition::ptAxisRectRatio);
    text->setColor(colour);
    text->setBrush(m_colours.color(QPalette::Base));
    text->setPadding(QMargins(4, 2, 4, 2));
    text->setFont(font());
    return text;
}

void MotorChart::drawCurve() {
    const QPalette& colours = m_colours;
    m_curve->clearPlottables();
    m_curve->clearItems();
    const pattern::MotorProfile& profile = m_motor.profile;
    const bool assumed = m_motor.lagFrom == motors::CalibratedMotor::Origin::assumed;
    m_curve->xAxis->setLabel(base::titleWithUnit(tr("drive"), QStringLiteral("%")));
    m_curve->yAxis->setLabel(base::titleWithUnit(tr("speed"), QStringLiteral("Hz")));
    double highest_Hz = 50.0;

    const double low = m_evidence ? m_evidence->fit.startLow : profile.startDrive - 2.0 * m_motor.startError;
    const double high =
        m_evidence ? m_evidence->fit.startHigh : profile.startDrive + 2.0 * m_motor.startError;
    auto* band = new QCPItemRect(m_curve);
    band->setPen(Qt::NoPen);
    band->setBrush(base::translucent(base::statusColours(colours).stale, 0.35F));
    band->topLeft->setTypeY(QCPItemPosition::ptAxisRectRatio);
    band->bottomRight->setTypeY(QCPItemPosition::ptAxisRectRatio);
    const double narrowest = 0.004;
    const double middle = 0.5 * (low + high);
    const double half = std::max(0.5 * (high - low), 0.5 * narrowest);
    band->topLeft->setCoords(100.0 * (middle - half), 0.0);
    band->bottomRight->setCoords(100.0 * (middle + half), 1.0);

    QCPGraph* curve =
        addGraph(m_curve,
                 QPen(assumed ? colours.color(QPalette::PlaceholderText) : colours.color(QPalette::Highlight),
                      2.0, assumed ? Qt::DashLine : Qt::SolidLine),
                 assumed ? tr("assumed") : tr("curve"));
    curve->addData(0.0, 0.0);
    curve->addData(100.0 * profile.startDrive, 0.0);
    curve->addData(100.0 * profile.startDrive + 1e-6, steadySpeed_Hz(profile, profile.startDrive));
    for (const pattern::SpeedPoint& point : profile.curve) {
        if (point.drive > profile.startDrive)
            curve->addData(100.0 * point.drive, point.speed_Hz);
        highest_Hz = std::max(highest_Hz, point.speed_Hz);
    }
    if (m_evidence) {
        QCPGraph* levels = addGraph(m_curve, QPen(colours.color(QPalette::Text)), tr("measured"));
        levels->setLineStyle(QCPGraph::lsNone);
        levels->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, 5.0));
        auto* bars = new QCPErrorBars(m_curve->xAxis, m_curve->yAxis);
        bars->setDataPlottable(levels);
        bars->setPen(QPen(colours.color(QPalette::Text)));
        bars->removeFromLegend();
        for (const motors::SpeedLevel& level : m_evidence->fit.levels) {
            levels->addData(100.0 * level.drive, level.speed_Hz);
            bars->addData(kInterval95 * level.error_Hz);
        }
    }
    auto* full = new QCPItemStraightLine(m_curve);
    full->setPen(QPen(colours.color(QPalette::PlaceholderText), 1.0, Qt::DotLine));
    full->point1->setCoords(100.0 * profile.fullDrive, 0.0);
    full->point2->setCoords(100.0 * profile.fullDrive, 1.0);
    QCPItemText* text = addText(m_curve, colours.color(QPalette::Text));
    text->position->setCoords(0.03, 0.03);
    text->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
    text->setTextAlignment(Qt::AlignLeft);
    QString words = assumed ? tr("Motor %1: curve and lag are assumed").arg(m_number + 1)
                            : tr("Motor %1").arg(m_number + 1);
    if (m_evidence)
        words += QLatin1Char('\n') + tr("%1 % of the variance, residual %2 Hz")
                                         .arg(base::fixedDigits(100.0 * m_evidence->fit.explained, 2))
                                         .arg(base::fixedDigits(m_evidence->fit.residual_Hz, 2));
    text->setText(wrapped(*m_curve, words));
    const bool isHalf = m_layout->direction() == QBoxLayout::TopToBottom;
    text->setVisible(height() / (isHalf ? 2 : 1) >= base::em(this, kLowChart_em)); // else it hides the curve
    m_curve->xAxis->setRange(0.0, 102.0);
    m_curve->yAxis->setRange(0.0, 1.25 * highest_Hz);
    m_curve->replot(QCustomPlot::rpQueuedReplot);
}

void MotorChart::drawRecording() {
    const QPalette& colours = m_colours;
    m_recording->clearPlottables();
    m_recording->clearItems();
    m_recording->xAxis->setLabel(base::titleWithUnit(tr("time"), QStringLiteral("s")));
    m_recording->yAxis->setLabel(base::titleWithUnit(tr("speed"), QStringLiteral("Hz")));
    if (!m_live.empty()) {
        drawLive();
        return;
    }
    m_recording->legend->setVisible(m_evidence != nullptr);
    if (!m_evidence) {
        QCPItemText* text = addText(m_recording, colours.color(QPalette::PlaceholderText));
        text->position->setCoords(0.5, 0.5);
        text->setText(
            wrapped(*m_recording, tr("No recording of this motor yet: measure it, or open a recording.")));
        m_recording->xAxis->setRange(0.0, 10.0);
        m_recording->yAxis->setRange(0.0, 300.0);
        m_recording->replot(QCustomPlot::rpQueuedReplot);
        return;
    }
    const motors::MotorRecording& recording = m_evidence->recording;
    const std::vector<double>& predicted_Hz = m_evidence->fit.predicted_Hz;
    QCPGraph* measured =
        addGraph(m_recording, QPen(colours.color(QPalette::PlaceholderText), 1.0),
                 m_provenance == base::Provenance::simulated ? tr("measured (simulated)") : tr("measured"));
    QCPGraph* model = addGraph(m_recording, QPen(colours.color(QPalette::Highlight), 2.0), tr("model"));
    QCPGraph* residual = addGraph(m_recording, QPen(base::statusColours(colours).lost, 1.0), tr("residual"));
    for (std::size_t i = 0; i < recording.size(); ++i) {
        const double time_s = recording.time_s[i];
        // Missing sensor values are gaps.
        const double speed_Hz = recording.isKnown(i) ? recording.speed_Hz[i] : qQNaN();
        measured->addData(time_s, speed_Hz);
        model->addData(time_s, predicted_Hz[i]);
        residual->addData(time_s, speed_Hz - predicted_Hz[i]);
    }
    m_recording->replot(QCustomPlot::rpQueuedReplot);
}

void MotorChart::addLive(double time_s, double speed_Hz, double duration_s) {
    m_liveDuration_s = duration_s;
    if (m_live.empty() || time_s > m_live.back().x())
        m_live.emplace_back(time_s, speed_Hz);
    drawRecording();
}

void MotorChart::endLive() {
    if (m_live.empty())
        return;
    m_live.clear();
    drawRecording();
    showAll();
}

void MotorChart::drawLive() {
    constexpr double kLeastTop_Hz = 100.0;
    m_recording->legend->setVisible(false);
    QCPGraph* graph = addGraph(m_recording, QPen(m_colours.color(QPalette::Highlight), 2.0), tr("measured"));
    double highest_Hz = kLeastTop_Hz;
    for (const QPointF& point : m_live) {
        graph->addData(point.x(), point.y());
        highest_Hz = std::max(highest_Hz, point.y());
    }
    m_recording->xAxis->setRange(0.0, m_liveDuration_s);
    m_recording->yAxis->setRange(-10.0, 1.2 * highest_Hz);
    m_recording->replot(QCustomPlot::rpQueuedReplot);
}

void MotorChart::showAll() {
    if (!m_evidence || !m_live.empty())
        return;
    const motors::MotorRecording& recording = m_evidence->recording;
    const auto [low, high] = std::ranges::minmax_element(recording.speed_Hz);
    m_recording->xAxis->setRange(recording.time_s.front(), recording.time_s.back());
    m_recording->yAxis->setRange(std::min(-10.0, 1.2 * *low), 1.3 * *high);
    m_recording->replot(QCustomPlot::rpQueuedReplot);
}

void MotorChart::restyle(const QPalette& colours) {
    m_colours = colours;
    for (QCustomPlot* chart : {m_curve, m_recording}) {
        plot::stylePlot(*chart, colours, font());
        chart->legend->setBrush(colours.color(QPalette::Base));
        chart->legend->setTextColor(colours.color(QPalette::Text));
        chart->legend->setBorderPen(QPen(plot::gridColour(colours)));
        chart->legend->setFont(font());
        for (QCPAxis* axis : {chart->xAxis, chart->yAxis})
            axis->setSubTickPen(Qt::NoPen);
    }
    draw();
}

base::Figure MotorChart::figure(QCustomPlot* chart, const QString& name, std::function<QString()> csv) {
    base::Figure figure;
    figure.name = name;
    figure.size_px = chart->size();
    restyle(base::designedPalette(false)); // for paper
    const QPicture picture = plot::pictureOf(*chart);
    restyle(palette());
    figure.paint = [picture](QPainter& painter) { painter.drawPicture(0, 0, picture); };
    figure.csv = std::move(csv);
    return figure;
}

base::Figure MotorChart::curveFigure() {
    return figure(m_curve, QStringLiteral("motor-%1-curve").arg(m_number + 1),
                  [motor = m_motor, evidence = m_evidence] { return curveCsv(motor, evidence.get()); });
}

base::Figure MotorChart::recordingFigure() {
    return figure(m_recording, QStringLiteral("motor-%1-recording").arg(m_number + 1),
                  [evidence = m_evidence] { return evidence ? recordingCsv(*evidence) : QString(); });
}

} // namespace teleta::calibrate
