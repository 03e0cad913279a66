// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/finders/flow_contact_finder.h"

#include "backend/core/quantile.h"
#include "backend/core/steady_time.h"
#include "backend/opencv/opencv_parts.h"
#include "backend/vision/finders/vision_text.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::vision {

namespace {

const cv::Size kPaperSize(512, 288);
constexpr int kSmallestSide_px = 64;  ///< that the flow has patches for
constexpr double kLeastDot_px = 2.0;  ///< at the finest scale of the flow: narrower ones are not seen to move
constexpr double kLeastTexture = 1.5; ///< standard deviation of the reference's Laplacian, in grey levels
constexpr int kChangedMargin_px = 24; ///< in the small image: what the flow needs around a change
constexpr double kLeastArea_m2 = 4e-6; ///< of a contact
constexpr double kSmoothing_px = 2.0;  ///< at full scale, against noise
constexpr int kDiffers = 4;            ///< grey levels that are more than noise after that smoothing
constexpr double kFounded_px = 20.0;   ///< at full scale: from a change to what it tells of
/// Noise of the flow of a contact from frame to frame, in the small image; an upper bound, like that of the
/// dots.
constexpr double kFlowNoise_px = 0.3;
constexpr double kDeep = 0.9; ///< quantile of the inward displacement that is a contact's depth

float quantile(std::vector<float>& values, double share) {
    return values.empty() ? 0.0F : core::lowerQuantileOf(values, share);
}

int preset(FlowMethod method) {
    switch (method) {
    case FlowMethod::disUltrafast:
        return cv::DISOpticalFlow::PRESET_ULTRAFAST;
    case FlowMethod::disFast:
        return cv::DISOpticalFlow::PRESET_FAST;
    default:
        return cv::DISOpticalFlow::PRESET_MEDIUM;
    }
}

} // namespace

core::Expected<std::unique_ptr<ContactFinder>> FlowContactFinder::make(const ContactRung& rung,
                                                                       const CylinderCamera& camera,
                                                                       const ContactSettings& settings,
                                                                       const std::stop_token& stop) {
    TELETA_TRY(cv::Ptr<cv::DISOpticalFlow> dis, opencv::denseFlow(preset(rung.method)));
    std::unique_ptr<FlowContactFinder> finder(
        new FlowContactFinder(rung, camera, settings, std::move(dis), stop));
    if (stop.stop_requested())
        return cancelledMaking();
    if (finder->m_samples.empty())
        return refused(VisionText::tr("The camera does not see the skin."));
    if (std::min(finder->m_sampleOf.rows, finder->m_sampleOf.cols) < kSmallestSide_px)
        return refused(VisionText::tr("The image is too small for optical flow: %1 x %2 pixels.")
                           .arg(finder->m_sampleOf.cols)
                           .arg(finder->m_sampleOf.rows),
                       VisionText::tr("at least %1 pixels on each side").arg(kSmallestSide_px));
    return finder;
}

FlowContactFinder::FlowContactFinder(const ContactRung& rung, const CylinderCamera& camera,
                                     const ContactSettings& settings, cv::Ptr<cv::DISOpticalFlow> dis,
                                     const std::stop_token& stop)
    : m_rung(rung)
    , m_camera(camera)
    , m_skin(camera.surface())
    , m_settings(settings)
    , m_crop(0, 0, camera.camera().parameters().width_px, camera.camera().parameters().height_px)
    , m_dis(std::move(dis))
    , m_finestScale(m_dis->getFinestScale())
    , m_patchSize_px(m_dis->getPatchSize()) {
    m_cropMask.create(m_crop.size());
    for (int v = 0; v < m_cropMask.rows; ++v) {
        if (stop.stop_requested())
            return;
        for (int u = 0; u < m_cropMask.cols; ++u)
            m_cropMask(v, u) = m_camera.locate_m({u, v}).has_value() ? 255 : 0;
    }
    cv::Size size = kPaperSize;
    if (!rung.paper) {
        m_crop = cv::boundingRect(m_cropMask);
        m_cropMask = m_cropMask(m_crop).clone();
        size = {static_cast<int>(std::lround(m_crop.width * rung.scale)),
                static_cast<int>(std::lround(m_crop.height * rung.scale))};
    }
    if (m_crop.empty() || size.width < 1 || size.height < 1)
        return;
    m_sampleOf.create(size);
    for (int y = 0; y < size.height; ++y) {
        if (stop.stop_requested())
            return;
        for (int x = 0; x < size.width; ++x) {
            const auto sample = skinSample(m_camera, inImage_px(x, y));
            m_sampleOf(y, x) = sample ? static_cast<int>(m_samples.size()) : -1;
            if (sample)
                m_samples.push_back(*sample);
        }
    }
    if (!rung.paper)
        sharpen();
}

void FlowContactFinder::sharpen() {
    if (m_samples.empty())
        return;
    std::vector<float> dots_px;
    dots_px.reserve(m_samples.size());
    const double pixels = static_cast<double>(m_crop.area()) / static_cast<double>(m_sampleOf.total());
    for (const SkinSample& sample : m_samples)
        dots_px.push_back(
            static_cast<float>(m_settings.dotDiameter_m / std::sqrt(sample.areaPerPixel_m2() * pixels)));
    const double dot_px = static_cast<double>(quantile(dots_px, 0.5));
    while (m_finestScale > 0 && dot_px < kLeastDot_px * std::exp2(m_finestScale))
        --m_finestScale;
}

Eigen::Vector2d FlowContactFinder::inImage_px(double x, double y) const {
    const double scaleX = static_cast<double>(m_crop.width) / m_sampleOf.cols;
    const double scaleY = static_cast<double>(m_crop.height) / m_sampleOf.rows;
    return {m_crop.x + (x + 0.5) * scaleX - 0.5, m_crop.y + (y + 0.5) * scaleY - 0.5};
}

void FlowContactFinder::prepare(const cv::Mat1b& frame, cv::Mat1b& small) const {
    cv::Mat1b masked(m_cropMask.size(), std::uint8_t{0});
    frame(m_crop).copyTo(masked, m_cropMask);
    cv::resize(masked, small, m_sampleOf.size(), 0.0, 0.0, m_rung.paper ? cv::INTER_LINEAR : cv::INTER_AREA);
}

void FlowContactFinder::flow(const cv::Mat1b& reference, const cv::Mat1b& small, cv::Mat2f& flow) {
    // OpenCV changes its scales for images that are too small, and keeps the changed values.
    m_dis->setFinestScale(m_finestScale);
    m_dis->setPatchSize(m_patchSize_px);
    m_dis->calc(reference, small, flow);
}

core::Expected<void> FlowContactFinder::takeReference(const cv::Mat1b& frame) {
    m_reference.release();
    m_beforeKnown = false;
    TELETA_CHECK(checkSize(frame.cols, frame.rows, m_camera));
    prepare(frame, m_small);
    cv::Mat1f laplacian;
    cv::Laplacian(m_small, laplacian, CV_32F);
    cv::Mat1b inner;
    cv::erode(m_sampleOf >= 0, inner, cv::Mat1b(7, 7, std::uint8_t{1}));
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(laplacian, mean, deviation, inner);
    if (deviation[0] < kLeastTexture)
        return refused(VisionText::tr("The image shows no pattern on the skin that could be tracked."),
                       VisionText::tr("a frame in focus, in which nothing touches the skin"));
    m_reference = m_small.clone();
    cv::GaussianBlur(m_reference, m_smoothReference, {}, kSmoothing_px * m_rung.scale);
    m_flow = cv::Mat2f(m_small.size(), cv::Vec2f(0.0F, 0.0F));
    m_beforeKnown = true; // nothing has moved in the reference
    return {};
}

core::Expected<std::vector<CameraContact>> FlowContactFinder::findIn(const cv::Mat1b& frame) {
    if (m_reference.empty())
        return noReference();
    TELETA_CHECK(checkSize(frame.cols, frame.rows, m_camera));
    const std::int64_t start_ns = core::steadyNow_ns();
    prepare(frame, m_small);
    const std::int64_t prepared_ns = core::steadyNow_ns();
    const cv::Rect whole(0, 0, m_small.cols, m_small.rows);
    if (!m_rung.paper)
        findChange();
    const cv::Rect part = m_rung.changedOnly ? aroundChange() : whole;
    std::swap(m_flow, m_flowBefore);
    if (part == whole) {
        // OpenCV starts from the given matrix when it has the right size. Without one it would start from
        // that of an earlier frame, which it keeps, although that is to be forgotten.
        if (!m_rung.warmStart)
            m_flow.release();
        else if (m_beforeKnown)
            m_flowBefore.copyTo(m_flow);
        else
            m_flow = cv::Mat2f(m_small.size(), cv::Vec2f(0.0F, 0.0F));
        flow(m_reference, m_small, m_flow);
    } else {
        m_flow.create(m_small.size());
        m_flow.setTo(cv::Scalar::all(0.0));
        if (!part.empty()) {
            cv::Mat2f partFlow;
            // OpenCV cannot work on a part of an image in place.
            flow(m_reference(part).clone(), m_small(part).clone(), partFlow);
            partFlow.copyTo(m_flow(part));
        }
    }
    const std::int64_t flown_ns = core::steadyNow_ns();
    measure(part);
    const std::int64_t measured_ns = core::steadyNow_ns();
    std::vector<CameraContact> found = contacts();
    m_beforeKnown = true;
    m_stage_ns = {prepared_ns - start_ns, flown_ns - prepared_ns, measured_ns - flown_ns,
                  core::steadyNow_ns() - measured_ns};
    return found;
}

void FlowContactFinder::findChange() {
    cv::GaussianBlur(m_small, m_changed, {}, kSmoothing_px * m_rung.scale);
    cv::absdiff(m_changed, m_smoothReference, m_changed);
    cv::threshold(m_changed, m_changed, kDiffers, 255, cv::THRESH_BINARY);
}

cv::Rect FlowContactFinder::aroundChange() const {
    cv::Rect box = cv::boundingRect(m_changed);
    if (box.empty())
        return {};
    box = cv::Rect(box.x - kChangedMargin_px, box.y - kChangedMargin_px, box.width + 2 * kChangedMargin_px,
                   box.height + 2 * kChangedMargin_px);
    const int least = kSmallestSide_px;
    if (box.width < least)
        box = {box.x - (least - box.width) / 2, box.y, least, box.height};
    if (box.height < least)
        box = {box.x, box.y - (least - box.height) / 2, box.width, least};
    box.x = std::clamp(box.x, 0, std::max(0, m_small.cols - least));
    box.y = std::clamp(box.y, 0, std::max(0, m_small.rows - least));
    return box & cv::Rect(0, 0, m_small.cols, m_small.rows);
}

Eigen::Vector2d FlowContactFinder::moved_m(const SkinSample& sample, const cv::Vec2f& flow_px) const {
    const double scaleX = static_cast<double>(m_crop.width) / m_sampleOf.cols;
    const double scaleY = static_cast<double>(m_crop.height) / m_sampleOf.rows;
    return sample.metresPerPixel * Eigen::Vector2d(scaleX * static_cast<double>(flow_px[0]),
                                                   scaleY * static_cast<double>(flow_px[1]));
}

void FlowContactFinder::measure(const cv::Rect& part) {
    m_moved.create(m_sampleOf.size());
    m_moved.setTo(0.0F);
    for (int y = part.y; y < part.y + part.height; ++y) {
        const int* sampleOf = m_sampleOf[y];
        const cv::Vec2f* flow = m_flow[y];
        float* moved = m_moved[y];
        for (int x = part.x; x < part.x + part.width; ++x) {
            if (sampleOf[x] < 0)
                continue;
            moved[x] = m_rung.paper
                           ? std::hypot(flow[x][0], flow[x][1])
                           : static_cast<float>(
                                 moved_m(m_samples[static_cast<std::size_t>(sampleOf[x])], flow[x]).norm());
        }
    }
    if (m_rung.paper) {
        // Values below the threshold are set to zero before the maximum filter spreads the others.
        cv::threshold(m_moved, m_moved, m_settings.paperThreshold_px, 0.0, cv::THRESH_TOZERO);
        cv::dilate(m_moved, m_moved, cv::Mat1b(5, 5, std::uint8_t{1}));
        m_active = m_moved > 0.0F;
    } else {
        m_active = m_moved > static_cast<float>(m_settings.threshold_m);
        dropUnfounded();
    }
}

void FlowContactFinder::dropUnfounded() {
    // At the far end half a pixel is a contact, and noise alone gives that much flow.
    const int side = 2 * static_cast<int>(std::lround(kFounded_px * m_rung.scale)) + 1;
    cv::Mat1b founded;
    cv::dilate(m_changed, founded, cv::Mat1b(side, side, std::uint8_t{1}));
    cv::bitwise_and(m_active, founded, m_active);
}

std::vector<CameraContact> FlowContactFinder::contacts() {
    std::vector<std::vector<cv::Point>> contours;
    cv::findContours(m_active, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    cv::Mat1i labels(m_active.size(), 0);
    std::vector<std::pair<double, CameraContact>> found;
    for (std::size_t i = 0; i < contours.size(); ++i) {
        const int label = static_cast<int>(i) + 1;
        cv::drawContours(labels, contours, static_cast<int>(i), label, cv::FILLED);
        double strength = 0.0;
        CameraContact contact = contactOf(contours[i], labels, label, strength);
        if (contact.located)
            found.emplace_back(strength, std::move(contact));
    }
    std::ranges::stable_sort(found, [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<CameraContact> sorted;
    for (auto& [strength, contact] : found)
        sorted.push_back(std::move(contact));
    return sorted;
}

CameraContact FlowContactFinder::contactOf(const std::vector<cv::Point>& contour, const cv::Mat1i& labels,
                                           int label, double& strength) {
    const cv::Rect box = cv::boundingRect(contour);
    const double scaleX = static_cast<double>(m_crop.width) / m_sampleOf.cols;
    const double scaleY = static_cast<double>(m_crop.height) / m_sampleOf.rows;
    CameraContact contact;
    Eigen::Vector3d place_m = Eigen::Vector3d::Zero();
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    double sum = 0.0;
    double area_m2 = 0.0;
    std::size_t pixels = 0;
    m_inward_m.clear();
    m_inwardBefore_m.clear();
    for (int y = box.y; y < box.y + box.height; ++y) {
        for (int x = box.x; x < box.x + box.width; ++x) {
            if (labels(y, x) != label)
                continue;
            pixel += Eigen::Vector2d(x, y);
            ++pixels;
            if (m_sampleOf(y, x) < 0)
                continue;
            const SkinSample& sample = m_samples[static_cast<std::size_t>(m_sampleOf(y, x))];
            const Eigen::Vector2d here_m = moved_m(sample, m_flow(y, x));
            const double part_m2 = sample.areaPerPixel_m2() * scaleX * scaleY;
            area_m2 += part_m2;
            m_inward_m.push_back(static_cast<float>(here_m.y()));
            if (m_beforeKnown)
                m_inwardBefore_m.push_back(static_cast<float>(moved_m(sample, m_flowBefore(y, x)).y()));
            const double weight = part_m2 * std::max(0.0, here_m.norm() - m_settings.threshold_m);
            sum += weight;
            const double angle_rad = sample.angle_rad() + here_m.x() / m_skin.radius_m;
            place_m += weight * Eigen::Vector3d(m_skin.radius_m * std::cos(angle_rad),
                                                m_skin.radius_m * std::sin(angle_rad), sample.p_Sensor_m.z());
        }
    }
    if (pixels == 0 || area_m2 < kLeastArea_m2)
        return contact;
    if (m_rung.paper) {
        pixel /= static_cast<double>(pixels);
        const auto hit = m_camera.locate_m(inImage_px(pixel.x(), pixel.y()));
        contact.located = hit.has_value();
        if (hit)
            contact.p_Sensor_Centre_m = *hit;
    } else if (sum > 0.0) {
        place_m /= sum;
        const double rho_m = place_m.head<2>().norm();
        if (rho_m > 0.0) {
            contact.located = true;
            contact.p_Sensor_Centre_m = {place_m.x() * m_skin.radius_m / rho_m,
                                         place_m.y() * m_skin.radius_m / rho_m, place_m.z()};
        }
    }
    if (!contact.located)
        return contact;
    if (const auto seen = m_camera.camera().project(contact.p_Sensor_Centre_m))
        contact.centre_px = *seen;
    contact.sd_m = m_camera.standardDeviation_m(contact.p_Sensor_Centre_m).value_or(contact.sd_m);
    strength = sum;
    if (const auto sample = skinSample(m_camera, contact.centre_px))
        contact.depthNoise_m = kFlowNoise_px * scaleX * sample->metresPerPixel.row(1).norm();
    // The flow of a single pixel is not reliable.
    contact.depth_m = static_cast<double>(quantile(m_inward_m, kDeep));
    if (m_beforeKnown)
        contact.deepened_m = contact.depth_m - static_cast<double>(quantile(m_inwardBefore_m, kDeep));
    for (const cv::Point& point : contour) {
        const Eigen::Vector2d at_px = inImage_px(point.x, point.y);
        contact.contour_px.emplace_back(static_cast<float>(at_px.x()), static_cast<float>(at_px.y()));
        const int sample = m_sampleOf(point);
        if (sample >= 0)
            contact.contour_m.push_back(m_samples[static_cast<std::size_t>(sample)].p_Sensor_m);
    }
    contact.area_px = static_cast<double>(pixels) * scaleX * scaleY;
    return contact;
}

std::vector<ContactFinder::Arrow> FlowContactFinder::arrows(std::size_t about) const {
    std::vector<Arrow> arrows;
    if (m_flow.empty() || about == 0)
        return arrows;
    const int step = std::max(
        1, static_cast<int>(std::sqrt(static_cast<double>(m_samples.size()) / static_cast<double>(about))));
    const auto scaleX = static_cast<float>(m_crop.width) / static_cast<float>(m_sampleOf.cols);
    const auto scaleY = static_cast<float>(m_crop.height) / static_cast<float>(m_sampleOf.rows);
    for (int y = step / 2; y < m_flow.rows; y += step) {
        for (int x = step / 2; x < m_flow.cols; x += step) {
            if (m_sampleOf(y, x) < 0)
                continue;
            const Eigen::Vector2d at_px = inImage_px(x, y);
            arrows.push_back({{static_cast<float>(at_px.x()), static_cast<float>(at_px.y())},
                              {scaleX * m_flow(y, x)[0], scaleY * m_flow(y, x)[1]}});
        }
    }
    return arrows;
}

} // namespace teleta::vision
