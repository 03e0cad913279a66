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

/// Turns frames into tracked contacts and bumps. The first frame is the reference. Unusable frames (empty,
/// wrong size, skin not visible) are counted; the contacts are then kept for a while. Thread: one.
class CameraTracker {
public:
    struct Settings {
        ContactIdentities::Settings identities;
        BumpDetector::Settings bump;
        double longestGap_s = 0.5; ///< after a longer gap all contacts count as new
    };
    CameraTracker(std::unique_ptr<ContactFinder> finder, const Settings& settings);

    /// Processes the next frame; it may be empty. time_s: time of capture, rising. Returns the contacts that
    /// exist or end in this frame. Error: that of the finder when the first frame cannot be a reference; the
    /// tracker then waits for another one.
    [[nodiscard]] core::Expected<std::vector<FollowedContact>> next(const cv::Mat1b& frame, double time_s);
    /// Makes the next frame a new reference.
    void renewReference();
    /// To be called when the stream has jumped: all contacts of the next frame are new; the reference is
    /// kept.
    void forget();
    /// Replaces the finder. It takes over the reference unless it already has it; contacts keep their
    /// identities. finder: not null, for images of the same size. taken: the frame from reference() that the
    /// finder already has as its reference. Error: that of the new finder; the old one is then kept.
    [[nodiscard]] core::Expected<void> changeFinder(std::unique_ptr<ContactFinder> finder,
                                                    const cv::Mat1b& taken = {});

    [[nodiscard]] bool hasReference() const { return m_hasReference; }
    /// The reference frame, or empty. Its pixels must not be changed.
    [[nodiscard]] cv::Mat1b reference() const { return m_hasReference ? m_reference : cv::Mat1b(); }
    /// The bump detected in the newest frame.
    [[nodiscard]] const std::optional<BumpDetector::Bump>& bump() const { return m_bump; }
    [[nodiscard]] std::uint64_t frames() const { return m_frames; }
    [[nodiscard]] std::uint64_t unusableFrames() const { return m_unusable; }
    /// Why the newest unusable frame was unusable; empty if there was none.
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
