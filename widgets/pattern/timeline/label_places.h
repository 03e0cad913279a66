// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>

#include <algorithm>
#include <optional>
#include <vector>

namespace teleta::pattern {

/// Places of labels in a lane that do not cover each other. Thread: one.
class LabelPlaces {
public:
    /// The wanted place, or one below it, down to bottom; empty: there is none, and nothing is taken.
    [[nodiscard]] std::optional<QRectF> place(QRectF wanted, double bottom) {
        const auto covers = [&](const QRectF& other) { return other.intersects(wanted); };
        for (auto found = std::ranges::find_if(m_taken, covers); found != m_taken.end();
             found = std::ranges::find_if(m_taken, covers))
            wanted.moveTop(found->bottom());
        if (wanted.bottom() > bottom)
            return std::nullopt;
        if (!wanted.isEmpty())
            m_taken.push_back(wanted);
        return wanted;
    }

private:
    std::vector<QRectF> m_taken;
};

} // namespace teleta::pattern
