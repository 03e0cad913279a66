// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"
#include "backend/vision/contacts/contact_identities.h"
#include "backend/vision/contacts/contact_reactions.h"
#include "backend/vision/finders/contact_finder.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace teleta::vision {

/// From frames to followed contacts and bumps. The first frame is the reference. A frame that cannot be used
/// (none, wrong size, the skin not to be seen) is counted; contacts then stay as they were for a while.
/// Thread: one.
class CameraTracker {
public:
    struct Settings {
        ContactIdentities::Settings identities;
        BumpDetector::Settings bump;
        double longestGap_s = 0.5; ///< after a longer gap all contacts are new
    };
    CameraTracker(std::unique_ptr<ContactFinder> finder, const Settings& settings);

    /// Takes the next frame; time_s: of its capture, rising. frame: may be empty. Returns the contacts that
    /// are there or end with this frame. Error: that of the finder when the first frame is no reference; the
    /// tracker then waits for another one.
    [[nodiscard]] core::Expected<std::vector<FollowedContact>> next(const cv::Mat1b& frame, double time_s);
    /// The next frame is a new reference.
    void renewReference();
    /// The stream has jumped: all contacts of the next frame are new, the reference stays.
    void forget();
    /// Goes on with another finder, which takes over the reference unless it has taken it already; contacts
    /// keep their identities. Error: that of the finder; the former one then stays. finder: not null, for
    /// images of the same size. taken: the frame that the finder has as its reference, from reference().
    [[nodiscard]] core::Expected<void> changeFinder(std::unique_ptr<ContactFinder> finder,
                                                    const cv::Mat1b& taken = {});

    [[nodiscard]] bool hasReference() const { return m_hasReference; }
    /// The frame that is the reference; empty without one. Nobody writes to its pixels.
    [[nodiscard]] cv::Mat1b reference() const { return m_hasReference ? m_reference : cv::Mat1b(); }
    /// The bump of the newest frame.
    [[nodiscard]] const std::optional<BumpDetector::Bump>& bump() const { return m_bump; }
    [[nodiscard]] std::uint64_t frames() const { return m_frames; }
    [[nodiscard]] std::uint64_t unusableFrames() const { return m_unusable; }
    /// Why the newest unusable frame was that; empty without any.
    [[nodiscard]] const std::string& whyUnusable() const { return m_whyUnusable; }
    [[nodiscard]] const ContactFinder& finder() const { return *m_finder; }

private:
    std::unique_ptr<ContactFinder> m_finder;
    Settings m_settings;
    ContactIdentities m_identities;
    BumpDetector m_bumps;
    std::optional<BumpDetector::Bump> m_bump;
    bool m_hasReference = false;
    cv::Mat1b m_reference;
    std::optional<double> m_last_s;
    std::uint64_t m_frames = 0;
    std::uint64_t m_unusable = 0;
    std::string m_whyUnusable;
};

} // namespace teleta::vision
