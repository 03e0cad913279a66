// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/pipeline/touch/found_objects.h"

#include "backend/core/quantile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace teleta::pipeline {

namespace {

using stiffness::Stiffness;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::optional<double> ifFinite(double value) {
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// Lower and upper end of what is known; a value without an error stands for both.
std::pair<double, double> endsOf(const Stiffness& stiffness) {
    const double value = stiffness.value_NPerM.value_or(kInfinity);
    if (stiffness.value_NPerM && !stiffness.lower95_NPerM)
        return {value, value};
    return {stiffness.lower95_NPerM.value_or(0.0), stiffness.upper95_NPerM.value_or(kInfinity)};
}

bool areApart(const Stiffness& a, const Stiffness& b) {
    const auto [lowA, highA] = endsOf(a);
    const auto [lowB, highB] = endsOf(b);
    return FoundObjects::kOtherStiffness * highA < lowB || FoundObjects::kOtherStiffness * highB < lowA;
}

std::optional<Stiffness> ofTouch(const TouchRecord& touch) {
    return touch.stiffness && touch.stiffness->reliable ? std::optional(touch.stiffness->object)
                                                        : std::nullopt;
}

double observedForce_N(const arm::ContactForce& force) {
    double square = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
        square += force.observable[i] ? std::pow(force.force_N[static_cast<Eigen::Index>(i)], 2) : 0.0;
    return std::sqrt(square);
}

} // namespace

FoundObjects::Open* FoundObjects::openAt(const TouchRecord& touch) {
    Open* nearest = nullptr;
    double least_m = kNear_m;
    for (Open& open : m_open) {
        for (const Touched& touched : open.touches) {
            const double distance_m = (touched.p_Base_m - touch.p_Base_Contact_m).head<2>().norm();
            if (distance_m <= least_m) {
                least_m = distance_m;
                nearest = &open;
            }
        }
    }
    const std::optional<Stiffness> felt = ofTouch(touch);
    if (nearest == nullptr || !felt)
        return nearest;
    const bool isAnother = std::ranges::any_of(nearest->touches, [&](const Touched& touched) {
        return touched.stiffness && (touched.p_Base_m - touch.p_Base_Contact_m).norm() <= kSamePoint_m &&
               areApart(*touched.stiffness, *felt);
    });
    if (!isAnother)
        return nearest;
    m_open.erase(m_open.begin() + (nearest - m_open.data()));
    m_shown.reset();
    return nullptr;
}

const FoundObject* FoundObjects::add(const TouchRecord& touch) {
    ContourExplorer probe(m_settings);
    if (!touch.located || !probe.add(touch.p_Base_Contact_m))
        return nullptr;
    Open* open = openAt(touch);
    if (open == nullptr) {
        FoundObject object;
        object.number = m_objects.size() + 1;
        object.first_ns = touch.start_ns;
        object.first_s = touch.start_s;
        m_objects.push_back(std::move(object));
        m_open.push_back({m_objects.size() - 1, std::move(probe), {}});
        open = &m_open.back();
    } else {
        (void)open->explorer.add(touch.p_Base_Contact_m);
    }
    open->touches.push_back({touch.p_Base_Contact_m, ofTouch(touch)});

    FoundObject& object = m_objects[open->index];
    ++object.touches;
    object.p_Base_Centre_m +=
        (touch.p_Base_Contact_m - object.p_Base_Centre_m) / static_cast<double>(object.touches);
    object.contact = touch.contactType;
    if (touch.force)
        object.highestForce_N = std::max(object.highestForce_N, observedForce_N(*touch.force));
    std::vector<double> values;
    std::vector<double> lower;
    std::vector<double> upper;
    const auto count = [&](const Stiffness& touched) {
        const auto [low, high] = endsOf(touched);
        values.push_back(touched.value_NPerM.value_or(kInfinity));
        lower.push_back(low);
        upper.push_back(high);
    };
    std::vector<Stiffness> bounds;
    for (const Touched& touched : open->touches) {
        if (touched.stiffness && touched.stiffness->value_NPerM)
            count(*touched.stiffness);
        else if (touched.stiffness)
            bounds.push_back(*touched.stiffness);
    }
    // A bound that allows what as many touches told adds nothing to it.
    const double known = bounds.size() <= values.size() && !upper.empty() ? core::medianOf(upper) : 0.0;
    for (const Stiffness& bound : bounds)
        if (endsOf(bound).first > known)
            count(bound);
    if (!values.empty()) {
        const double value = core::medianOf(values);
        object.stiffness = Stiffness{.value_NPerM = ifFinite(value),
                                     .se_NPerM = {},
                                     .lower95_NPerM = core::medianOf(lower),
                                     .upper95_NPerM = ifFinite(core::medianOf(upper))};
        object.material = stiffness::classify(value);
    }
    object.contour = open->explorer.contour();
    object.recognition = object.contour.recognition;
    m_shown = static_cast<std::size_t>(open - m_open.data());
    showContour(open->explorer);
    return &object;
}

void FoundObjects::closeAll() {
    m_open.clear();
    m_shown.reset();
    if (!m_contour.points_m.empty())
        showContour(ContourExplorer(m_settings));
}

void FoundObjects::clear() {
    closeAll();
    m_objects.clear();
}

void FoundObjects::setSettings(const ContourSettings& settings) {
    m_settings = settings;
    for (Open& open : m_open) {
        open.explorer.setSettings(settings);
        m_objects[open.index].contour = open.explorer.contour();
        m_objects[open.index].recognition = m_objects[open.index].contour.recognition;
    }
    if (m_shown)
        showContour(m_open[*m_shown].explorer);
}

void FoundObjects::showContour(const ContourExplorer& explorer) {
    const std::uint64_t revision = m_contour.revision + 1;
    m_contour = explorer.contour();
    m_contour.revision = revision;
}

} // namespace teleta::pipeline
