// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contact/contact_segmenter.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <functional>
#include <limits>

namespace teleta::contact {

namespace {

constexpr std::size_t kWord = sizeof(std::uint64_t);

std::size_t roundUp(std::size_t count) {
    return (count + 2 * kWord - 1) / kWord * kWord;
}

/// One number that orders active taxels by load, and equal loads by index with the first index highest. It is
/// the bit pattern of a finite positive double, which sorts like the double itself: the load in the upper
/// half, the index in the lower. A double, because every processor has a vector maximum for it.
double keyOf(float load, std::uint32_t taxel) {
    const std::uint64_t upper = std::bit_cast<std::uint32_t>(load);
    const std::uint64_t lower = ~taxel;
    return std::bit_cast<double>(upper << 32 | lower);
}

std::int32_t taxelOf(double key) {
    return static_cast<std::int32_t>(~static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(key)));
}

double larger(double a, double b) {
    return a > b ? a : b;
}

/// A summit and a pass of equal load belong to one plateau.
bool isNoise(float summit, float pass, double height_N) {
    return summit == pass || static_cast<double>(summit) - static_cast<double>(pass) < height_N;
}

} // namespace

ContactSegmenter::ContactSegmenter(const core::ArrayLayout& layout, const SegmentationSettings& settings)
    : m_layout(layout)
    , m_settings(settings)
    , m_labels(layout.taxels(), 0)
    , m_active(roundUp(layout.taxels()), 0)
    , m_key(static_cast<std::size_t>(layout.rows + 2) * static_cast<std::size_t>(layout.columns + 1) + 1, 0.0)
    , m_rowMaximum(m_key.size(), 0.0)
    , m_ascent(layout.taxels(), 0) {
    // Two summits are never neighbours.
    const auto summits =
        static_cast<std::size_t>((layout.rows + 1) / 2) * static_cast<std::size_t>((layout.columns + 1) / 2);
    m_basins.reserve(summits);
    m_contacts.reserve(summits);
    m_order.reserve(summits);
    m_runs.reserve(layout.taxels());
    m_segments.reserve(layout.taxels());
    m_passes.reserve(4 * layout.taxels());
}

std::span<Contact> ContactSegmenter::segment(std::span<const float> load_N,
                                             std::span<const std::uint8_t> dead) {
    m_contacts.clear();
    forgetLastFrame();
    if (load_N.size() != m_labels.size())
        return m_contacts;
    m_load = load_N.data();
    findActive(load_N, dead.size() == load_N.size() ? dead : std::span<const std::uint8_t>{});
    findRuns();
    if (m_runs.empty())
        return m_contacts;
    findAscents();
    climb();
    if (m_basins.size() > 1) {
        float peak = 0.0F;
        for (const Basin& basin : m_basins)
            peak = std::max(peak, m_load[basin.summit]);
        findPasses(
            std::max({0.0, m_settings.noiseHeight * static_cast<double>(peak), m_settings.noiseHeight_N}));
    }
    measure();
    number();
    return m_contacts;
}

/// Where the key of a taxel is: there is a zero between the rows, and a row of zeros above and below.
std::size_t ContactSegmenter::placeOf(std::int32_t taxel, std::int32_t row) const {
    return static_cast<std::size_t>(taxel + row + m_layout.columns + 2);
}

void ContactSegmenter::forgetLastFrame() {
    for (const Run& run : m_runs) {
        const std::int32_t taxels = run.end - run.begin;
        const std::size_t place = placeOf(run.begin, run.row);
        std::fill_n(m_labels.begin() + run.begin, taxels, 0);
        std::fill_n(m_key.begin() + static_cast<std::ptrdiff_t>(place), taxels, 0.0);
        std::fill_n(m_rowMaximum.begin() + static_cast<std::ptrdiff_t>(place) - 1, taxels + 2, 0.0);
    }
    m_runs.clear();
}

void ContactSegmenter::findActive(std::span<const float> load_N, std::span<const std::uint8_t> dead) {
    constexpr float kLargest = std::numeric_limits<float>::max();
    const auto setting = static_cast<float>(m_settings.threshold_N);
    const float threshold = setting > 0.0F ? setting : std::numeric_limits<float>::denorm_min();
    const std::size_t taxels = load_N.size();
    const float* const load = load_N.data();
    std::uint8_t* const active = m_active.data();
    for (std::size_t i = 0; i < taxels; ++i)
        active[i] = ((load[i] >= threshold) & (load[i] <= kLargest)) ? 255 : 0;
    for (std::size_t i = 0; i < dead.size(); ++i)
        active[i] = dead[i] != 0 ? 0 : active[i];
}

void ContactSegmenter::findRuns() {
    const std::int32_t columns = m_layout.columns;
    std::int32_t row = 0;
    std::int32_t rowEnd = columns;
    std::int32_t begin = -1;
    std::uint64_t before = 0;
    // A run begins or ends where a taxel differs from the one before it; eight taxels are compared at a time.
    for (std::size_t offset = 0; offset < m_active.size(); offset += kWord) {
        std::uint64_t word = 0;
        std::memcpy(&word, m_active.data() + offset, kWord);
        for (std::uint64_t changes = word ^ (word << 8 | before); changes != 0;) {
            const int byte = std::countr_zero(changes) / 8;
            changes &= ~(std::uint64_t{255} << (8 * byte));
            const auto taxel = static_cast<std::int32_t>(offset) + byte;
            if (begin < 0) {
                begin = taxel;
                while (begin >= rowEnd) {
                    ++row;
                    rowEnd += columns;
                }
                continue;
            }
            for (; taxel > rowEnd; ++row, rowEnd += columns) {
                m_runs.push_back({begin, rowEnd, row, 0});
                begin = rowEnd;
            }
            m_runs.push_back({begin, taxel, row, 0});
            begin = -1;
        }
        before = word >> 56;
    }
}

void ContactSegmenter::findAscents() {
    for (const Run& run : m_runs) {
        double* const key = m_key.data() + placeOf(run.begin, run.row);
        const float* const load = m_load + run.begin;
        const std::int32_t taxels = run.end - run.begin;
        for (std::int32_t i = 0; i < taxels; ++i)
            key[i] = keyOf(load[i], static_cast<std::uint32_t>(run.begin + i));
    }
    // The taxels beside a run are looked at from the rows above and below. What is written into the border is
    // never read.
    for (const Run& run : m_runs) {
        const std::size_t place = placeOf(run.begin, run.row);
        const double* const key = m_key.data() + place;
        double* const maximum = m_rowMaximum.data() + place;
        const std::int32_t taxels = run.end - run.begin;
        maximum[-1] = larger(key[-2], key[0]);
        for (std::int32_t i = 0; i < taxels; ++i)
            maximum[i] = larger(larger(key[i - 1], key[i]), key[i + 1]);
        maximum[taxels] = larger(key[taxels - 1], key[taxels + 1]);
    }
    const std::ptrdiff_t stride = m_layout.columns + 1;
    for (const Run& run : m_runs) {
        const double* const maximum = m_rowMaximum.data() + placeOf(run.begin, run.row);
        std::int32_t* const ascent = m_ascent.data() + run.begin;
        const std::int32_t taxels = run.end - run.begin;
        for (std::int32_t i = 0; i < taxels; ++i) {
            const double highest = larger(larger(maximum[i - stride], maximum[i]), maximum[i + stride]);
            ascent[i] = taxelOf(highest);
        }
    }
}

void ContactSegmenter::climb() {
    m_basins.clear();
    m_segments.clear();
    std::int32_t* const labels = m_labels.data();
    const std::int32_t* const ascent = m_ascent.data();
    for (const Run& run : m_runs) {
        for (std::int32_t i = run.begin; i < run.end; ++i) {
            if (ascent[i] == i) {
                labels[i] = static_cast<std::int32_t>(m_basins.size()) + 1;
                m_basins.push_back({.summit = i,
                                    .parent = static_cast<std::int32_t>(m_basins.size()),
                                    .minColumn = m_layout.columns});
            } else {
                labels[i] = labels[ascent[i]];
            }
        }
    }
    for (auto run = m_runs.rbegin(); run != m_runs.rend(); ++run) {
        std::int32_t end = run->end;
        std::int32_t current = 0;
        for (std::int32_t i = run->end - 1; i >= run->begin; --i) {
            std::int32_t label = labels[ascent[i]];
            if (label == 0)
                label = climbFrom(i);
            labels[i] = label;
            if (label != current) {
                if (current != 0)
                    m_segments.push_back({i + 1, end, run->row, current - 1});
                end = i + 1;
                current = label;
            }
        }
        m_segments.push_back({run->begin, end, run->row, current - 1});
    }
}

std::int32_t ContactSegmenter::climbFrom(std::int32_t taxel) {
    std::int32_t top = taxel;
    while (m_labels[top] == 0)
        top = m_ascent[top];
    const std::int32_t label = m_labels[top];
    for (; m_labels[taxel] == 0; taxel = m_ascent[taxel])
        m_labels[taxel] = label;
    return label;
}

bool ContactSegmenter::isHigher(std::int32_t taxel, std::int32_t other) const {
    return m_load[taxel] != m_load[other] ? m_load[taxel] > m_load[other] : taxel < other;
}

std::int32_t ContactSegmenter::rootOf(std::int32_t basin) {
    while (m_basins[basin].parent != basin) {
        m_basins[basin].parent = m_basins[m_basins[basin].parent].parent;
        basin = m_basins[basin].parent;
    }
    return basin;
}

void ContactSegmenter::findPasses(double height_N) {
    m_passes.clear();
    const std::int32_t columns = m_layout.columns;
    // Segments are numbered from the last to the first, so those of the next row precede those of this one.
    std::size_t belowBegin = 0;
    std::size_t begin = 0;
    while (begin < m_segments.size()) {
        const std::int32_t row = m_segments[begin].row;
        std::size_t below = begin > 0 && m_segments[begin - 1].row == row + 1 ? belowBegin : begin;
        std::size_t end = begin;
        for (; end < m_segments.size() && m_segments[end].row == row; ++end) {
            const Run& segment = m_segments[end];
            if (end > begin && m_segments[end - 1].begin == segment.end)
                addPass(segment.end - 1, segment.end, height_N);
            while (below < begin && m_segments[below].begin > segment.end + columns)
                ++below;
            for (std::size_t i = below; i < begin && m_segments[i].end >= segment.begin + columns; ++i) {
                if (m_segments[i].basin != segment.basin)
                    addPasses(segment, m_segments[i], height_N);
            }
        }
        belowBegin = begin;
        begin = end;
    }

    std::sort(m_passes.begin(), m_passes.end(), std::greater<>());
    m_passes.erase(std::unique(m_passes.begin(), m_passes.end()), m_passes.end());
    for (const double pass : m_passes)
        mergeOver(taxelOf(pass), height_N);
}

void ContactSegmenter::addPasses(const Run& segment, const Run& below, double height_N) {
    const std::int32_t columns = m_layout.columns;
    const std::int32_t begin = std::max(below.begin, segment.begin + columns - 1);
    const std::int32_t end = std::min(below.end, segment.end + columns + 1);
    for (std::int32_t taxel = begin; taxel < end; ++taxel) {
        const std::int32_t first = std::max(segment.begin, taxel - columns - 1);
        const std::int32_t last = std::min(segment.end - 1, taxel - columns + 1);
        for (std::int32_t above = first; above <= last; ++above)
            addPass(above, taxel, height_N);
    }
}

/// Records where two basins meet, unless both rise so far above that place that they cannot be merged there
/// or lower.
void ContactSegmenter::addPass(std::int32_t first, std::int32_t second, double height_N) {
    const std::int32_t pass = isHigher(first, second) ? second : first;
    const float summit =
        std::min(m_load[m_basins[m_labels[first] - 1].summit], m_load[m_basins[m_labels[second] - 1].summit]);
    if (isNoise(summit, m_load[pass], height_N))
        m_passes.push_back(keyOf(m_load[pass], static_cast<std::uint32_t>(pass)));
}

/// Floods a pass: of the regions that meet there, those that rise too little are merged into the highest.
void ContactSegmenter::mergeOver(std::int32_t pass, double height_N) {
    const std::int32_t row = pass / m_layout.columns;
    const std::int32_t column = pass % m_layout.columns;
    std::array<std::int32_t, 9> meeting;
    std::size_t count = 0;
    std::int32_t highest = rootOf(m_labels[pass] - 1);
    for (std::int32_t r = std::max(0, row - 1); r <= std::min(m_layout.rows - 1, row + 1); ++r) {
        for (std::int32_t c = std::max(0, column - 1); c <= std::min(m_layout.columns - 1, column + 1); ++c) {
            const std::int32_t taxel = r * m_layout.columns + c;
            if (taxel != pass && (m_labels[taxel] == 0 || !isHigher(taxel, pass)))
                continue;
            const std::int32_t region = rootOf(m_labels[taxel] - 1);
            meeting[count++] = region;
            if (isHigher(m_basins[region].summit, m_basins[highest].summit))
                highest = region;
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        Basin& basin = m_basins[meeting[i]];
        if (meeting[i] != highest && isNoise(m_load[basin.summit], m_load[pass], height_N))
            basin.parent = highest;
    }
}

void ContactSegmenter::measure() {
    const std::int32_t columns = m_layout.columns;
    const double centreColumn = 0.5 * (columns - 1);
    const double centreRow = 0.5 * (m_layout.rows - 1);
    for (Run& segment : m_segments) {
        segment.basin = rootOf(segment.basin);
        const std::int32_t firstColumn = segment.begin - segment.row * columns;
        double load = 0.0;
        double loadX = 0.0;
        double x = firstColumn - centreColumn;
        for (std::int32_t i = segment.begin; i < segment.end; ++i, x += 1.0) {
            const auto value = static_cast<double>(m_load[i]);
            load += value;
            loadX += value * x;
        }
        Basin& basin = m_basins[segment.basin];
        basin.load += load;
        basin.loadX += loadX;
        basin.loadY += load * (segment.row - centreRow);
        basin.taxels += segment.end - segment.begin;
        basin.minRow = segment.row;
        basin.maxRow = std::max(basin.maxRow, segment.row);
        basin.minColumn = std::min(basin.minColumn, firstColumn);
        basin.maxColumn = std::max(basin.maxColumn, firstColumn + segment.end - segment.begin - 1);
    }
}

void ContactSegmenter::number() {
    m_order.clear();
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(m_basins.size()); ++i) {
        if (m_basins[i].parent == i && m_basins[i].taxels >= m_settings.minimumTaxels)
            m_order.push_back(i);
    }
    std::sort(m_order.begin(), m_order.end(), [&](std::int32_t a, std::int32_t b) {
        return m_basins[a].load != m_basins[b].load ? m_basins[a].load > m_basins[b].load
                                                    : isHigher(m_basins[a].summit, m_basins[b].summit);
    });
    for (const std::int32_t index : m_order) {
        Basin& basin = m_basins[index];
        basin.region = static_cast<std::int32_t>(m_contacts.size()) + 1;
        m_contacts.push_back({.region = basin.region,
                              .x_m = m_layout.pitchX_m * (basin.loadX / basin.load),
                              .y_m = m_layout.pitchY_m * (basin.loadY / basin.load),
                              .force_N = basin.load,
                              .peak_N = static_cast<double>(m_load[basin.summit]),
                              .area_m2 = basin.taxels * m_layout.taxelArea_m2(),
                              .taxels = basin.taxels,
                              .minRow = basin.minRow,
                              .maxRow = basin.maxRow,
                              .minColumn = basin.minColumn,
                              .maxColumn = basin.maxColumn});
    }
    for (const Run& segment : m_segments)
        std::fill(m_labels.begin() + segment.begin, m_labels.begin() + segment.end,
                  m_basins[segment.basin].region);
}

} // namespace teleta::contact
