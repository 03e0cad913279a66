// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/joint_chart_view.h"

#include "widgets/base/icons.h"
#include "widgets/base/numbers/quantity_text.h"

#include <QMenu>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace teleta::charts {

JointChartView::JointChartView(QWidget* parent)
    : JointChartView(new JointPlot, parent) {
}

JointChartView::JointChartView(JointPlot* plot, QWidget* parent)
    : TimeChartView(plot, kShortestSpan_s, parent)
    , m_history(plot->columns())
    , m_joints(plot)
    , m_angles(new QAction(base::themeIcon(base::Icon::strips), {}, this)) {
    m_angles->setObjectName(QStringLiteral("angles"));
    m_angles->setCheckable(true);
    connect(m_angles, &QAction::toggled, this, [this](bool shown) {
        m_joints->setAnglesShown(shown);
        invalidate();
        refresh();
    });
    addTool(m_angles);
    addTimeTools();
    setWindow(stiffness::TorqueWindow());
    retranslate();
    restyle();
}

void JointChartView::retranslate() {
    TimeChartView::retranslate();
    setAccessibleName(tr("Joint torques and angles of the arm"));
    setWhatsThis(
        tr("<p>Torque of each joint over time. The coloured band is the torque window in which a touch is "
           "evaluated. Grey stretches are touches with their numbers, from the first torque above the noise "
           "to the estimate.</p><p>Drag or Shift+wheel scrolls, Ctrl+wheel changes the span, Space pauses, "
           "End goes back to live. Double-click an axis to type its range.</p>"));
    setDefaultEmptyText(tr("No arm. Open a scene or a device with an arm."));
    m_angles->setText(tr("Angles"));
    m_angles->setToolTip(tr("Show the joint angles too"));
}

void JointChartView::append(std::span<const core::JointSample> samples) {
    append(m_history, m_joints->joints(), samples);
}

void JointChartView::append(SampleHistory& history, std::size_t joints,
                            std::span<const core::JointSample> samples) {
    std::array<double, 2 * core::JointVector::kCapacity> row{};
    for (const core::JointSample& sample : samples) {
        row.fill(std::numeric_limits<double>::quiet_NaN());
        std::copy_n(sample.torque_Nm.data(), std::min(joints, sample.torque_Nm.size()), row.begin());
        std::copy_n(sample.angle_rad.data(), std::min(joints, sample.angle_rad.size()), row.data() + joints);
        history.append({sample.time_ns, sample.sourceTime_s, sample.discontinuity},
                       std::span(row).first(2 * joints));
    }
}

void JointChartView::setJoints(std::size_t joints) {
    if (joints == m_joints->joints())
        return;
    m_joints->setJoints(joints);
    (void)takeContent();
    restyle();
}

void JointChartView::setJointNames(const QStringList& names) {
    m_joints->setNames(names);
    invalidate();
}

bool JointChartView::addTouch(const pipeline::TouchRecord& touch) {
    const auto first = m_history.nearestSource(touch.start_s);
    const auto last = m_history.nearestSource(touch.ready_s);
    if (!first || !last ||
        std::abs(m_history.sourceTime_s(*first) - touch.start_s) > m_history.longestStep_s())
        return false;
    m_touches.push_back({touch.number, m_history.time_s(*first), m_history.time_s(*last)});
    invalidate();
    return true;
}

void JointChartView::clear() {
    m_history.clear();
    m_touches.clear();
    reset();
}

JointChartView::Content JointChartView::takeContent() {
    Content taken{std::exchange(m_history, SampleHistory(m_joints->columns())), std::exchange(m_touches, {})};
    reset();
    return taken;
}

void JointChartView::setContent(Content content) {
    m_history = std::move(content.history);
    m_touches = std::move(content.touches);
    reset();
}

void JointChartView::prepareExtras() {
    std::erase_if(m_touches, [this](const Touch& t) { return t.to_s < m_history.oldestTime_s(); });
    std::vector<Shade> shades;
    for (const Touch& touch : m_touches)
        if (touch.to_s > end_s() - span_s() && touch.from_s < end_s())
            shades.push_back({touch.from_s - end_s(), touch.to_s - end_s(), QString::number(touch.number)});
    m_joints->setTouches(std::move(shades));
}

QString JointChartView::cursorText(const QString& time, const QString& sourceTime) const {
    return tr("at %1 s   arm time %2 s").arg(time, sourceTime);
}

void JointChartView::setWindow(const std::optional<stiffness::TorqueWindow>& window) {
    if (window)
        m_joints->setWindow(window->low_Nm, window->high_Nm);
    else
        m_joints->clearWindow();
    invalidate();
}

bool JointChartView::showTouch(std::uint64_t number) {
    const auto touch =
        std::ranges::find_if(m_touches, [number](const Touch& t) { return t.number == number; });
    if (touch == m_touches.end())
        return false;
    const double middle_s = 0.5 * (touch->from_s + touch->to_s);
    setPaused(true);
    scrollBy(middle_s + 0.5 * span_s() - end_s());
    return true;
}

QString JointChartView::csv(std::size_t first, std::size_t last) const {
    QString text = QStringLiteral("time_s");
    for (std::size_t joint = 1; joint <= m_joints->joints(); ++joint)
        text += QStringLiteral(",joint%1_angle_rad,joint%1_torque_nm").arg(joint);
    text += QLatin1Char('\n');
    for (std::size_t i = first; i < last; ++i) {
        text += base::csvNumber(m_history.sourceTime_s(i));
        for (std::size_t joint = 0; joint < m_joints->joints(); ++joint)
            for (const std::size_t column : {m_joints->joints() + joint, joint})
                text += QLatin1Char(',') + base::csvNumber(m_history.value(column, i));
        text += QLatin1Char('\n');
    }
    return text;
}

void JointChartView::addOwnActions(QMenu& menu, const QPoint& position) {
    menu.addAction(m_angles);
    addTimeActions(menu);
    addRangeActions(menu, position);
}

} // namespace teleta::charts
