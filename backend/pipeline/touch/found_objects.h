// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/tactile_features.h"
#include "backend/pipeline/touch/contour_explorer.h"
#include "backend/pipeline/touch/touch_record.h"
#include "backend/stiffness/material.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace teleta::pipeline {

/// What the touches so far tell of one object.
struct FoundObject {
    std::uint64_t number = 0;  ///< from 1, in the order in which they were found
    std::int64_t first_ns = 0; ///< when its first touch began, steady time
    double first_s = 0.0;      ///< the same in the arm's own time
    std::size_t touches = 0;
    Eigen::Vector3d p_Base_Centre_m = Eigen::Vector3d::Zero(); ///< mean of the contact points
    contact::ContactType contact = contact::ContactType::none; ///< of the newest touch, as the skin felt it
    double highestForce_N = 0.0; ///< of the touches when they were evaluated; observed components
    /// Of the touches that tell one: the median, between the medians of the ends of their intervals. The
    /// median leaves out the touch that slid off a corner. Touches that tell a bound alone count as rigid
    /// where they are more than those with a value, or contradict them.
    std::optional<stiffness::Stiffness> stiffness;
    std::optional<stiffness::Material> material; ///< of that stiffness
    std::optional<contour::Recognition> recognition;
    ExploredContour contour; ///< its own; the revision counts its touches
};

/// Tells the objects apart that an arm has touched, by the place of the contact: a touch belongs to the
/// object that was touched nearest to it, when that is no further than kNear_m in the x-y plane of the base
/// (objects stand upright), else to a new one. A touch where that object was touched before, but of another
/// stiffness (the same point within kSamePoint_m, intervals kOtherStiffness apart), is of a new object:
/// another one stands there now. Thread: one. Source: TeleTA, section 3, for each object.
class FoundObjects {
public:
    static constexpr double kNear_m = 0.05;
    static constexpr double kSamePoint_m = 0.005;
    /// Touches from different sides differ by more than their noise: only beyond this factor is it another.
    static constexpr double kOtherStiffness = 2.0;

    explicit FoundObjects(const ContourSettings& settings = {})
        : m_settings(settings) {}

    /// The object that it belongs to; null, and nothing changes, for a touch that is not located, or out of
    /// the range of ContourExplorer.
    const FoundObject* add(const TouchRecord& touch);
    /// The next touch is of a new object, wherever it is; the former ones stay as they are.
    void closeAll();
    /// There is none any more; the next one has the number 1.
    void clear();
    void setSettings(const ContourSettings& settings);

    [[nodiscard]] const std::vector<FoundObject>& objects() const { return m_objects; }
    /// Of the object that was touched last; empty after closeAll(). Its revision grows with every change.
    [[nodiscard]] const ExploredContour& contour() const { return m_contour; }

private:
    struct Touched {
        Eigen::Vector3d p_Base_m;
        std::optional<stiffness::Stiffness> stiffness;
    };
    struct Open {
        std::size_t index = 0; ///< in m_objects
        ContourExplorer explorer;
        std::vector<Touched> touches;
    };

    [[nodiscard]] Open* openAt(const TouchRecord& touch);
    void showContour(const ContourExplorer& explorer);

    ContourSettings m_settings;
    std::vector<FoundObject> m_objects;
    std::vector<Open> m_open;
    std::optional<std::size_t> m_shown; ///< in m_open
    ExploredContour m_contour;
};

} // namespace teleta::pipeline
