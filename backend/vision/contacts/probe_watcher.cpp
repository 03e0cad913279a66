// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/vision/contacts/probe_watcher.h"

#include "backend/vision/camera/nominal_camera.h"
#include "backend/vision/finders/contact_ladder.h"

#include <utility>

namespace teleta::vision {

core::Expected<std::unique_ptr<ProbeWatcher>> ProbeWatcher::make(const CalibrationSettings& settings,
                                                                 const std::stop_token& stop) {
    auto finder =
        makeContactFinder(contactLadder().front(),
                          nominalCamera(settings.width_px, settings.height_px, settings.surface), {}, stop);
    TELETA_CHECK(finder);
    return std::unique_ptr<ProbeWatcher>(new ProbeWatcher(std::move(*finder)));
}

core::Expected<void> ProbeWatcher::setReference(const cv::Mat1b& frame) {
    m_contacts.clear();
    m_collector.skip();
    auto taken = m_finder->setReference(frame);
    m_hasReference = taken.has_value();
    m_problem = taken ? std::string() : taken.error().message;
    return taken;
}

std::optional<Eigen::Vector2d> ProbeWatcher::next(const cv::Mat1b& frame, double time_s) {
    // Each frame is processed independently: with an inaccurate camera some dots at the far end are taken for
    // others and would drift from frame to frame.
    m_finder->forget();
    auto contacts = m_finder->find(frame);
    if (!contacts) {
        m_collector.skip();
        m_contacts.clear();
        m_problem = contacts.error().message;
        ++m_unusable;
        return std::nullopt;
    }
    m_problem.clear();
    m_contacts = std::move(*contacts);
    return m_collector.next(m_contacts, time_s);
}

} // namespace teleta::vision
