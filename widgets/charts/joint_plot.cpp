// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/charts/joint_plot.h"

#include "widgets/base/theme.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

namespace teleta::charts {

namespace {

constexpr double kMilli = 1e3;
constexpr double kDegreesPerRad = 180.0 / std::numbers::pi;
constexpr double kLeastTorqueSpan_Nm = 0.02;
constexpr double kLeastAngleSpan_deg = 5.0;
constexpr auto kTorqueLane = static_cast<int>(JointPlot::Row::torque);

} // namespace

JointPlot::JointPlot(QWidget* parent)
    : TimePlot({.width_em = 28.0,
                .laneHeight_em = 6.8, // title and four values
                .panelWidth_em = 13.0,
                .widestTick = QStringLiteral("\u2212888")},
               parent) {
    m_touches = new Shades(this, QStringLiteral("background"), Shades::Kind::times);
    m_window = new Shades(this, QStringLiteral("background"), Shades::Kind::values);
    setJoints(4);
}

void JointPlot::setJoints(std::size_t joints) {
    if (joints == m_count)
        return;
    clearLanes();
    m_count = joints;
    addRow(Row::torque, m_perNm, m_perNm * kLeastTorqueSpan_Nm);
    addRow(Row::angle, kDegreesPerRad, kLeastAngleSpan_deg);
    setAnglesShown(m_anglesShown);
}

void JointPlot::addRow(Row row, double scale, double minimumSpan) {
    std::vector<CurveStyle> curves;
    for (std::size_t joint = 0; joint < m_count; ++joint)
        curves.push_back({.column = static_cast<std::size_t>(row) * m_count + joint,
                          .display = {.scale = scale},
                          .colour = static_cast<int>(joint) + 1});
    addLane(row, curves, minimumSpan);
}

QString JointPlot::jointName(std::size_t joint) const {
    if (joint < static_cast<std::size_t>(m_names.size()))
        return m_names[static_cast<qsizetype>(joint)];
    if (m_count != 4 || joint >= m_count)
        return tr("joint %1").arg(joint + 1);
    return std::array{tr("shoulder roll"), tr("shoulder pitch"), tr("shoulder yaw"),
                      tr("elbow pitch")}[joint];
}

QString JointPlot::laneTitle(int lane) const {
    return lane == kTorqueLane ? tr("Joint torque") : tr("Joint angle");
}

QString JointPlot::laneUnit(int lane) const {
    if (lane != kTorqueLane)
        return QStringLiteral("°");
    return m_perNm == kMilli ? QStringLiteral("mNm") : QStringLiteral("Nm");
}

QString JointPlot::curveName(int, std::size_t curve) const {
    return jointName(curve);
}

void JointPlot::setAnglesShown(bool shown) {
    m_anglesShown = shown;
    constexpr auto kRow = static_cast<int>(Row::angle);
    Lane& angle = lanes()[kRow];
    angle.shown = shown;
    angle.rect->setVisible(shown);
    angle.panel->setVisible(shown);
    for (const Curve& curve : angle.curves)
        curve.graph->setVisible(shown);
    for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft, QCPAxis::atTop, QCPAxis::atRight})
        angle.rect->axis(side)->setVisible(shown && (side == QCPAxis::atBottom || side == QCPAxis::atLeft));
    grid()->setRowStretchFactor(kRow, shown ? 1.0 : 1e-6);
    updateLanes();
}

void JointPlot::setTorqueUnit(double perNm) {
    if (std::exchange(m_perNm, perNm) == perNm)
        return;
    Lane& torque = lanes()[kTorqueLane];
    for (Curve& curve : torque.curves)
        curve.style.display.scale = perNm;
    torque.range = base::CalmRange(perNm * kLeastTorqueSpan_Nm);
}

void JointPlot::clearWindow() {
    setTorqueUnit(1.0);
    m_window->setShades({});
}

void JointPlot::setWindow(double low_Nm, double high_Nm) {
    setTorqueUnit(kMilli);
    m_window->setShades({{kMilli * low_Nm, kMilli * high_Nm, {}}, {-kMilli * high_Nm, -kMilli * low_Nm, {}}});
}

void JointPlot::placeExtras(const std::vector<QCPAxisRect*>& rects) {
    m_touches->setRects(rects);
    // The torques are always shown, on top.
    m_window->setRects({rects.begin(), rects.empty() ? rects.begin() : rects.begin() + 1});
}

void JointPlot::colourExtras(const QPalette& palette) {
    const QColor ground = palette.color(QPalette::Base);
    const QColor text = palette.color(QPalette::Text);
    const QColor accent = palette.color(QPalette::Highlight);
    const QFont small = base::sized(font(), base::kSmallText);
    const bool dark = base::isDark(palette);
    const QColor window = base::translucent(accent, dark ? 0.30F : 0.16F); // a touch stays visible behind it
    m_window->setInk(small, window, QPen(base::mixed(ground, accent, 0.8), 1.0, Qt::DashLine), text);
    m_touches->setInk(small, base::mixed(ground, text, dark ? 0.12 : 0.08),
                      QPen(base::mixed(ground, text, 0.45), 1.0), base::mixed(text, ground, 0.2));
}

ValueRange JointPlot::automaticRange(Lane& lane, std::optional<ValueRange> extent, const SampleHistory&,
                                     double end_s) {
    if (extent) {
        if (lane.id == kTorqueLane) // the torque window stays visible
            for (const Shade& window : m_window->shades())
                if (window.from >= 0.0)
                    extent = ValueRange{std::min(0.0, extent->low), std::max(window.to, extent->high)};
        lane.range.update(extent->low, extent->high, end_s);
    }
    return {lane.range.low(), lane.range.high()};
}

} // namespace teleta::charts
