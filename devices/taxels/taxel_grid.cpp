// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/taxel_grid.h"

#include "backend/core/keys/key_lists.h"
#include "devices/taxels/taxels_text.h"

#include <QString>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

namespace teleta::taxels {

namespace {

using core::Need;
using core::NumberRange;

constexpr double kMostPitch_mm = 1000.0;
constexpr double kOffGrid = 0.01;     ///< of the pitch
constexpr double kLongestCell = 10.0; ///< length by width
constexpr int kMostSide = core::ArrayLayout::kMaximumSide;

/// The lines of a grid on which coordinates lie; pitch 0: all on one.
struct GridLines {
    double pitch = 0.0;
    std::vector<int> number; ///< of each coordinate, from 0
    int count = 0;
};

/// scatter: distance up to which coordinates lie on one line, whatever the pitch. Nothing: there is no pitch
/// of which all distances are multiples, or too many lines.
std::optional<GridLines> gridLinesOf(const std::vector<double>& coordinates, double scatter) {
    std::vector<double> sorted = coordinates;
    std::ranges::sort(sorted);
    const double extent = sorted.back() - sorted.front();
    std::vector<double> pitches;
    for (std::size_t i = 1; i < sorted.size(); ++i)
        if (const double gap = sorted[i] - sorted[i - 1]; gap > scatter && gap >= extent / kMostSide)
            pitches.push_back(gap);
    if (extent <= scatter)
        return GridLines{0.0, std::vector<int>(coordinates.size(), 0), 1};
    // The largest come first: a small gap may only be what taxels of one line are off it.
    std::ranges::sort(pitches, std::greater<>());
    for (const double pitch : pitches) {
        GridLines lines{pitch, {}, 0};
        for (const double coordinate : coordinates) {
            const double place = (coordinate - sorted.front()) / pitch;
            const double nearest = std::round(place);
            if (std::abs(place - nearest) > kOffGrid || nearest >= kMostSide)
                break;
            lines.number.push_back(static_cast<int>(nearest));
            lines.count = std::max(lines.count, lines.number.back() + 1);
        }
        if (lines.number.size() == coordinates.size())
            return lines;
    }
    return std::nullopt;
}

/// Moves the middle of the box around the places to the origin of x and y.
void centre(std::vector<core::TaxelPlace>& places) {
    const auto [left, right] = std::ranges::minmax(places, {}, &core::TaxelPlace::x_m);
    const auto [low, high] = std::ranges::minmax(places, {}, &core::TaxelPlace::y_m);
    const double x_m = 0.5 * (left.x_m + right.x_m);
    const double y_m = 0.5 * (low.y_m + high.y_m);
    for (core::TaxelPlace& place : places) {
        place.x_m -= x_m;
        place.y_m -= y_m;
    }
}

/// Whether each row has a length.
bool setNormals(const std::vector<std::vector<double>>& rows, std::vector<core::TaxelPlace>& places) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double length = std::hypot(rows[i][0], rows[i][1], rows[i][2]);
        if (!(length > 0.0))
            return false;
        places[i].normal = {rows[i][0] / length, rows[i][1] / length, rows[i][2] / length};
    }
    return true;
}

} // namespace

core::TaxelLayout TaxelGrid::layout() const {
    if (m_free)
        return core::TaxelLayout(m_free, m_components);
    core::TaxelLayout layout(m_grid, m_components);
    std::vector<std::uint8_t> absent(m_grid.taxels(), 1);
    for (const std::size_t place : m_places)
        absent[place] = 0;
    layout.setAbsent(std::move(absent));
    return layout;
}

void TaxelGrid::place(std::span<const float> values, std::span<float> frame) const {
    std::ranges::fill(frame, std::numeric_limits<float>::quiet_NaN());
    if (m_components == 1) {
        for (std::size_t i = 0; i < m_places.size(); ++i)
            frame[m_places[i]] = values[i];
        return;
    }
    for (std::size_t i = 0; i < m_places.size(); ++i)
        for (std::size_t k = 0; k < kMostComponents; ++k)
            frame[kMostComponents * m_places[i] + m_axis[k]] = m_sign[k] * values[kMostComponents * i + k];
}

bool TaxelGrid::standOnGrid(const std::vector<core::TaxelPlace>& places) {
    std::vector<double> x_m;
    std::vector<double> y_m;
    for (const core::TaxelPlace& place : places) {
        if (place.z_m != 0.0 || place.normal != core::TaxelPlace{}.normal)
            return false;
        x_m.push_back(place.x_m);
        y_m.push_back(place.y_m);
    }
    double nearest_m = std::numeric_limits<double>::infinity();
    const core::TaxelPlaces all(places);
    for (std::size_t i = 0; i < places.size(); ++i)
        nearest_m = std::min(nearest_m, all.spacing_m(i));
    const auto columns = gridLinesOf(x_m, 2.0 * kOffGrid * nearest_m);
    const auto rows = gridLinesOf(y_m, 2.0 * kOffGrid * nearest_m);
    if (!columns || !rows ||
        2 * places.size() < static_cast<std::size_t>(rows->count) * static_cast<std::size_t>(columns->count))
        return false;
    // Of a single row or column the other pitch counts, of a single taxel none.
    double pitchX_m = columns->pitch > 0.0 ? columns->pitch : rows->pitch;
    double pitchY_m = rows->pitch > 0.0 ? rows->pitch : pitchX_m;
    if (std::abs(pitchX_m - pitchY_m) <= kOffGrid * pitchX_m)
        pitchX_m = pitchY_m = std::max(pitchX_m, pitchY_m);
    // A cell that is much longer than wide only looks like one.
    if (std::max(pitchX_m, pitchY_m) > kLongestCell * std::min(pitchX_m, pitchY_m))
        return false;
    m_grid = pitchX_m > 0.0 ? core::ArrayLayout{rows->count, columns->count, pitchX_m, pitchY_m}
                            : core::ArrayLayout{1, 1, core::TaxelPlaces::kLoneSpacing_m};
    m_places.clear();
    for (std::size_t i = 0; i < places.size(); ++i)
        m_places.push_back(static_cast<std::size_t>(rows->number[i]) *
                               static_cast<std::size_t>(columns->count) +
                           static_cast<std::size_t>(columns->number[i]));
    return std::set(m_places.begin(), m_places.end()).size() == m_places.size();
}

void TaxelGrid::standAt(std::vector<core::TaxelPlace> places) {
    if (standOnGrid(places))
        return;
    centre(places);
    m_places.resize(places.size());
    std::iota(m_places.begin(), m_places.end(), std::size_t{0});
    m_free = std::make_shared<const core::TaxelPlaces>(std::move(places));
}

bool TaxelGrid::describePositions(core::Keys& keys, std::size_t count, core::Need need) {
    const NumberRange range = NumberRange::between(-1e4, 1e4);
    std::vector<std::vector<double>> positions_mm;
    core::describeRows(keys, "positions_mm", positions_mm, range, count, 2,
                       "Place of each taxel, x and y, in the order in which they come. The middle of the box "
                       "around them is the origin",
                       need);
    std::vector<double> heights_mm;
    core::describeList(keys, "heights_mm", heights_mm, range, {1, core::TaxelPlaces::kMost},
                       "z of each position; otherwise 0", Need::optional);
    std::vector<std::vector<double>> normals;
    core::describeRows(keys, "normals", normals, range, 0, 3,
                       "Direction out of the surface at each position, x, y and z; otherwise z. Of three "
                       "components, the load is the one against it",
                       Need::optional);
    const std::size_t taxels = positions_mm.size();
    const auto ofEach = [&](std::size_t given, std::string_view key) {
        if (given == 0 || given == taxels)
            return true;
        refuse(keys, key, TaxelsText::tr("there are %1 positions").arg(taxels),
               TaxelsText::tr("one entry a position"));
        return false;
    };
    if (!ofEach(heights_mm.size(), "heights_mm") || !ofEach(normals.size(), "normals") || taxels == 0)
        return taxels > 0;
    if (taxels > core::TaxelPlaces::kMost) {
        refuse(keys, "positions_mm", TaxelsText::tr("there are %1 positions").arg(taxels),
               TaxelsText::tr("at most %1; more of them on a grid").arg(core::TaxelPlaces::kMost));
        return true;
    }
    std::vector<core::TaxelPlace> places;
    for (std::size_t i = 0; i < taxels; ++i)
        places.push_back({positions_mm[i][0] / 1e3, positions_mm[i][1] / 1e3,
                          heights_mm.empty() ? 0.0 : heights_mm[i] / 1e3});
    if (!setNormals(normals, places))
        refuse(keys, "normals", TaxelsText::tr("a normal is zero"),
               TaxelsText::tr("other numbers than [0, 0, 0]"));
    else if (const auto same = core::TaxelPlaces::sameOf(places))
        refuse(keys, "positions_mm",
               TaxelsText::tr("taxels %1 and %2 are at the same place").arg(same->first).arg(same->second),
               TaxelsText::tr("different places; they count from 0"));
    else
        standAt(std::move(places));
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
        m_axis[i] = static_cast<std::size_t>(axis[1] - 'x');
        m_sign[i] = axis[0] == '+' ? 1.0F : -1.0F;
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
    keys.number("newtons_per_unit", m_newtonsPerUnit, NumberRange::positive(),
                "What one unit is in N; loads are then shown in N. Otherwise they stay in their unit");
}

void TaxelGrid::describeAxes(core::Keys& keys) {
    std::vector<std::string> axes{"+x", "+y", "+z"};
    core::describeTexts(keys, "axes", axes,
                        "Which axis of the array each of three components is: x along the columns, y along "
                        "the rows, z out of the surface. What presses is a negative force along z",
                        Need::optional);
    if (!setAxes(axes))
        refuse(keys, "axes", TaxelsText::tr("these are not three distinct axes"),
               TaxelsText::tr("each axis once with its sign, as [\"+x\", \"-y\", \"-z\"]"));
}

void TaxelGrid::describePlaces(core::Keys& keys) {
    if (!describePositions(keys, 0, Need::optional))
        describeGrid(keys);
}

void TaxelGrid::describeGrid(core::Keys& keys) {
    const NumberRange pitch = NumberRange::positiveUpTo(kMostPitch_mm);
    keys.whole("rows", m_grid.rows, {1, kMostSide}, "Rows of taxels; without `positions_mm`");
    keys.whole("columns", m_grid.columns, {1, kMostSide}, "Taxels in a row; without `positions_mm`");
    double pitchX_mm = 1.0;
    keys.number("pitch_x_mm", pitchX_mm, pitch, "Distance between the columns");
    std::optional<double> pitchY_mm;
    keys.number("pitch_y_mm", pitchY_mm, pitch, "Distance between the rows; otherwise that of the columns");
    m_grid.pitchX_m = pitchX_mm / 1e3;
    m_grid.pitchY_m = pitchY_mm.value_or(pitchX_mm) / 1e3;

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
        return value >= 0.0 && value == std::floor(value) && value < static_cast<double>(m_grid.taxels());
    };
    if (!std::ranges::all_of(mask, isPlace) || mask.size() >= m_grid.taxels())
        refuse(keys, "mask", TaxelsText::tr("this mask does not fit the array"),
               TaxelsText::tr("numbers from 0 to %1, and at least one place with a taxel")
                   .arg(m_grid.taxels() - 1));
    else if (different.size() != places.size() || !std::ranges::all_of(places, isPlace))
        refuse(keys, "places", TaxelsText::tr("these are no places of taxels"),
               TaxelsText::tr("numbers from 0 to %1, each once").arg(m_grid.taxels() - 1));
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
    const auto rows = static_cast<std::size_t>(m_grid.rows);
    const auto columns = static_cast<std::size_t>(m_grid.columns);
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < m_grid.taxels(); ++i) {
        const std::size_t place = order == Order::row ? i : i % rows * columns + i / rows;
        if (!without.contains(place))
            places.push_back(place);
    }
    return places;
}

} // namespace teleta::taxels
