// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/vision/contacts/contact_reactions.h"
#include "backend/vision/gel/gel_contacts.h"

#include <optional>
#include <vector>

namespace teleta::vision {

/// How far a contact presses the skin outwards at its rim: what flows out of the patch over its
/// circumference,
///   spread = normalProxy / (2 sqrt(pi area)),
/// in m. It grows with the depth, which a flat gel does not show. Thread: any (pure).
[[nodiscard]] double spreadOf_m(const GelContactState& contact);

/// Detects bumps against a flat gel by the rules of BumpDetector, with the spread of the skin in place of the
/// depth. Thread: one.
class GelBumps {
public:
    explicit GelBumps(const BumpDetector::Settings& settings)
        : m_detector(settings) {}

    /// Takes the contacts of the next picture. period_s: since the picture before, > 0. noise_m: standard
    /// deviation of a marker's place. The bump's way is away from what presses, z of {s} points out of the
    /// gel.
    [[nodiscard]] std::optional<BumpDetector::Bump> next(const std::vector<GelContactState>& contacts,
                                                         double time_s, double period_s, double noise_m);

private:
    BumpDetector m_detector;
    std::vector<FollowedContact> m_followed; ///< of the newest picture
};

} // namespace teleta::vision
