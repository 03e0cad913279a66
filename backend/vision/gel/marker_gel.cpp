// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/marker_gel.h"

#include "backend/core/failure.h"
#include "backend/core/quantile.h"

#include <QCoreApplication>

#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::vision {

namespace {

struct GelText {
    Q_DECLARE_TR_FUNCTIONS(GelText)
};

constexpr std::size_t kLeastMarkers = 4;
constexpr double kLeastOfGrid = 0.5;     ///< share of the rows x columns that must be seen
constexpr double kFlatLevels = 3.0;      ///< standard deviation of a picture without contrast
constexpr double kMostLong = 2.0;        ///< long axis over short axis of a marker
constexpr double kSmallestOfUsual = 0.5; ///< diameter against the median
constexpr double kLargestOfUsual = 1.8;
constexpr double kSame = 0.5; ///< diameters; markers do not lie so close
constexpr double kUnknownNoise_px = 0.1;
constexpr double kLeastNoise_px = 0.02; ///< of pictures that a program made
constexpr double kMoves = 5.0;          ///< standard deviations
constexpr double kLeastMove_px = 0.3;
constexpr std::size_t kTouched = 3; ///< markers that move together show a contact
constexpr double kLightJump = 0.25;
constexpr double kLightFollows = 0.1; ///< a picture
constexpr double kTornShare = 0.3;
constexpr double kTornFor_s = 1.0;

/// Mean and standard deviation over every fourth pixel of every fourth row.
std::pair<double, double> levelsOf(const cv::Mat1b& picture) {
    double sum = 0.0, squares = 0.0, count = 0.0;
    for (int v = 0; v < picture.rows; v += 4) {
        const std::uint8_t* row = picture[v];
        for (int u = 0; u < picture.cols; u += 4) {
            sum += row[u];
            squares += static_cast<double>(row[u]) * row[u];
            count += 1.0;
        }
    }
    const double mean = sum / count;
    return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

bool isFlat(const cv::Mat1b& picture) {
    return levelsOf(picture).second < kFlatLevels;
}

std::vector<Eigen::Vector2d> placesOf(const std::vector<MarkerCentre>& centres) {
    std::vector<Eigen::Vector2d> places;
    places.reserve(centres.size());
    for (const MarkerCentre& centre : centres)
        places.push_back(centre.place_px);
    return places;
}

/// The round spots of about one size.
std::vector<MarkerCentre> markersIn(const cv::Mat1b& picture, MarkerDetector& detector) {
    std::vector<MarkerCentre> centres = detector.centres(picture);
    if (centres.empty())
        return centres;
    std::vector<double> diameters;
    for (const MarkerCentre& centre : centres)
        diameters.push_back(centre.diameter_px);
    const double usual_px = core::medianOf(diameters);
    std::erase_if(centres, [&](const MarkerCentre& centre) {
        return centre.longness > kMostLong || centre.diameter_px < kSmallestOfUsual * usual_px ||
               centre.diameter_px > kLargestOfUsual * usual_px;
    });
    // Two spots may have led to one marker.
    std::vector<MarkerCentre> kept;
    for (const MarkerCentre& centre : centres) {
        if (std::ranges::none_of(kept, [&](const MarkerCentre& other) {
                return (other.place_px - centre.place_px).norm() < kSame * detector.diameter_px();
            }))
            kept.push_back(centre);
    }
    return kept;
}

core::Unexpected tooFew(std::size_t found) {
    return core::refused(
        GelText::tr("Only %1 markers were found in the picture.").arg(found),
        GelText::tr("at least %1 round spots of one size; check channel, marker and diameter_px in the "
                    "sensor file")
            .arg(kLeastMarkers));
}

} // namespace

core::Expected<cv::Mat1b> MarkerGel::part(const MarkerGelFile& file, const cv::Mat1b& frame) {
    cv::Rect part(0, 0, frame.cols, frame.rows);
    if (file.crop.size() == 4)
        part = {static_cast<int>(file.crop[0]), static_cast<int>(file.crop[1]),
                static_cast<int>(file.crop[2]), static_cast<int>(file.crop[3])};
    if (part.x + part.width > frame.cols || part.y + part.height > frame.rows)
        return core::refused(GelText::tr("The crop reaches out of the picture of %1 x %2 pixels.")
                                 .arg(frame.cols)
                                 .arg(frame.rows),
                             GelText::tr("x + width and y + height within the picture"));
    cv::Mat1b picture = frame(part);
    if (file.flipX || file.flipY) {
        cv::Mat1b flipped;
        cv::flip(picture, flipped, file.flipX && file.flipY ? -1 : file.flipX ? 1 : 0);
        picture = flipped;
    }
    return picture;
}

core::Expected<cv::Mat1b> MarkerGel::picture(const MarkerGelFile& file, const cv::Mat1b& frame) {
    TELETA_TRY(cv::Mat1b shown, part(file, frame));
    if (file.polarity == MarkerPolarity::bright)
        return cv::Mat1b(255 - shown);
    return shown;
}

core::Expected<MarkerGel> MarkerGel::make(const MarkerGelFile& file, std::span<const cv::Mat1b> first) {
    const cv::Mat1b& start = first.front();
    const auto [level, spread] = levelsOf(start);
    if (spread < kFlatLevels) {
        const double seen = file.polarity == MarkerPolarity::bright ? 255.0 - level : level;
        return core::refused(seen < 16.0 ? GelText::tr("The picture is black.")
                                         : GelText::tr("The picture has no contrast."),
                             GelText::tr("a picture of the gel's markers"));
    }
    const double diameter_px = file.diameter_px > 0.0 ? file.diameter_px : findMarkerDiameter(start);
    std::vector<MarkerCentre> centres;
    if (diameter_px > 0.0) {
        MarkerDetector rough(diameter_px);
        centres = markersIn(start, rough);
    }
    if (centres.size() < kLeastMarkers)
        return tooFew(centres.size());
    // Again, with what neighbours leave of the window.
    MarkerDetector detector(diameter_px, nearestDistance_px(placesOf(centres)));
    centres = markersIn(start, detector);
    if (centres.size() < kLeastMarkers)
        return tooFew(centres.size());
    std::vector<GridPlace> grid = gridPlaces(placesOf(centres), file.grid, file.rows, file.columns);
    if (file.grid != MarkerGrid::free) {
        const std::size_t seen = centres.size();
        std::vector<std::pair<GridPlace, MarkerCentre>> kept;
        for (std::size_t i = 0; i < centres.size(); ++i) {
            if (grid[i].row >= 0)
                kept.emplace_back(grid[i], centres[i]);
        }
        std::ranges::sort(kept, [](const auto& a, const auto& b) {
            return std::pair(a.first.row, a.first.column) < std::pair(b.first.row, b.first.column);
        });
        const bool isRectangular = file.grid == MarkerGrid::rectangular;
        const double wanted =
            isRectangular ? static_cast<double>(file.rows) * file.columns : static_cast<double>(seen);
        if (kept.size() < kLeastMarkers || static_cast<double>(kept.size()) < kLeastOfGrid * wanted)
            return core::refused(
                isRectangular
                    ? GelText::tr(
                          "The picture shows no grid of %1 x %2 markers: %3 spots, %4 of them in a grid.")
                          .arg(file.rows)
                          .arg(file.columns)
                          .arg(seen)
                          .arg(kept.size())
                    : GelText::tr("The markers form no hexagonal grid: %1 of %2 spots do.")
                          .arg(kept.size())
                          .arg(seen),
                GelText::tr("the grid that the sensor's file names"));
        centres.clear();
        grid.clear();
        for (const auto& [place, centre] : kept) {
            grid.push_back(place);
            centres.push_back(centre);
        }
    }
    const std::vector<Eigen::Vector2d> places = placesOf(centres);
    TELETA_TRY(GelPlane plane, GelPlane::make(file, start.cols, start.rows, places));
    MarkerGel gel(MarkerTracker(detector, centres, markerNeighbours(places)), std::move(plane));
    gel.m_isBright = file.polarity == MarkerPolarity::bright;
    gel.m_size = start.size();
    gel.m_diameter_px = diameter_px;
    gel.m_scale_m = gel.m_plane.scale_m({0.5 * start.cols, 0.5 * start.rows});
    gel.m_markers.resize(centres.size());
    gel.m_motions.resize(centres.size());
    for (std::size_t i = 0; i < centres.size(); ++i)
        gel.m_markers[i].grid = grid[i];
    gel.findReference(first.first(std::min(first.size(), kReferencePictures)));
    return gel;
}

void MarkerGel::findReference(std::span<const cv::Mat1b> first) {
    const std::size_t count = m_markers.size();
    std::vector<std::vector<Eigen::Vector2d>> places(count); // of each marker, in the quiet pictures
    std::vector<Eigen::Vector2d> start(count);
    std::vector<double> steps_px; // along u and v, from picture to picture
    for (std::size_t i = 0; i < count; ++i) {
        start[i] = m_tracker.markers()[i].rest_px;
        places[i].push_back(start[i]);
    }
    m_references = 1;
    for (const cv::Mat1b& picture : first.subspan(1)) {
        if (picture.size() != m_size || isFlat(picture))
            break;
        std::vector<Eigen::Vector2d> before(count);
        for (std::size_t i = 0; i < count; ++i)
            before[i] = m_tracker.markers()[i].now_px;
        m_tracker.track(picture);
        std::vector<double> here_px;
        for (std::size_t i = 0; i < count; ++i) {
            if (!m_tracker.markers()[i].found)
                continue;
            for (const double off : (m_tracker.markers()[i].now_px - before[i]).eval())
                here_px.push_back(std::abs(off));
        }
        if (here_px.empty())
            break;
        // A contact moves few markers: the median tells the noise. 0.6745: of a normal distribution.
        const double noise_px = core::medianOf(here_px) / 0.6745 / std::sqrt(2.0);
        const double moves_px = std::max(kLeastMove_px, kMoves * noise_px);
        std::size_t touched = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const TrackedMarker& marker = m_tracker.markers()[i];
            if (!marker.found || (marker.now_px - start[i]).norm() <= moves_px)
                continue;
            touched += static_cast<std::size_t>(
                std::ranges::count_if(m_tracker.neighbours()[i], [&](std::size_t k) {
                    const TrackedMarker& other = m_tracker.markers()[k];
                    return other.found && (other.now_px - start[k]).norm() > moves_px;
                }) > 0);
        }
        if (touched >= kTouched)
            break;
        for (std::size_t i = 0; i < count; ++i) {
            if (m_tracker.markers()[i].found)
                places[i].push_back(m_tracker.markers()[i].now_px);
        }
        ++m_references;
    }
    std::vector<double> variances_px2; // of each marker along an axis
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<double> u, v;
        for (const Eigen::Vector2d& place : places[i]) {
            u.push_back(place.x());
            v.push_back(place.y());
        }
        const Eigen::Vector2d rest(core::medianOf(u), core::medianOf(v));
        m_markers[i].rest_px = rest;
        m_markers[i].rest_m = m_plane.surface_m(rest);
        m_tracker.setRest(i, rest);
        Eigen::Vector2d mean = Eigen::Vector2d::Zero();
        for (const Eigen::Vector2d& place : places[i])
            mean += place / static_cast<double>(places[i].size());
        if (places[i].size() < 2)
            continue;
        double squares_px2 = 0.0;
        for (const Eigen::Vector2d& place : places[i])
            squares_px2 += (place - mean).squaredNorm();
        const double degrees = 2.0 * static_cast<double>(places[i].size() - 1);
        // The median of chi squared, after Wilson and Hilferty.
        variances_px2.push_back(squares_px2 / (degrees * std::pow(1.0 - 2.0 / (9.0 * degrees), 3.0)));
    }
    m_noise_px = variances_px2.size() < kLeastMarkers
                     ? kUnknownNoise_px
                     : std::max(kLeastNoise_px, std::sqrt(core::medianOf(variances_px2)));
    m_tracker.forget();
}

core::Expected<void> MarkerGel::track(const cv::Mat1b& picture, double time_s) {
    if (picture.size() != m_size)
        return core::refused(
            GelText::tr("The size of the picture has changed to %1 x %2.")
                .arg(picture.cols)
                .arg(picture.rows),
            GelText::tr("%1 x %2 pixels, as at the beginning").arg(m_size.width).arg(m_size.height));
    m_found = m_tracker.track(picture);
    place();
    judge(picture, time_s);
    return {};
}

void MarkerGel::place() {
    for (std::size_t i = 0; i < m_markers.size(); ++i) {
        const TrackedMarker& marker = m_tracker.markers()[i];
        GelMotion& motion = m_motions[i];
        motion.found = marker.found;
        motion.place_px = marker.now_px;
        motion.displacement_m = m_plane.surface_m(marker.now_px) - m_markers[i].rest_m;
    }
}

void MarkerGel::judge(const cv::Mat1b& picture, double time_s) {
    const auto [seen, spread] = levelsOf(picture);
    const double level = m_isBright ? 255.0 - seen : seen;
    m_faults = {};
    m_faults.dead = spread < kFlatLevels;
    if (std::isnan(m_usualLevel)) {
        m_usualLevel = level;
    } else {
        m_faults.lightJumped = std::abs(level - m_usualLevel) > kLightJump * std::max(16.0, m_usualLevel);
        m_usualLevel = m_faults.lightJumped ? level : std::lerp(m_usualLevel, level, kLightFollows);
    }
    const double lost =
        static_cast<double>(m_markers.size() - m_found) / static_cast<double>(m_markers.size());
    if (lost <= kTornShare || m_faults.dead)
        m_lostSince_s = std::numeric_limits<double>::quiet_NaN();
    else if (std::isnan(m_lostSince_s))
        m_lostSince_s = time_s;
    m_faults.torn = !std::isnan(m_lostSince_s) && time_s - m_lostSince_s >= kTornFor_s;
}

std::array<Eigen::Vector2d, 4> MarkerGel::corners_m() const {
    // The centre of the first pixel is (0, 0).
    const double right_px = m_size.width - 0.5;
    const double bottom_px = m_size.height - 0.5;
    return {m_plane.surface_m({-0.5, -0.5}), m_plane.surface_m({right_px, -0.5}),
            m_plane.surface_m({right_px, bottom_px}), m_plane.surface_m({-0.5, bottom_px})};
}

void MarkerGel::forget() {
    m_tracker.forget();
    m_usualLevel = std::numeric_limits<double>::quiet_NaN();
    m_lostSince_s = std::numeric_limits<double>::quiet_NaN();
}

} // namespace teleta::vision
