// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/contour_order.h"

#include "backend/core/quantile.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>

namespace teleta::contour {

namespace {

constexpr std::size_t kPointsForRejection = 6;
constexpr std::size_t kPointsOfLap = 4;
constexpr double kGrossFactor = 3.0;
constexpr double kGrossFloor =
    1e-3; ///< of the bounding box; the median of points in one place is not quite there
constexpr double kSpikeSteps = 3.0;
constexpr double kClosingSteps = 1.6;
constexpr double kNearSteps = 2.0;
constexpr double kClosingSize = 0.75;

double distance(const Point& a, const Point& b) {
    return (a - b).norm();
}

double largestDistance(std::span<const Point> points) {
    double largest = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            largest = std::max(largest, (points[i] - points[k]).squaredNorm());
    return std::sqrt(largest);
}

/// For each point the (skipped + 1)-th largest distance to another one; of these the (skipped + 1)-th
/// largest.
double robustSize(std::span<const Point> points) {
    const std::size_t n = points.size();
    const std::size_t skipped = n < kPointsForRejection ? 0 : std::max<std::size_t>(1, n / 20);
    std::vector<double> farthest(n);
    std::vector<double> largest(skipped + 1); // the largest first
    for (std::size_t i = 0; i < n; ++i) {
        std::ranges::fill(largest, 0.0);
        for (std::size_t k = 0; k < n; ++k) {
            const double distance2 = (points[i] - points[k]).squaredNorm();
            std::size_t place = skipped;
            if (distance2 <= largest[place])
                continue;
            for (; place > 0 && distance2 > largest[place - 1]; --place)
                largest[place] = largest[place - 1];
            largest[place] = distance2;
        }
        farthest[i] = largest[skipped];
    }
    return std::sqrt(core::orderStatistic(farthest, n - 1 - skipped));
}

double usualStep(std::span<const Point> points) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < points.size(); ++i)
        steps.push_back(distance(points[i], points[i - 1]));
    return core::orderStatistic(steps, 3 * steps.size() / 4);
}

/// Position of the foot of p on a closed polygon: index of the edge plus the share along it.
double footOnPolygon(std::span<const Point> polygon, const Point& p) {
    double best = std::numeric_limits<double>::infinity();
    double place = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& a = polygon[i];
        const Point edge = polygon[(i + 1) % polygon.size()] - a;
        const double length2 = edge.squaredNorm();
        const double share = length2 > 0.0 ? std::clamp((p - a).dot(edge) / length2, 0.0, 1.0) : 0.0;
        const double away = distance(p, a + share * edge);
        if (away < best) {
            best = away;
            place = static_cast<double>(i) + share;
        }
    }
    return place;
}

/// Index of the first point that has completed a turn about a centre and is near the start again; the number
/// of points when there is none. A step turns by less than half a turn.
std::size_t endOfTurn(std::span<const Point> points, const Point& centre,
                      const std::vector<bool>& nearStart) {
    const Point first = points.front() - centre;
    // Whole turns completed in either direction, from where the steps cross the ray through the first point.
    int left = 0;
    int right = 0;
    Point a = first;
    double sideOfA = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Point b = points[i] - centre;
        const double sideOfB = cross(first, b);
        if ((sideOfA < 0.0) != (sideOfB < 0.0) || (sideOfA > 0.0) != (sideOfB > 0.0)) {
            const bool toTheLeft = cross(a, b) > 0.0;
            // Whether the step crosses the ray itself, and not what lies behind the centre.
            if (toTheLeft ? sideOfA < 0.0 && sideOfB >= 0.0 : sideOfA >= 0.0 && sideOfB < 0.0)
                left += toTheLeft ? 1 : -1;
            if (toTheLeft ? sideOfA <= 0.0 && sideOfB > 0.0 : sideOfA > 0.0 && sideOfB <= 0.0)
                right += toTheLeft ? -1 : 1;
        }
        if (nearStart[i] && (left >= 1 || right >= 1))
            return i;
        a = b;
        sideOfA = sideOfB;
    }
    return points.size();
}

/// Index of the first point that has completed more than one turn about a place deep inside the contour; the
/// number of points when there is none.
std::size_t endOfFirstLap(std::span<const Point> points) {
    constexpr int kGrid = 8;
    Point low = points.front();
    Point high = points.front();
    for (const Point& p : points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    std::vector<std::pair<double, Point>> centres;
    for (int i = 1; i < kGrid; ++i)
        for (int k = 1; k < kGrid; ++k) {
            const Point centre = low + Point(i, k).cwiseProduct(high - low) / kGrid;
            double nearest = std::numeric_limits<double>::infinity();
            for (const Point& p : points)
                nearest = std::min(nearest, (p - centre).squaredNorm());
            centres.emplace_back(nearest, centre);
        }
    std::ranges::stable_sort(centres, std::ranges::greater{}, &std::pair<double, Point>::first);
    const double near = kNearSteps * usualStep(points);
    std::vector<bool> nearStart(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        nearStart[i] = distance(points[i], points.front()) <= near;
    for (const auto& [distance2, centre] : centres)
        if (const std::size_t end = endOfTurn(points, centre, nearStart); end < points.size())
            return end;
    return points.size();
}

} // namespace

PreparedContour prepare(std::span<const Point> points_m) {
    PreparedContour prepared;
    if (points_m.empty())
        return prepared;
    const std::size_t count = std::min(points_m.size(), PreparedContour::kMaximumPoints);
    std::vector<Point> kept;
    kept.reserve(count);
    double box_m = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const Point p = points_m[i * points_m.size() / count] - points_m.front();
        kept.push_back(p);
        box_m = std::max(box_m, p.cwiseAbs().maxCoeff());
    }
    if (box_m == 0.0) {
        prepared.centre_m = points_m.front();
        prepared.points = std::move(kept);
        return prepared;
    }
    // In units of the bounding box squared distances neither overflow nor underflow.
    for (Point& p : kept)
        p /= box_m;

    double size = robustSize(kept);
    if (kept.size() >= kPointsForRejection) {
        const Point middle = spatialMedian(kept);
        const double limit = std::max(kGrossFactor * size, kGrossFloor);
        prepared.rejected = std::erase_if(kept, [&](const Point& p) { return distance(p, middle) > limit; });
    }
    const double extent = largestDistance(kept);
    if (size == 0.0)
        size = extent;
    const Point centre =
        std::accumulate(kept.begin(), kept.end(), Point(Point::Zero())) / static_cast<double>(kept.size());
    prepared.centre_m = points_m.front() + box_m * centre;
    prepared.size_m = box_m * size;
    prepared.extent_m = box_m * extent;
    prepared.points.reserve(kept.size());
    // A repeated point adds no information.
    for (std::size_t i = 0; i < kept.size(); ++i)
        if (i == 0 || kept[i] != kept[i - 1])
            prepared.points.push_back(size > 0.0 ? Point((kept[i] - centre) / size) : Point::Zero());
    return prepared;
}

Point spatialMedian(std::span<const Point> points) {
    if (points.empty())
        return Point::Zero();
    Point median = std::accumulate(points.begin(), points.end(), Point(Point::Zero())) /
                   static_cast<double>(points.size());
    double spread = 0.0;
    for (const Point& p : points)
        spread = std::max(spread, distance(p, median));
    if (spread == 0.0)
        return median;
    // Weiszfeld's iteration; a point at the estimate itself must not get infinite weight.
    for (int iteration = 0; iteration < 50; ++iteration) {
        Point sum = Point::Zero();
        double weights = 0.0;
        for (const Point& p : points) {
            const double weight = spread / std::max(distance(p, median), 1e-6 * spread);
            sum += weight * p;
            weights += weight;
        }
        const Point next = sum / weights;
        const bool settled = distance(next, median) < 1e-6 * spread;
        median = next;
        if (settled)
            break;
    }
    return median;
}

std::vector<Point> orderedByAngle(std::span<const Point> points) {
    const Point centre = spatialMedian(points);
    std::vector<std::pair<double, Point>> angles;
    angles.reserve(points.size());
    for (const Point& p : points)
        angles.emplace_back(std::atan2(p.y() - centre.y(), p.x() - centre.x()), p);
    std::ranges::stable_sort(angles, {}, &std::pair<double, Point>::first);
    std::vector<Point> ordered;
    ordered.reserve(points.size());
    for (const auto& [angle, p] : angles)
        ordered.push_back(p);
    return ordered;
}

bool isSameLap(std::span<const Point> a, std::span<const Point> b) {
    const std::size_t n = a.size();
    if (n != b.size() || n == 0)
        return false;
    const auto first = static_cast<std::size_t>(std::ranges::find(b, a.front()) - b.begin());
    if (first == n)
        return false;
    const auto same = [&](std::size_t step) {
        for (std::size_t i = 0, k = first; i < n; ++i, k = (k + step) % n)
            if (a[i] != b[k])
                return false;
        return true;
    };
    return same(1) || same(n - 1);
}

std::vector<Point> mergedLaps(std::span<const Point> points) {
    std::vector<Point> merged(points.begin(), points.end());
    if (points.size() < 2 * kPointsOfLap)
        return merged;
    const std::size_t lapEnd = endOfFirstLap(points);
    if (lapEnd < kPointsOfLap || lapEnd >= points.size())
        return merged;
    const auto firstLap = points.first(lapEnd);
    std::vector<std::pair<double, Point>> places;
    places.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        places.emplace_back(i < lapEnd ? static_cast<double>(i) : footOnPolygon(firstLap, points[i]),
                            points[i]);
    std::ranges::stable_sort(places, {}, &std::pair<double, Point>::first);
    std::ranges::transform(places, merged.begin(), &std::pair<double, Point>::second);
    return merged;
}

std::vector<Point> withoutSpikes(std::span<const Point> points, bool closed) {
    const std::size_t n = points.size();
    std::vector<Point> kept(points.begin(), points.end());
    if (n < kPointsForRejection)
        return kept;
    const double step = usualStep(points);
    kept.clear();
    for (std::size_t i = 0; i < n; ++i) {
        const bool hasBoth = closed || (i > 0 && i + 1 < n);
        const Point& before = points[(i + n - 1) % n];
        const Point& after = points[(i + 1) % n];
        const double away = std::min(distance(points[i], before), distance(points[i], after));
        if (!(hasBoth && away > kSpikeSteps * step && distance(before, after) < 0.5 * away))
            kept.push_back(points[i]);
    }
    return kept;
}

bool returnsToItsStart(std::span<const Point> points) {
    if (points.size() < 4)
        return false;
    const double gap = distance(points.front(), points.back());
    return gap <= kClosingSteps * usualStep(points) && gap <= kClosingSize;
}

} // namespace teleta::contour
