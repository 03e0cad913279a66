// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/contacts/camera_tracker.h"

#include "backend/vision/finders/vision_text.h"

#include <utility>

namespace teleta::vision {

CameraTracker::CameraTracker(std::unique_ptr<ContactFinder> finder, const Settings& settings)
    : m_finder(std::move(finder))
    , m_settings(settings)
    , m_identities(settings.identities)
    , m_bumps(settings.bump) {
}

core::Expected<std::vector<FollowedContact>> CameraTracker::next(const cv::Mat1b& frame, double time_s) {
    ++m_frames;
    m_bump.reset();
    if (!m_hasReference) {
        const core::Expected<void> taken = frame.empty()
                                               ? refused(VisionText::tr("The frame could not be decoded."))
                                               : m_finder->setReference(frame);
        if (!taken) {
            ++m_unusable;
            m_whyUnusable = taken.error().message;
            return core::Unexpected(taken.error());
        }
        m_hasReference = true;
        m_reference = frame.clone();
        m_last_s = time_s;
        return std::vector<FollowedContact>();
    }
    const double period_s = m_last_s ? time_s - *m_last_s : 0.0;
    if (period_s > m_settings.longestGap_s) {
        m_finder->forget();
        m_identities.endAll();
    }
    core::Expected<std::vector<CameraContact>> found =
        frame.empty() ? refused(VisionText::tr("The frame could not be decoded.")) : m_finder->find(frame);
    if (found) {
        m_last_s = time_s;
    } else {
        ++m_unusable;
        m_whyUnusable = found.error().message;
        found = std::vector<CameraContact>();
    }
    const std::vector<FollowedContact>& followed = m_identities.update(std::move(*found), time_s, period_s);
    m_bump = m_bumps.update(followed);
    return followed;
}

void CameraTracker::forget() {
    m_finder->forget();
    m_identities.forget();
}

core::Expected<void> CameraTracker::changeFinder(std::unique_ptr<ContactFinder> finder,
                                                 const cv::Mat1b& taken) {
    if (m_hasReference && taken.data != m_reference.data)
        TELETA_CHECK(finder->setReference(m_reference));
    m_finder = std::move(finder);
    if (m_hasReference)
        m_finder->forget(); // it has not seen the frames since the reference was taken
    return {};
}

void CameraTracker::renewReference() {
    m_hasReference = false;
    m_last_s.reset();
    m_identities.forget();
}

} // namespace teleta::vision
