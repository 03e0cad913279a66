// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/gel/gel_follower.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

#include <utility>

namespace teleta::vision {

namespace {

struct GelFollowerText {
    Q_DECLARE_TR_FUNCTIONS(GelFollower)
};

} // namespace

void GelFollower::next(const cv::Mat1b& part, double time_s) {
    m_usable = false;
    m_faults = {};
    m_contacts.clear();
    m_problem.clear();
    if (part.empty()) {
        m_problem = GelFollowerText::tr("The picture could not be decoded.").toStdString();
        return;
    }
    if (m_collects)
        collect(part);
    if (m_gel)
        follow(part, time_s);
    if (m_problem.empty() && !m_whyNoReference.empty())
        m_problem = GelFollowerText::tr("The gel at rest cannot be taken: %1")
                        .arg(QString::fromStdString(m_whyNoReference))
                        .toStdString();
}

void GelFollower::follow(const cv::Mat1b& part, double time_s) {
    if (const auto tracked = m_gel->track(withDarkMarkers(part), time_s); !tracked) {
        m_problem = tracked.error().message;
        m_finder.forget();
        return;
    }
    m_faults = m_gel->faults();
    if (m_faults.dead) {
        m_problem = GelFollowerText::tr("The picture has no contrast: is the camera covered?").toStdString();
        m_finder.forget();
        return;
    }
    m_usable = true;
    m_contacts = m_finder.next(*m_gel);
    if (m_faults.lightJumped)
        m_jumped_s = time_s;
    if (m_faults.torn)
        m_problem = GelFollowerText::tr("More than 30 % of the markers have been lost for 1 s: is the gel "
                                        "torn?")
                        .toStdString();
    else if (time_s - m_jumped_s < kTold_s)
        m_problem = GelFollowerText::tr("The light has jumped.").toStdString();
}

void GelFollower::collect(const cv::Mat1b& part) {
    m_collected.push_back(part.clone());
    if (m_collected.size() < MarkerGel::kReferencePictures)
        return;
    const std::vector<cv::Mat1b> collected = std::exchange(m_collected, {});
    (void)setReference(collected); // next() tells why not
}

core::Expected<MarkerGel> GelFollower::made(std::span<const cv::Mat1b> parts) const {
    if (parts.empty())
        return core::refused(GelFollowerText::tr(
            "The recorded pictures of the gel at rest have another size than the video."));
    std::vector<cv::Mat1b> pictures;
    pictures.reserve(parts.size());
    for (const cv::Mat1b& part : parts)
        pictures.push_back(withDarkMarkers(part));
    return MarkerGel::make(m_file, pictures);
}

core::Expected<void> GelFollower::setReference(std::span<const cv::Mat1b> parts) {
    core::Expected<MarkerGel> gel = made(parts);
    if (!gel) {
        m_whyNoReference = gel.error().message;
        return core::Unexpected(gel.error());
    }
    take(std::move(*gel), parts);
    return {};
}

void GelFollower::take(MarkerGel gel, std::span<const cv::Mat1b> parts) {
    std::vector<cv::Mat1b> used;
    for (const cv::Mat1b& part : parts.first(gel.referencePictures()))
        used.push_back(part.clone());
    m_reference = std::move(used);
    m_gel = std::move(gel);
    ++m_references;
    m_collects = false;
    m_collected.clear();
    m_whyNoReference.clear();
    forget();
}

void GelFollower::renewReference() {
    m_collects = true;
    m_collected.clear();
    m_whyNoReference.clear();
}

void GelFollower::forget() {
    if (m_gel)
        m_gel->forget();
    m_finder.forget();
    m_contacts.clear();
    m_jumped_s = -std::numeric_limits<double>::infinity();
    m_collected.clear();
}

cv::Mat1b GelFollower::withDarkMarkers(const cv::Mat1b& part) const {
    return m_file.polarity == MarkerPolarity::bright ? cv::Mat1b(255 - part) : part;
}

} // namespace teleta::vision
