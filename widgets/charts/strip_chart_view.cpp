// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/strip_chart_view.h"

#include "widgets/base/icons.h"
#include "widgets/charts/strip_plot.h"

#include <QKeyEvent>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::charts {

namespace {

bool isMarkKey(const QKeyEvent& event) {
    return event.key() == Qt::Key_M && event.modifiers() == Qt::NoModifier;
}

} // namespace

StripChartView::StripChartView(QWidget* parent)
    : StripChartView(new StripPlot, parent) {
}

StripChartView::StripChartView(StripPlot* plot, QWidget* parent)
    : TimeChartView(plot, kShortestSpan_s, parent)
    , m_strips(plot)
    , m_mark(new QAction(base::themeIcon(base::Icon::mark), {}, this))
    , m_stripsButton(addTool()) {
    makeActions();
    m_stripsButton->setIcon(base::themeIcon(base::Icon::strips));
    m_stripsButton->setPopupMode(QToolButton::InstantPopup);
    m_stripsButton->setMenu(m_stripsMenu);
    addTimeTools();
    addTool(m_mark);
    retranslate();
    takeStrips();
    restyle();
}

void StripChartView::makeActions() {
    for (const Strip strip : kAllStrips) {
        auto* action = m_stripsMenu->addAction(QString());
        action->setCheckable(true);
        action->setChecked(definitionOf(strip).shownAtFirst);
        action->setVisible(!definitionOf(strip).ofVectors);
        connect(action, &QAction::toggled, this, &StripChartView::takeStrips);
        m_stripActions[static_cast<std::size_t>(strip)] = action;
    }
    connect(m_mark, &QAction::triggered, this, &StripChartView::requestMark);
}

void StripChartView::retranslate() {
    TimeChartView::retranslate();
    setAccessibleName(tr("Strip charts of the tactile features"));
    setWhatsThis(
        tr("<p>Force, centres, moment deviation and orientation of the contact over time. The numbers beside "
           "the strips are the newest values, or those at the cursor.</p><p>A gap in a line means that "
           "nothing is known there: there was no contact, samples were lost, or the recording jumped (dotted "
           "line).</p><p>Drag or Shift+wheel scrolls, Ctrl+wheel changes the span, Space pauses, End goes "
           "back to live. Double-click an axis to type its range.</p>"));
    m_stripsButton->setText(tr("Strips"));
    m_stripsButton->setToolTip(tr("Choose which strips are shown"));
    m_stripsButton->setAccessibleName(tr("Choose strips"));
    m_stripsMenu->setTitle(tr("&Strips"));
    for (const Strip strip : kAllStrips)
        stripAction(strip)->setText(titleOf(strip));
    m_mark->setText(tr("Mark"));
    m_mark->setToolTip(tr("Mark this moment (M)"));
}

QAction* StripChartView::stripAction(Strip strip) const {
    return m_stripActions[static_cast<std::size_t>(strip)];
}

std::vector<Strip> StripChartView::shownStrips() const {
    std::vector<Strip> strips;
    std::ranges::copy_if(kAllStrips, std::back_inserter(strips), [this](Strip s) {
        return stripAction(s)->isVisible() && stripAction(s)->isChecked();
    });
    return strips;
}

void StripChartView::takeStrips() {
    m_strips->setStrips(shownStrips());
    invalidate();
    refresh();
}

void StripChartView::append(const pipeline::FeatureSample& sample) {
    m_history.append(sample);
}

void StripChartView::append(std::span<const pipeline::FeatureSample> samples) {
    for (const pipeline::FeatureSample& sample : samples)
        m_history.append(sample);
}

void StripChartView::clear() {
    m_history.clear();
    m_marks.clear();
    reset();
}

FeatureHistory StripChartView::takeHistory() {
    FeatureHistory taken = std::exchange(m_history, FeatureHistory());
    clear();
    return taken;
}

void StripChartView::setHistory(FeatureHistory history) {
    m_history = std::move(history);
    m_marks.clear();
    reset();
}

void StripChartView::prepareExtras() {
    std::erase_if(m_marks, [this](const Mark& mark) { return mark.time_s < m_history.oldestTime_s(); });
    std::vector<TimeLine> lines;
    for (const Mark& mark : m_marks)
        lines.push_back({mark.time_s - end_s(), mark.label});
    m_strips->setMarks(std::move(lines));
}

QString StripChartView::cursorText(const QString& time, const QString& sourceTime) const {
    return tr("at %1 s   stream time %2 s").arg(time, sourceTime);
}

void StripChartView::setLoadUnit(const QString& unit) {
    m_strips->setLoadUnit(unit);
    invalidate();
}

void StripChartView::setVectors(bool vectors) {
    if (std::exchange(m_vectors, vectors) == vectors)
        return;
    for (const Strip strip : kAllStrips)
        if (definitionOf(strip).ofVectors)
            stripAction(strip)->setVisible(vectors);
    takeStrips();
}

bool StripChartView::addMark(double sourceTime_s, const QString& label) {
    const auto sample = m_history.nearestSource(sourceTime_s);
    if (!sample || std::abs(m_history.sourceTime_s(*sample) - sourceTime_s) > m_history.longestStep_s())
        return false;
    m_marks.push_back({m_history.time_s(*sample), label});
    invalidate();
    return true;
}

bool StripChartView::addMarkAt(std::int64_t time_ns, const QString& label) {
    const auto sample = m_history.newestAt(time_ns);
    if (!sample)
        return false;
    m_marks.push_back({m_history.time_s(*sample), label});
    invalidate();
    return true;
}

void StripChartView::clearMarks() {
    m_marks.clear();
    invalidate();
}

void StripChartView::requestMark() {
    if (const auto sample = shownSample())
        emit markRequested(m_history.time_ns(*sample));
}

QString StripChartView::csv(std::size_t first, std::size_t last) const {
    return featuresCsv(m_history, first, last, m_strips->loadUnit(), m_vectors);
}

void StripChartView::addOwnActions(QMenu& menu, const QPoint& position) {
    menu.addMenu(m_stripsMenu);
    addTimeActions(menu);
    menu.addAction(m_mark);
    addRangeActions(menu, position);
}

bool StripChartView::event(QEvent* event) {
    // Otherwise the window's shortcut, which marks the present, would take the key.
    if (event->type() == QEvent::ShortcutOverride && isMarkKey(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return TimeChartView::event(event);
}

void StripChartView::keyPressEvent(QKeyEvent* event) {
    if (isMarkKey(*event))
        requestMark();
    else
        TimeChartView::keyPressEvent(event);
}

} // namespace teleta::charts
