// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/contour_explorer.h"

#include "backend/contour/cubic_spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace teleta::pipeline {

ContourExplorer::ContourExplorer(const ContourSettings& settings)
    : m_settings(settings) {
}

bool ContourExplorer::add(const Eigen::Vector3d& p_Base_Contact_m) {
    const std::array point{contour::Point(p_Base_Contact_m.head<2>())};
    if (!contour::areUsable(point) || !(std::abs(p_Base_Contact_m.z()) <= contour::kMaximumCoordinate_m))
        return false;
    m_contour.points_m.push_back(point.front());
    m_heights_m.push_back(p_Base_Contact_m.z());
    recompute();
    return true;
}

void ContourExplorer::setSettings(const ContourSettings& settings) {
    m_settings = settings;
    if (!m_contour.points_m.empty())
        recompute();
}

void ContourExplorer::reset() {
    if (m_contour.points_m.empty())
        return;
    const std::uint64_t revision = m_contour.revision + 1;
    m_contour = {};
    m_contour.revision = revision;
    m_heights_m.clear();
}

void ContourExplorer::recompute() {
    auto& points = m_contour.points_m;
    const std::size_t maximum = std::max<std::size_t>(m_settings.maximumPoints, 1);
    if (points.size() > maximum) {
        const auto beyond = static_cast<std::ptrdiff_t>(points.size() - maximum);
        points.erase(points.begin(), points.begin() + beyond);
        m_heights_m.erase(m_heights_m.begin(), m_heights_m.begin() + beyond);
    }
    ++m_contour.revision;
    m_contour.recognition.reset();
    if (points.size() >= ExploredContour::kLeastPoints)
        m_contour.recognition = contour::recogniseShape(points, m_settings.recognition);
    if (m_contour.recognition && m_contour.recognition->shape == contour::Shape::point &&
        points.size() < ExploredContour::kLeastOfAPoint)
        m_contour.recognition.reset();
    m_contour.height_m = std::accumulate(m_heights_m.begin(), m_heights_m.end(), 0.0) /
                         static_cast<double>(m_heights_m.size());
    sampleCurve(m_contour.recognition && m_contour.recognition->closed);
}

void ContourExplorer::sampleCurve(bool closed) {
    m_contour.curve_m.clear();
    if (m_contour.points_m.size() < 2)
        return;
    const auto spline =
        contour::CubicSpline::fit(m_contour.points_m, contour::SplineKind::interpolating, closed);
    if (!spline)
        return;
    const auto perSegment = static_cast<std::size_t>(std::max(m_settings.samplesPerSegment, 1));
    const std::size_t samples = spline->segments() * perSegment;
    m_contour.curve_m.reserve(samples + 1);
    for (std::size_t i = 0; i <= samples; ++i)
        m_contour.curve_m.push_back(
            spline->position_m(static_cast<double>(i) / static_cast<double>(perSegment)));
}

} // namespace teleta::pipeline
