// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/pipeline/touch/touch_snapshot.h"
#include "widgets/charts/sample_history.h"

#include <QString>

#include <cstddef>
#include <vector>

namespace teleta::charts {

/// One quantity over time, in SI units.
enum class Channel {
    force,
    threshold,
    copX,
    copY,
    cocX,
    cocY,
    dzmpX,
    dzmpY,
    alphaZ,
    lambda1,
    lambda2,
    ratio, ///< lambda1 / lambda2; undefined when lambda2 is 0
    active,
    // Of arrays of vectors.
    shearX,
    shearY,
    momentZ,
    friction, ///< shear over normal load
};
inline constexpr std::size_t kChannels = 17;

/// The newest feature samples of a stream; undefined values are NaN. append() does not allocate. Thread: one.
class FeatureHistory : public SampleHistory {
public:
    explicit FeatureHistory(std::size_t capacity = 65536);

    void append(const pipeline::FeatureSample& sample);

    using SampleHistory::value;
    [[nodiscard]] double value(Channel channel, std::size_t index) const {
        return value(static_cast<std::size_t>(channel), index);
    }
    [[nodiscard]] contact::ContactType type(std::size_t index) const { return m_types[slot(index)]; }

private:
    std::vector<contact::ContactType> m_types;
};

/// Samples first..last (exclusive) as CSV with the columns of `teleta features`, the force in loadUnit; NA
/// where undefined. vectors: of an array of vectors, with its shear.
[[nodiscard]] QString featuresCsv(const FeatureHistory& history, std::size_t first, std::size_t last,
                                  const QString& loadUnit, bool vectors);

} // namespace teleta::charts
