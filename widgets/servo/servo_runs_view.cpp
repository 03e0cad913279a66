// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/servo/servo_runs_view.h"

#include "backend/servo_figure/servo_figure.h"
#include "widgets/base/background.h"
#include "widgets/base/colour_maps.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QPainter>
#include <QSvgRenderer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <memory>
#include <utility>

namespace teleta::servo {

namespace {

/// Text of a figure is laid out for lines of this height, px.
constexpr double kFigureEm_px = 16.0;
constexpr double kLeastFigure_px = 400.0;

figure::SvgColours coloursOf(const QPalette& palette) {
    const QColor paper = palette.color(QPalette::Base);
    const QColor ink = palette.color(QPalette::Text);
    figure::SvgColours colours;
    colours.paper = paper.name();
    colours.ink = ink.name();
    colours.soft = base::mixed(ink, paper, 0.3).name();
    colours.grid = base::mixed(ink, paper, 0.82).name();
    for (std::size_t i = 0; i < colours.series.size(); ++i)
        colours.series[i] = base::identityColour(static_cast<int>(i) + 1, base::isDark(palette)).name();
    return colours;
}

} // namespace

ServoRunsView::ServoRunsView(QWidget* parent)
    : FigureView(parent, {40, 26}, {16, 12})
    , m_add(new QToolButton(this))
    , m_forget(new QToolButton(this))
    , m_menu(new QToolButton(this)) {
    auto* tools = new QHBoxLayout;
    for (QToolButton* button : {m_add, m_forget, m_menu}) {
        button->setAutoRaise(true);
        tools->addWidget(button);
    }
    tools->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    const int margin = base::grid(this) / 2;
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->addLayout(tools);
    layout->addStretch(1);
    auto* menu = new QMenu(this);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] {
        menu->clear();
        addFigureActions(*menu);
    });
    m_menu->setMenu(menu);
    m_menu->setPopupMode(QToolButton::InstantPopup);
    connect(m_add, &QToolButton::clicked, this, &ServoRunsView::askForRecording);
    connect(m_forget, &QToolButton::clicked, this, &ServoRunsView::forgetOthers);
    connect(this, &FigureView::exportFailed, this, &ServoRunsView::failed);
    retranslate();
}

void ServoRunsView::retranslate() {
    m_add->setText(tr("A&dd recorded run…"));
    m_add->setToolTip(tr("A run written by teleta simulate --out: its servo.csv"));
    m_forget->setText(tr("Forget &other runs"));
    m_forget->setToolTip(tr("Keeps only the current run"));
    m_menu->setText(tr("&Picture"));
    m_menu->setToolTip(tr("Copies or saves the chart or its data"));
    setAccessibleName(tr("Servo runs"));
    setWhatsThis(tr("<p>Servo runs in one chart: the current one, earlier ones from before a restart or a "
                    "change of the source, and recorded ones.</p><p>To see the effect of the moment, restart "
                    "the scene with and without “Balance the moment”.</p>"));
    m_dirty = true;
}

void ServoRunsView::setSource(std::string name, const void* source) {
    m_runs.setSource(std::move(name), source);
}

void ServoRunsView::append(const ServoStep& step) {
    m_runs.add(step);
    m_dirty = true;
}

void ServoRunsView::addRecorded(const QString& path) {
    base::runInBackground(
        this, [file = path.toStdString()] { return servo_figure::readServoCurves(file); },
        [this](core::Expected<servo_figure::ServoCurves> run) {
            if (!run) {
                emit failed(QString::fromStdString(core::describe(run.error())));
                return;
            }
            m_runs.addRecorded(std::move(*run));
            m_dirty = true;
            m_drawn.invalidate();
        });
}

void ServoRunsView::askForRecording() {
    base::askToOpen(this,
                    {.title = tr("Add recorded run"),
                     .filters = {tr("Servo runs (servo.csv)"), tr("Comma-separated values (*.csv)")}},
                    [this](const QString& path) { addRecorded(path); });
}

void ServoRunsView::forgetOthers() {
    m_runs.forgetOthers();
    m_dirty = true;
    m_drawn.invalidate();
    refresh();
}

QRect ServoRunsView::chartRect() const {
    return rect().adjusted(1, m_add->geometry().bottom() + 2, -1, -1);
}

void ServoRunsView::refresh() {
    if (!m_dirty || !isVisible() || (m_drawn.isValid() && !m_drawn.hasExpired(kBetweenDrawings_ms)))
        return;
    draw();
    update();
}

void ServoRunsView::draw() {
    m_dirty = false;
    m_drawn.start();
    m_forget->setEnabled(m_runs.runs().size() > 1);
    const QSizeF size = chartRect().size();
    if (m_runs.runs().empty() || size.isEmpty()) {
        m_chart = {};
        m_svg.clear();
        return;
    }
    // A chart too small for its text is drawn larger and scaled down.
    const double scale = std::min(
        {base::em(this, 1) / kFigureEm_px, size.width() / kLeastFigure_px, size.height() / kLeastFigure_px});
    m_svg = QByteArray::fromStdString(
        servo_figure::servoFigure(m_runs.runs(), size.width() / scale, size.height() / scale)
            .standalone(coloursOf(palette())));
    QSvgRenderer renderer(m_svg);
    m_chart = QPixmap((size * devicePixelRatioF()).toSize());
    m_chart.setDevicePixelRatio(devicePixelRatioF());
    m_chart.fill(palette().color(QPalette::Base));
    QPainter painter(&m_chart);
    painter.setRenderHint(QPainter::Antialiasing);
    renderer.render(&painter, QRectF(QPointF(), size));
}

base::Figure ServoRunsView::figure() {
    base::Figure figure;
    figure.name = tr("servo-runs", "name of a file");
    figure.size_px = QSizeF(servo_figure::kServoFigureWidth, servo_figure::kServoFigureHeight);
    figure.svg = QByteArray::fromStdString(servo_figure::servoFigure(m_runs.runs()).standalone());
    const auto renderer = std::make_shared<QSvgRenderer>(figure.svg);
    figure.paint = [renderer, size = figure.size_px](QPainter& painter) {
        renderer->render(&painter, QRectF(QPointF(), size));
    };
    figure.csv = [runs = m_runs] { return runs.csv(); };
    return figure;
}

void ServoRunsView::addOwnActions(QMenu& menu, const QPoint& /*position*/) {
    menu.addAction(m_add->text(), this, &ServoRunsView::askForRecording);
    menu.addAction(m_forget->text(), this, &ServoRunsView::forgetOthers)
        ->setEnabled(m_runs.runs().size() > 1);
}

void ServoRunsView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QRect chart = chartRect();
    if (m_runs.runs().empty()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(chart, Qt::AlignCenter | Qt::TextWordWrap,
                         tr("No runs yet. Servo runs are drawn here on top of each other."));
    } else {
        painter.drawPixmap(chart.topLeft(), m_chart);
    }
    base::paintFocusFrame(painter, *this);
}

void ServoRunsView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_dirty = true;
    m_drawn.invalidate();
}

void ServoRunsView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() != QEvent::PaletteChange && event->type() != QEvent::FontChange)
        return;
    m_dirty = true;
    m_drawn.invalidate();
}

} // namespace teleta::servo
