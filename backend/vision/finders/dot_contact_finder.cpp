// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/finders/dot_contact_finder.h"

#include "backend/core/quantile.h"
#include "backend/core/steady_time.h"
#include "backend/vision/finders/dot_detection.h"
#include "backend/vision/finders/vision_text.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace teleta::vision {

namespace {

constexpr double kTurn_rad = 2.0 * std::numbers::pi;
constexpr double kCellsPerDot = 6.0;    ///< resolution of the unrolled reference
constexpr std::size_t kFewestDots = 20; ///< of a pattern
constexpr double kWindowShare = 0.62;   ///< radius of a dot's window, as a share of the pitch
// How far neighbours may have moved apart; less than the distance to another dot.
constexpr double kToleranceAround_m = 0.0012;
constexpr double kToleranceInward_m = 0.0017;
constexpr double kNarrowest_px = 2.5;  ///< half axis of a window
constexpr double kLeastPitch_px = 2.6; ///< dots nearer to each other in the image are mistaken for each other
constexpr double kNeighbourShare = 1.75; ///< how far neighbours are, as a share of the pitch
constexpr double kLostShare = 0.5;       ///< with fewer dots found the frame shows no skin
constexpr int kDirections = 24;          ///< of an outline
constexpr double kDotNoise_px = 0.15;    ///< of a dot's place from frame to frame

/// look(i, k, squared distance in m^2)
void eachPair(const std::vector<SkinSample>& samples, const auto& look) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k)
            look(i, k, (samples[i].p_Sensor_m - samples[k].p_Sensor_m).squaredNorm());
    }
}

/// Median distance to the nearest other dot; 1 m if there is none.
double pitchOf_m(const std::vector<SkinSample>& samples) {
    if (samples.empty())
        return 1.0;
    std::vector<double> nearest_m2(samples.size(), 1.0);
    eachPair(samples, [&](std::size_t i, std::size_t k, double distance_m2) {
        nearest_m2[i] = std::min(nearest_m2[i], distance_m2);
        nearest_m2[k] = std::min(nearest_m2[k], distance_m2);
    });
    return std::sqrt(core::upperMedianOf(nearest_m2));
}

} // namespace

DotContactFinder::DotContactFinder(const CylinderCamera& camera, const ContactSettings& settings,
                                   std::stop_token stop)
    : m_camera(camera)
    , m_skin(camera.surface())
    , m_settings(settings)
    , m_patches({.radius_m = camera.surface().radius_m,
                 .threshold_m = settings.threshold_m,
                 .prominence = settings.prominence})
    , m_stop(std::move(stop)) {
}

cv::Mat1b DotContactFinder::skinMask() const {
    const CameraParameters& image = m_camera.camera().parameters();
    cv::Mat1b mask(image.height_px, image.width_px);
    for (int v = 0; v < mask.rows && !m_stop.stop_requested(); ++v) {
        for (int u = 0; u < mask.cols; ++u)
            mask(v, u) = m_camera.locate_m({u, v}) ? 255 : 0;
    }
    return mask;
}

DotContactFinder::Unrolled DotContactFinder::unrolled() const {
    Unrolled map;
    map.step_m = m_settings.dotDiameter_m / kCellsPerDot;
    const int around = static_cast<int>(std::lround(kTurn_rad * m_skin.radius_m / map.step_m));
    const int along = static_cast<int>((m_skin.highest_z_m - m_skin.lowest_z_m) / map.step_m);
    map.wrap = static_cast<int>(8.0 * kCellsPerDot);
    map.toImage.create(along, around + 2 * map.wrap);
    map.mask.create(map.toImage.size());
    for (int row = 0; row < map.toImage.rows && !m_stop.stop_requested(); ++row) {
        const double z_m = m_skin.lowest_z_m + (row + 0.5) * map.step_m;
        for (int column = 0; column < map.toImage.cols; ++column) {
            const double angle_rad = kTurn_rad * (column - map.wrap) / around;
            const auto pixel = m_camera.camera().project(
                {m_skin.radius_m * std::cos(angle_rad), m_skin.radius_m * std::sin(angle_rad), z_m});
            const bool inside = pixel && pixel->x() >= 0.0 && pixel->y() >= 0.0 &&
                                pixel->x() <= m_camera.camera().parameters().width_px - 1 &&
                                pixel->y() <= m_camera.camera().parameters().height_px - 1;
            map.mask(row, column) = inside && column >= map.wrap && column < map.wrap + around ? 255 : 0;
            map.toImage(row, column) =
                inside ? cv::Vec2f(static_cast<float>(pixel->x()), static_cast<float>(pixel->y()))
                       : cv::Vec2f(-1e4F, -1e4F);
        }
    }
    return map;
}

bool DotContactFinder::prepareMaps() {
    if (!m_skinMask.empty())
        return true;
    m_unrolled = unrolled();
    cv::Mat1b mask = skinMask();
    if (m_stop.stop_requested())
        return false;
    m_skinMask = std::move(mask);
    return true;
}

core::Expected<void> DotContactFinder::takeReference(const cv::Mat1b& frame) {
    m_tracker.reset();
    TELETA_CHECK(checkSize(frame.cols, frame.rows, m_camera));
    if (!prepareMaps())
        return cancelledMaking();
    const Unrolled& map = m_unrolled;
    cv::Mat1f grey;
    frame.convertTo(grey, CV_32F);
    cv::Mat1f flat;
    cv::remap(grey, flat, map.toImage, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    std::vector<TrackedDot> dots;
    std::vector<SkinSample> samples;
    for (const cv::Point2f& place : detectDots(flat, map.mask, kCellsPerDot)) {
        const double angle_rad =
            (static_cast<double>(place.x) - map.wrap) * kTurn_rad / (map.toImage.cols - 2 * map.wrap);
        const double z_m = m_skin.lowest_z_m + (static_cast<double>(place.y) + 0.5) * map.step_m;
        const auto pixel = m_camera.camera().project(
            {m_skin.radius_m * std::cos(angle_rad), m_skin.radius_m * std::sin(angle_rad), z_m});
        const auto sample = pixel ? skinSample(m_camera, *pixel) : std::nullopt;
        if (!sample)
            continue;
        dots.push_back({.rest_px = *pixel});
        samples.push_back(*sample);
    }
    m_pitch_m = pitchOf_m(samples);
    dropUnresolved(dots, samples);
    if (dots.size() < kFewestDots)
        return refused(
            VisionText::tr("The image shows no printed dots on the skin (%1 found).").arg(dots.size()),
            VisionText::tr("a frame in focus, in which nothing touches the skin"));

    findNeighbours(samples);
    const double window_m = kWindowShare * m_pitch_m;
    for (std::size_t i = 0; i < dots.size(); ++i) {
        // Image of a circle on the skin, an ellipse at least two pixels wide for dots that the camera hardly
        // resolves.
        const Eigen::Matrix2d onSkin = samples[i].surfacePerPixel / window_m;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(onSkin.transpose() * onSkin);
        const Eigen::Vector2d limited = axes.eigenvalues().cwiseMin(1.0 / (kNarrowest_px * kNarrowest_px));
        dots[i].metric = axes.eigenvectors() * limited.asDiagonal() * axes.eigenvectors().transpose();
        dots[i].tolerance = Eigen::Vector2d(1.0 / kToleranceAround_m, 1.0 / kToleranceInward_m).asDiagonal() *
                            samples[i].metresPerPixel;
        dots[i].neighbours = m_neighbours[i];
    }
    DotTracker tracker(std::move(dots), m_skinMask, m_settings.dotDiameter_m / window_m, m_settings.cores);
    if (tracker.setReference(frame) < kFewestDots)
        return refused(VisionText::tr("The printed dots are too faint to be followed."),
                       VisionText::tr("a frame in focus, in which nothing touches the skin"));
    m_samples = std::move(samples);
    m_nodes.assign(m_samples.size(), {});
    for (std::size_t i = 0; i < m_samples.size(); ++i) {
        if (const auto exact = skinSample(m_camera, tracker.dots()[i].rest_px))
            m_samples[i] = *exact;
        m_nodes[i].angle_rad = m_samples[i].angle_rad();
        m_nodes[i].z_m = m_samples[i].p_Sensor_m.z();
        m_nodes[i].known = tracker.dots()[i].found;
    }
    m_beforeKnown = true; // nothing has moved in the reference
    m_patches.forget();
    m_tracker = std::move(tracker);
    return {};
}

void DotContactFinder::dropUnresolved(std::vector<TrackedDot>& dots, std::vector<SkinSample>& samples) const {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < dots.size(); ++i) {
        // The pitch is shortest in the image in the direction in which a pixel covers most of the skin.
        const Eigen::JacobiSVD<Eigen::Matrix2d> covers(samples[i].surfacePerPixel);
        if (!(m_pitch_m >= kLeastPitch_px * covers.singularValues().x()))
            continue;
        dots[kept] = dots[i];
        samples[kept++] = samples[i];
    }
    dots.resize(kept);
    samples.resize(kept);
}

void DotContactFinder::findNeighbours(const std::vector<SkinSample>& samples) {
    m_neighbours.assign(samples.size(), {});
    const double reach_m2 = std::pow(kNeighbourShare * m_pitch_m, 2);
    eachPair(samples, [&](std::size_t i, std::size_t k, double distance_m2) {
        if (distance_m2 < reach_m2) {
            m_neighbours[i].push_back(k);
            m_neighbours[k].push_back(i);
        }
    });
}

core::Expected<std::vector<CameraContact>> DotContactFinder::findIn(const cv::Mat1b& frame) {
    if (!m_tracker)
        return noReference();
    TELETA_CHECK(checkSize(frame.cols, frame.rows, m_camera));
    m_stage_ns = {};
    const std::int64_t start_ns = core::steadyNow_ns();
    const std::size_t dots = m_tracker->track(frame);
    if (static_cast<double>(dots) < kLostShare * static_cast<double>(m_nodes.size())) {
        m_tracker->forget();
        return core::failed(core::ErrorKind::unavailable,
                            VisionText::tr("The frame does not show the skin: %1 of %2 dots found.")
                                .arg(dots)
                                .arg(m_nodes.size()));
    }
    const std::int64_t tracked_ns = core::steadyNow_ns();
    for (std::size_t i = 0; i < m_nodes.size(); ++i) {
        const Eigen::Vector2d moved_m = m_samples[i].metresPerPixel * m_tracker->displacement_px(i);
        m_nodes[i].inwardBefore_m = m_beforeKnown && m_nodes[i].known
                                        ? m_nodes[i].inward_m
                                        : std::numeric_limits<double>::quiet_NaN();
        m_nodes[i].around_m = moved_m.x();
        m_nodes[i].inward_m = moved_m.y();
        m_nodes[i].known = m_tracker->dots()[i].found;
    }
    m_beforeKnown = true;
    const std::vector<SkinPatch> patches = m_patches.find(m_nodes, m_neighbours);
    const std::int64_t segmented_ns = core::steadyNow_ns();
    std::vector<CameraContact> contacts;
    for (const SkinPatch& patch : patches)
        contacts.push_back(contactOf(patch));
    m_stage_ns[static_cast<std::size_t>(FinderStage::displacement)] = tracked_ns - start_ns;
    m_stage_ns[static_cast<std::size_t>(FinderStage::segment)] = segmented_ns - tracked_ns;
    m_stage_ns[static_cast<std::size_t>(FinderStage::locate)] = core::steadyNow_ns() - segmented_ns;
    return contacts;
}

CameraContact DotContactFinder::contactOf(const SkinPatch& patch) const {
    CameraContact contact;
    contact.p_Sensor_Centre_m = {m_skin.radius_m * std::cos(patch.angle_rad),
                                 m_skin.radius_m * std::sin(patch.angle_rad), patch.z_m};
    contact.depth_m = patch.depth_m;
    contact.deepened_m = patch.deepened_m;
    const auto pixel = m_camera.camera().project(contact.p_Sensor_Centre_m);
    contact.located = pixel.has_value();
    if (pixel) {
        contact.centre_px = *pixel;
        contact.sd_m = m_camera.standardDeviation_m(contact.p_Sensor_Centre_m).value_or(contact.sd_m);
    }
    contact.depthNoise_m = kDotNoise_px * m_samples[patch.nodes.front()].metresPerPixel.row(1).norm();
    outline(patch, contact);
    return contact;
}

void DotContactFinder::outline(const SkinPatch& patch, CameraContact& contact) const {
    // The outline is where the displacement, smoothed over the dots, falls to a third of its peak.
    const double step_m = 0.25 * m_pitch_m;
    const double width_m = 0.5 * m_pitch_m;
    const double level_m = std::max(m_settings.threshold_m, patch.peak_m / 3.0);
    double extent_m = m_pitch_m;
    for (const std::size_t i : patch.nodes)
        extent_m = std::max(extent_m, (m_samples[i].p_Sensor_m - contact.p_Sensor_Centre_m).norm());
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < m_nodes.size(); ++i) {
        const double reach_m = extent_m + 2.0 * m_pitch_m;
        if (m_nodes[i].known &&
            (m_samples[i].p_Sensor_m - contact.p_Sensor_Centre_m).squaredNorm() < reach_m * reach_m)
            candidates.push_back(i);
    }
    for (int direction = 0; direction < kDirections; ++direction) {
        const double angle_rad = kTurn_rad * direction / kDirections;
        const auto place = [&](double distance_m) {
            return std::pair(patch.angle_rad + distance_m * std::cos(angle_rad) / m_skin.radius_m,
                             std::clamp(patch.z_m + distance_m * std::sin(angle_rad), m_skin.lowest_z_m,
                                        m_skin.highest_z_m));
        };
        double reach_m = step_m;
        double before_m = level_m;
        double here_m = level_m;
        for (; reach_m < extent_m + m_pitch_m; reach_m += step_m) {
            const auto [around_rad, z_m] = place(reach_m);
            before_m = here_m;
            here_m = m_patches.smoothed_m(m_nodes, candidates, around_rad, z_m, width_m);
            if (here_m < level_m)
                break;
        }
        const double share =
            before_m > here_m ? std::clamp((level_m - here_m) / (before_m - here_m), 0.0, 1.0) : 1.0;
        const auto [around_rad, z_m] = place(reach_m - share * step_m);
        const Eigen::Vector3d point_m(m_skin.radius_m * std::cos(around_rad),
                                      m_skin.radius_m * std::sin(around_rad), z_m);
        contact.contour_m.push_back(point_m);
        if (const auto pixel = m_camera.camera().project(point_m))
            contact.contour_px.emplace_back(static_cast<float>(pixel->x()), static_cast<float>(pixel->y()));
    }
    if (contact.contour_px.size() >= 3)
        contact.area_px = cv::contourArea(contact.contour_px);
}

void DotContactFinder::forget() {
    if (m_tracker)
        m_tracker->forget();
    m_beforeKnown = false;
}

std::vector<ContactFinder::Arrow> DotContactFinder::arrows(std::size_t about) const {
    std::vector<Arrow> arrows;
    if (!m_tracker || about == 0)
        return arrows;
    const std::size_t step = std::max<std::size_t>(1, m_tracker->dots().size() / about);
    for (std::size_t i = 0; i < m_tracker->dots().size(); i += step) {
        const TrackedDot& dot = m_tracker->dots()[i];
        if (!dot.found)
            continue;
        const Eigen::Vector2d moved_px = m_tracker->displacement_px(i);
        arrows.push_back({{static_cast<float>(dot.rest_px.x()), static_cast<float>(dot.rest_px.y())},
                          {static_cast<float>(moved_px.x()), static_cast<float>(moved_px.y())}});
    }
    return arrows;
}

} // namespace teleta::vision
