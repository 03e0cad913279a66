// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/taxel_grid.h"

#include "backend/core/keys/key_lists.h"
#include "devices/taxels/taxels_text.h"

#include <QString>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace teleta::taxels {

namespace {

using core::Need;
using core::NumberRange;

constexpr double kMostPitch_mm = 1000.0;
constexpr double kOffGrid = 0.01; ///< of the pitch
constexpr int kMostSide = core::ArrayLayout::kMaximumSide;

/// Adds the gaps between neighbouring coordinates that are no smaller than the pitch of the widest grid.
void appendGaps(std::vector<double> coordinates, std::vector<double>& gaps) {
    std::ranges::sort(coordinates);
    const double extent = coordinates.back() - coordinates.front();
    for (std::size_t i = 1; i < coordinates.size(); ++i)
        if (const double gap = coordinates[i] - coordinates[i - 1]; gap > 0.0 && gap >= extent / kMostSide)
            gaps.push_back(gap);
}

/// The number of a column or row at this coordinate; below 0: it is on none.
long long lineOf(double coordinate, double first, double pitch) {
    const double place = (coordinate - first) / pitch;
    const double nearest = std::round(place);
    return std::abs(place - nearest) <= kOffGrid && nearest < kMostSide ? static_cast<long long>(nearest)
                                                                        : -1;
}

using Lines = std::pair<long long, long long>; ///< row and column

/// Of each place on a grid of this pitch; empty: not all of them are on it, or two are the same.
std::vector<Lines> linesOf(const std::vector<double>& x, const std::vector<double>& y, double pitch) {
    const double firstX = *std::ranges::min_element(x);
    const double firstY = *std::ranges::min_element(y);
    std::vector<Lines> found;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Lines lines{lineOf(y[i], firstY, pitch), lineOf(x[i], firstX, pitch)};
        if (lines.first < 0 || lines.second < 0)
            return {};
        found.push_back(lines);
    }
    if (std::set(found.begin(), found.end()).size() != found.size())
        return {};
    return found;
}

} // namespace

void TaxelGrid::place(std::span<const float> values, std::span<float> loads) const {
    std::ranges::fill(loads, std::numeric_limits<float>::quiet_NaN());
    if (m_components == 1) {
        for (std::size_t i = 0; i < m_places.size(); ++i)
            loads[m_places[i]] = values[i];
        return;
    }
    for (std::size_t i = 0; i < m_places.size(); ++i)
        loads[m_places[i]] = m_pressing * values[i * static_cast<std::size_t>(m_components) + m_normal];
}

bool TaxelGrid::standAt(const std::vector<std::vector<double>>& positions_mm) {
    std::vector<double> x;
    std::vector<double> y;
    for (const std::vector<double>& position : positions_mm) {
        x.push_back(position[0]);
        y.push_back(position[1]);
    }
    const auto isFinite = [](double coordinate) { return std::isfinite(coordinate); };
    if (x.empty() || !std::ranges::all_of(x, isFinite) || !std::ranges::all_of(y, isFinite))
        return false;
    std::vector<double> pitches;
    appendGaps(x, pitches);
    appendGaps(y, pitches);
    if (x.size() == 1)
        pitches = {1.0}; // of a single taxel nothing depends on it
    // The largest come first: a small gap may only be what taxels of one column or row are off it.
    std::ranges::sort(pitches, std::greater<>());
    std::vector<Lines> found;
    double pitch = 0.0;
    for (auto next = pitches.begin(); found.empty() && next != pitches.end(); ++next) {
        pitch = *next;
        found = linesOf(x, y, pitch);
    }
    if (found.empty())
        return false;
    long long rows = 0;
    long long columns = 0;
    for (const auto& [row, column] : found) {
        rows = std::max(rows, row + 1);
        columns = std::max(columns, column + 1);
    }
    m_layout = {static_cast<int>(rows), static_cast<int>(columns), pitch * 1e-3};
    m_places.clear();
    for (const auto& [row, column] : found)
        m_places.push_back(static_cast<std::size_t>(row * columns + column));
    return true;
}

bool TaxelGrid::setAxes(const std::vector<std::string>& axes) {
    if (axes.size() != kMostComponents)
        return false;
    std::set<char> seen;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const std::string& axis = axes[i];
        if (axis.size() != 2 || (axis[0] != '+' && axis[0] != '-') || axis[1] < 'x' || axis[1] > 'z')
            return false;
        seen.insert(axis[1]);
        if (axis[1] == 'z') {
            m_normal = i;
            m_pressing = axis[0] == '+' ? -1.0F : 1.0F;
        }
    }
    return seen.size() == kMostComponents;
}

void TaxelGrid::describeKeys(core::Keys& keys) {
    keys.whole("components", m_components, {1, kMostComponents},
               "Numbers of a taxel: 1, its load, or 3, a force or field in x, y and z", Need::optional);
    if (m_components == 2)
        refuse(keys, "components", TaxelsText::tr("a taxel tells its load or three components"),
               TaxelsText::tr("1 or 3"));
    describeAxes(keys);
    describePlaces(keys);
    keys.text("unit", m_unit, "Unit of the values, shown with every load", Need::optional);
}

void TaxelGrid::describeAxes(core::Keys& keys) {
    std::vector<std::string> axes{"+x", "+y", "+z"};
    core::describeTexts(keys, "axes", axes,
                        "Which axis of the array each of three components is: x along the columns, y along "
                        "the rows, z out of the surface. What presses is shown",
                        Need::optional);
    if (!setAxes(axes))
        refuse(keys, "axes", TaxelsText::tr("these are no three axes"),
               TaxelsText::tr("each axis once with its sign, as [\"+x\", \"-y\", \"-z\"]"));
}

void TaxelGrid::describePlaces(core::Keys& keys) {
    std::vector<std::vector<double>> positions_mm;
    core::describeRows(
        keys, "positions_mm", positions_mm, NumberRange::between(-1e4, 1e4), 0, 2,
        "Place of each taxel, x and y, in the order in which they come, instead of a grid. They "
        "have to lie on the lines of a square grid",
        Need::optional);
    if (positions_mm.empty())
        describeGrid(keys);
    else if (!standAt(positions_mm))
        refuse(keys, "positions_mm", TaxelsText::tr("the places lie on no square grid"),
               TaxelsText::tr("different places whose distances in x and y are multiples of one pitch"));
}

void TaxelGrid::describeGrid(core::Keys& keys) {
    const NumberRange pitch = NumberRange::positiveUpTo(kMostPitch_mm);
    keys.whole("rows", m_layout.rows, {1, kMostSide}, "Rows of taxels; without `positions_mm`");
    keys.whole("columns", m_layout.columns, {1, kMostSide}, "Taxels in a row; without `positions_mm`");
    double pitchX_mm = 1.0;
    keys.number("pitch_x_mm", pitchX_mm, pitch, "Distance between the columns");
    std::optional<double> pitchY_mm;
    keys.number("pitch_y_mm", pitchY_mm, pitch, "Distance between the rows; otherwise that of the columns");
    if (pitchY_mm && *pitchY_mm != pitchX_mm)
        refuse(
            keys, "pitch_y_mm",
            TaxelsText::tr("the taxels are %1 mm apart in x and %2 mm in y").arg(pitchX_mm).arg(*pitchY_mm),
            TaxelsText::tr("square cells"));
    m_layout.pitch_m = pitchX_mm / 1e3;

    constexpr long long kMostPlaces = static_cast<long long>(kMostSide) * kMostSide;
    Order order = Order::row;
    keys.choice("order", order, {{"row", "Row by row"}, {"column", "Column by column"}},
                "In which order the taxels come", Need::optional);
    std::vector<double> mask;
    core::describeList(keys, "mask", mask, NumberRange::notNegative(), {0, kMostPlaces},
                       "Places without a taxel; they count row by row from 0", Need::optional);
    std::vector<double> places;
    core::describeList(keys, "places", places, NumberRange::notNegative(), {1, kMostPlaces},
                       "Place of each taxel in the order in which they come, instead of `order` and `mask`",
                       Need::optional);
    const std::set<double> different(places.begin(), places.end());
    const auto isPlace = [this](double value) {
        return value >= 0.0 && value == std::floor(value) && value < static_cast<double>(m_layout.taxels());
    };
    if (!std::ranges::all_of(mask, isPlace) || mask.size() >= m_layout.taxels())
        refuse(keys, "mask", TaxelsText::tr("these are no places without a taxel"),
               TaxelsText::tr("numbers from 0 to %1, and at least one place with a taxel")
                   .arg(m_layout.taxels() - 1));
    else if (different.size() != places.size() || !std::ranges::all_of(places, isPlace))
        refuse(keys, "places", TaxelsText::tr("these are no places of taxels"),
               TaxelsText::tr("numbers from 0 to %1, each once").arg(m_layout.taxels() - 1));
    else if (!places.empty() && !mask.empty())
        refuse(keys, "mask", TaxelsText::tr("\"places\" says already where no taxel is"),
               TaxelsText::tr("either places or mask"));
    else if (places.empty())
        m_places = inOrder(order, mask);
    else
        m_places.assign(places.begin(), places.end());
}

std::vector<std::size_t> TaxelGrid::inOrder(Order order, const std::vector<double>& mask) const {
    const std::set<std::size_t> without(mask.begin(), mask.end());
    const auto rows = static_cast<std::size_t>(m_layout.rows);
    const auto columns = static_cast<std::size_t>(m_layout.columns);
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < m_layout.taxels(); ++i) {
        const std::size_t place = order == Order::row ? i : i % rows * columns + i / rows;
        if (!without.contains(place))
            places.push_back(place);
    }
    return places;
}

} // namespace teleta::taxels
