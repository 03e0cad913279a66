// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/marker_detector.h"

#include "backend/core/quantile.h"

#include <Eigen/LU>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace teleta::vision {

namespace {

constexpr double kNearShare = 0.7;
constexpr double kFarShare = 2.0;
/// Share of the contrast that counts as fully dark: what crosses a marker and is darker counts no more than
/// it.
constexpr double kFullShade = 0.6;
constexpr double kCoreShare = 0.3; ///< radius of a marker's middle, in diameters
constexpr int kCentreSteps = 15;
constexpr double kRimShare = 0.3; ///< half width of the rim that is weighed, in diameters
constexpr double kLeastRim_px = 1.5;
constexpr double kSettled_px = 0.005;
constexpr double kCutShare = 0.4;       ///< least distance of the centre from the border, in diameters
constexpr double kSmallest_px = 3.0;    ///< diameters that are searched
constexpr double kLargestShare = 0.125; ///< of the shorter side
constexpr double kDiameterStep = 1.15;
constexpr double kLeastLevels = 4.0; ///< what stands out less is noise of the camera
constexpr std::size_t kLeastSpots = 4;

constexpr int kLanes = 8;

double sumOf(const std::array<float, kLanes>& lanes) {
    double sum = 0.0;
    for (const float lane : lanes)
        sum += static_cast<double>(lane);
    return sum;
}

int oddSize(double size_px) {
    return 2 * std::max(0, static_cast<int>(std::lround(0.5 * (size_px - 1.0)))) + 1;
}

/// Vertex of the parabola through three values, -0.5 .. 0.5.
double vertex(double before, double here, double after) {
    const double curvature = before - 2.0 * here + after;
    return curvature < 0.0 ? std::clamp(0.5 * (before - after) / curvature, -0.5, 0.5) : 0.0;
}

/// Grey level of what surrounds a marker, relative to the pixel in its middle.
struct GroundPlane {
    double level = 0.0, alongU = 0.0, alongV = 0.0;
    [[nodiscard]] double at(double du, double dv) const { return level + alongU * du + alongV * dv; }
};

} // namespace

MarkerDetector::MarkerDetector(double diameter_px, double apart_px)
    : m_diameter_px(diameter_px)
    , m_window_px(0.75 * diameter_px + 1.0)
    , m_innerRing_px(m_window_px)
    , m_ring_px(m_innerRing_px + std::max(1.5, 0.2 * diameter_px))
    , m_apart_px(oddSize(diameter_px))
    , m_square(cv::getStructuringElement(cv::MORPH_RECT, {m_apart_px, m_apart_px})) {
    if (apart_px > 0.0) {
        m_window_px = std::min(m_window_px, std::max(0.5 * diameter_px + 0.5, apart_px - 0.6 * diameter_px));
        m_innerRing_px = m_window_px;
        m_ring_px = std::min(m_ring_px, std::max(m_innerRing_px + 1.0, apart_px - 0.5 * diameter_px));
    }
}

double MarkerDetector::within_px() const {
    return std::max(1.5, 0.5 * m_diameter_px);
}

void MarkerDetector::spots(const cv::Mat1b& picture, double leastContrast, std::vector<MarkerSpot>& found,
                           double shadeShare) {
    found.clear();
    const int nearSize = oddSize(kNearShare * m_diameter_px);
    const int farSize = oddSize(kFarShare * m_diameter_px);
    if (picture.rows <= farSize || picture.cols <= farSize)
        return;
    cv::blur(picture, m_far, {farSize, farSize}, {-1, -1}, cv::BORDER_REPLICATE);
    const cv::Mat1b* read = &picture;
    if (shadeShare > 0.0) {
        m_far.convertTo(m_held, CV_8U, shadeShare);
        const cv::Mat& seen = picture;
        cv::Mat& held = m_held; // std::max would fit the derived type better
        cv::max(seen, held, held);
        read = &m_held;
    }
    cv::blur(*read, m_near, {nearSize, nearSize}, {-1, -1}, cv::BORDER_REPLICATE);
    cv::subtract(m_far, m_near, m_response); // saturates at 0
    cv::dilate(m_response, m_highest, m_square);
    const auto least = static_cast<std::uint8_t>(std::clamp(std::ceil(leastContrast), 1.0, 255.0));
    const int last = picture.cols - 1;
    const int lowest = picture.rows - 1;
    for (int v = 0; v < picture.rows; ++v) {
        const std::uint8_t* row = m_response[v];
        const std::uint8_t* highest = m_highest[v];
        for (int u = 0; u < picture.cols; ++u) {
            if (row[u] < least || row[u] != highest[u])
                continue;
            const double here = row[u];
            const double left = u > 0 ? row[u - 1] : here;
            const double right = u < last ? row[u + 1] : here;
            const double above = v > 0 ? m_response(v - 1, u) : here;
            const double below = v < lowest ? m_response(v + 1, u) : here;
            found.push_back({{u + vertex(left, here, right), v + vertex(above, here, below)}, here});
        }
    }
    // Neighbouring pixels of a flat summit count once: the first of them.
    const double close_px = 0.5 * m_apart_px;
    std::size_t kept = 0;
    for (const MarkerSpot& spot : found) {
        bool isNew = true;
        for (std::size_t i = kept; i-- > 0;) {
            const Eigen::Vector2d off = found[i].place_px - spot.place_px;
            if (-off.y() > m_apart_px)
                break;
            if (off.cwiseAbs().maxCoeff() <= close_px) {
                isNew = false;
                break;
            }
        }
        if (isNew)
            found[kept++] = spot;
    }
    found.resize(kept);
}

bool MarkerDetector::isInside(const cv::Mat1b& picture, const Eigen::Vector2d& place_px) const {
    const double margin_px = kCutShare * m_diameter_px - 0.5;
    return place_px.x() >= margin_px && place_px.y() >= margin_px &&
           place_px.x() <= picture.cols - 1 - margin_px && place_px.y() <= picture.rows - 1 - margin_px;
}

bool MarkerDetector::readShade(const cv::Mat1b& picture, const cv::Point& middle, double leastContrast,
                               double mostContrast, MarkerCentre& result) {
    const auto outer = static_cast<int>(m_ring_px);
    const auto outer2 = static_cast<int>(m_ring_px * m_ring_px);
    const auto inner2 = static_cast<int>(m_innerRing_px * m_innerRing_px);
    const int u0 = std::max(-outer, -middle.x);
    const int u1 = std::min(outer, picture.cols - 1 - middle.x);
    const int v0 = std::max(-outer, -middle.y);
    const int v1 = std::min(outer, picture.rows - 1 - middle.y);
    // The darker part of its middle: a glint there does not count.
    const int core = std::max(1, static_cast<int>(kCoreShare * m_diameter_px));
    m_levels.clear();
    for (int v = std::max(-core, v0); v <= std::min(core, v1); ++v) {
        for (int u = std::max(-core, u0); u <= std::min(core, u1); ++u) {
            if (u * u + v * v <= core * core)
                m_levels.push_back(picture(middle.y + v, middle.x + u));
        }
    }
    if (m_levels.empty())
        return false;
    const double darkest = core::lowerQuantileOf(m_levels, 0.3);
    GroundPlane ground;
    for (int round = 0; round < 2; ++round) {
        double n = 0.0, su = 0.0, sv = 0.0, suu = 0.0, suv = 0.0, svv = 0.0, s = 0.0, us = 0.0, vs = 0.0;
        for (int v = v0; v <= v1; ++v) {
            const std::uint8_t* row = picture[middle.y + v] + middle.x;
            for (int u = u0; u <= u1; ++u) {
                const int r2 = u * u + v * v;
                if (r2 > outer2 || r2 <= inner2)
                    continue;
                const double level = row[u];
                // What is much darker than the ground belongs to something else.
                if (round > 0 && level < 0.5 * (ground.at(u, v) + darkest))
                    continue;
                n += 1.0;
                su += u;
                sv += v;
                suu += u * u;
                suv += u * v;
                svv += v * v;
                s += level;
                us += level * u;
                vs += level * v;
            }
        }
        if (n < 6.0)
            return false;
        Eigen::Matrix3d normal;
        normal << n, su, sv, su, suu, suv, sv, suv, svv;
        const Eigen::Vector3d fit = normal.inverse() * Eigen::Vector3d(s, us, vs);
        if (!fit.allFinite())
            return false;
        ground = {fit[0], fit[1], fit[2]};
    }
    const double contrast = result.contrast = ground.level - darkest;
    result.ground = ground.level;
    if (!(contrast >= leastContrast) || !(contrast > 0.0))
        return false;
    const double scale = 1.0 / (kFullShade * std::min(contrast, mostContrast));
    m_reach = static_cast<int>(std::ceil(m_window_px)) + static_cast<int>(std::ceil(within_px()));
    const int side = 2 * m_reach + 1;
    m_stride = side + kLanes;
    m_shade.assign(static_cast<std::size_t>(side * m_stride + kLanes), 0.0F);
    for (int v = std::max(-m_reach, -middle.y); v <= std::min(m_reach, picture.rows - 1 - middle.y); ++v) {
        const std::uint8_t* row = picture[middle.y + v] + middle.x;
        float* shade = m_shade.data() + (v + m_reach) * m_stride + m_reach;
        const auto level = static_cast<float>(scale * ground.at(0.0, v));
        const auto slope = static_cast<float>(scale * ground.alongU);
        const auto unit = static_cast<float>(scale);
        const int right = std::min(m_reach, picture.cols - 1 - middle.x);
        for (int u = std::max(-m_reach, -middle.x); u <= right; ++u)
            shade[u] = std::clamp(level + slope * static_cast<float>(u) - unit * static_cast<float>(row[u]),
                                  0.0F, 1.0F);
    }
    return true;
}

std::optional<MarkerCentre> MarkerDetector::centre(const cv::Mat1b& picture, const Eigen::Vector2d& place_px,
                                                   double leastContrast, double mostContrast) {
    const cv::Point middle(static_cast<int>(std::lround(place_px.x())),
                           static_cast<int>(std::lround(place_px.y())));
    MarkerCentre result{.place_px = place_px};
    if (!isInside(picture, place_px) || !readShade(picture, middle, leastContrast, mostContrast, result))
        return std::nullopt;
    const double rim_px = 0.5 * m_diameter_px;
    const double width_px = std::max(kLeastRim_px, kRimShare * m_diameter_px);
    const double outer_px = rim_px + width_px;
    const Eigen::Vector2d start = place_px - Eigen::Vector2d(middle.x, middle.y);
    Eigen::Vector2d at = start;
    const double within2_px2 = within_px() * within_px();
    const auto rim = static_cast<float>(rim_px);
    const auto perWidth = static_cast<float>(1.0 / width_px);
    for (int step = 0; step < kCentreSteps; ++step) {
        // What lies opposite of a part outside of the picture would pull: it fades out.
        const auto mostU =
            static_cast<float>(std::min(middle.x + at.x(), picture.cols - 1 - middle.x - at.x()) + 0.5);
        const auto mostV =
            static_cast<float>(std::min(middle.y + at.y(), picture.rows - 1 - middle.y - at.y()) + 0.5);
        std::array<float, kLanes> gu4{}, gv4{}, huu4{}, huv4{}, hvv4{};
        const int top = std::max(-m_reach, static_cast<int>(std::ceil(at.y() - outer_px)));
        const int bottom = std::min(m_reach, static_cast<int>(std::floor(at.y() + outer_px)));
        for (int v = top; v <= bottom; ++v) {
            const auto dv = static_cast<float>(v - at.y());
            const double half = std::sqrt(std::max(0.0, outer_px * outer_px - static_cast<double>(dv * dv)));
            const int left = std::max(-m_reach, static_cast<int>(std::ceil(at.x() - half)));
            const int right = std::min(m_reach, static_cast<int>(std::floor(at.x() + half)));
            const float* shade = m_shade.data() + (v + m_reach) * m_stride + m_reach;
            const float inRow = std::clamp(mostV - std::abs(dv), 0.0F, 1.0F);
            for (int u = left; u <= right; u += kLanes) {
                const auto du0 = static_cast<float>(u - at.x());
                // What lies beyond the rim has no weight.
                for (int l = 0; l < kLanes; ++l) {
                    const auto k = static_cast<std::size_t>(l);
                    const float du = du0 + static_cast<float>(l);
                    const float r = std::sqrt(du * du + dv * dv + 1e-12F);
                    const float t = (r - rim) * perWidth;
                    const float inside = std::max(0.0F, 1.0F - t * t);
                    // w = (1 - t^2)^2, along the radius, and its slope by the place.
                    const float both = inRow * std::clamp(mostU - std::abs(du), 0.0F, 1.0F);
                    const float dark = shade[u + l] * inside * both;
                    const float w = dark * inside;
                    const float slope = -4.0F * t * dark * perWidth;
                    const float perR = 1.0F / r;
                    const float eu = du * perR;
                    const float ev = dv * perR;
                    const float round = w * perR;
                    gu4[k] += w * eu;
                    gv4[k] += w * ev;
                    huu4[k] += slope * eu * eu + round * ev * ev;
                    huv4[k] += (slope - round) * eu * ev;
                    hvv4[k] += slope * ev * ev + round * eu * eu;
                }
            }
        }
        const double gu = sumOf(gu4), gv = sumOf(gv4), huu = sumOf(huu4), huv = sumOf(huv4),
                     hvv = sumOf(hvv4);
        // Newton's step where the sum is curved downwards, else uphill.
        const Eigen::Vector2d gradient(gu, gv);
        const double determinant = huu * hvv - huv * huv;
        Eigen::Vector2d shift;
        if (huu + hvv > 0.0 && determinant > 0.05 * huu * hvv)
            shift = Eigen::Vector2d(hvv * gu - huv * gv, huu * gv - huv * gu) / determinant;
        else
            shift = gradient.norm() > 0.0 ? Eigen::Vector2d(0.5 * gradient.normalized())
                                          : Eigen::Vector2d::Zero();
        const double longest_px = std::max(0.5, 0.15 * m_diameter_px);
        if (shift.norm() > longest_px)
            shift *= longest_px / shift.norm();
        at += shift;
        if ((at - start).squaredNorm() > within2_px2)
            return std::nullopt;
        if (shift.squaredNorm() < kSettled_px * kSettled_px)
            break;
    }
    result.place_px = Eigen::Vector2d(middle.x, middle.y) + at;
    if (!isInside(picture, result.place_px))
        return std::nullopt;
    double mass = 0.0, suu = 0.0, suv = 0.0, svv = 0.0;
    const auto middleOf = [](double x) { return static_cast<int>(std::lround(x)); };
    const int reach = std::min(m_reach, static_cast<int>(m_window_px) + 1);
    for (int v = std::max(-m_reach, middleOf(at.y()) - reach);
         v <= std::min(m_reach, middleOf(at.y()) + reach); ++v) {
        for (int u = std::max(-m_reach, middleOf(at.x()) - reach);
             u <= std::min(m_reach, middleOf(at.x()) + reach); ++u) {
            const double du = u - at.x();
            const double dv = v - at.y();
            const double shade = static_cast<double>(
                m_shade[static_cast<std::size_t>((v + m_reach) * m_stride + u + m_reach)]);
            // Its border is where the contrast is half.
            const double dark = std::clamp(0.5 + (kFullShade * shade - 0.5) / 0.2, 0.0, 1.0);
            if (dark <= 0.0 || du * du + dv * dv > m_window_px * m_window_px)
                continue;
            mass += dark;
            suu += dark * du * du;
            suv += dark * du * dv;
            svv += dark * dv * dv;
        }
    }
    if (!(mass > 0.0))
        return std::nullopt;
    result.diameter_px = std::sqrt(4.0 / std::numbers::pi * mass);
    const double mean = 0.5 * (suu + svv) / mass;
    const double spread = std::hypot(0.5 * (suu - svv), suv) / mass;
    // 1/12: a pixel's own width.
    result.longness = std::sqrt((mean + spread + 1.0 / 12.0) / (std::max(0.0, mean - spread) + 1.0 / 12.0));
    return result;
}

std::vector<MarkerCentre> MarkerDetector::centres(const cv::Mat1b& picture) {
    std::vector<MarkerSpot> found;
    spots(picture, 1.0, found);
    const double least = partingContrast(found);
    std::vector<MarkerCentre> centres;
    if (!(least > 0.0))
        return centres;
    for (const MarkerSpot& spot : found) {
        if (spot.contrast < least)
            continue;
        if (const auto settled = centre(picture, spot.place_px, 0.5 * least))
            centres.push_back(*settled);
    }
    return centres;
}

double partingContrast(const std::vector<MarkerSpot>& spots) {
    // Otsu's parting of the logarithms: uneven light scales the contrast of all markers.
    std::vector<double> levels;
    levels.reserve(spots.size());
    for (const MarkerSpot& spot : spots)
        levels.push_back(std::log(std::max(1.0, spot.contrast)));
    if (levels.size() < kLeastSpots)
        return 0.0;
    std::ranges::sort(levels, std::greater<>());
    double total = 0.0;
    for (const double level : levels)
        total += level;
    // A picture in which all spots are markers has nothing to part.
    const double n = static_cast<double>(levels.size());
    double sum = 0.0;
    double best = 0.0;
    std::size_t above = levels.size();
    for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
        sum += levels[i];
        const double count = static_cast<double>(i + 1);
        const double apart = sum / count - (total - sum) / (n - count);
        const double between = count * (n - count) * apart * apart;
        if (i + 1 >= kLeastSpots && levels[i] > levels[i + 1] && between > best) {
            best = between;
            above = i + 1;
        }
    }
    constexpr double kOneClass = 1.1; // factor e^1.1 = 3 between the means
    double upper = 0.0;
    for (std::size_t i = 0; i < above; ++i)
        upper += levels[i];
    upper /= static_cast<double>(above);
    if (above < levels.size()) {
        double lower = 0.0;
        for (std::size_t i = above; i < levels.size(); ++i)
            lower += levels[i];
        lower /= static_cast<double>(levels.size() - above);
        if (upper - lower >= kOneClass) {
            const double parting = std::exp(0.5 * (levels[above - 1] + levels[above]));
            return std::exp(upper) >= kLeastLevels ? std::max(parting, 0.5 * kLeastLevels) : 0.0;
        }
        // One class: markers only, or texture only.
        const double range = levels.front() - levels.back();
        if (range > 2.0 * kOneClass)
            return 0.0;
    }
    return std::exp(levels.back()) >= kLeastLevels ? std::exp(levels.back()) : 0.0;
}

double findMarkerDiameter(const cv::Mat1b& picture) {
    const double largest_px = kLargestShare * std::min(picture.rows, picture.cols);
    double best = 0.0;
    double found_px = 0.0;
    std::vector<MarkerSpot> spots;
    std::vector<double> contrasts;
    for (double diameter_px = kSmallest_px; diameter_px <= largest_px; diameter_px *= kDiameterStep) {
        MarkerDetector detector(diameter_px);
        detector.spots(picture, 1.0, spots);
        const double least = partingContrast(spots);
        if (!(least > 0.0))
            continue;
        // The sum of squares of what stands out: many markers, seen whole.
        double score = 0.0;
        for (const MarkerSpot& spot : spots)
            score += spot.contrast >= least ? spot.contrast * spot.contrast : 0.0;
        if (score > best) {
            best = score;
            found_px = diameter_px;
        }
    }
    if (!(found_px > 0.0))
        return 0.0;
    // Then by the area of the markers themselves, twice, as the window follows the diameter.
    for (int round = 0; round < 2; ++round) {
        std::vector<double> diameters;
        for (const MarkerCentre& centre : MarkerDetector(found_px).centres(picture))
            diameters.push_back(centre.diameter_px);
        if (diameters.size() < kLeastSpots)
            return found_px;
        found_px = std::clamp(core::medianOf(diameters), kSmallest_px, std::max(kSmallest_px, largest_px));
    }
    return found_px;
}

} // namespace teleta::vision
