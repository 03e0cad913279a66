// SPDX-License-Identifier: GPL-3.0-or-later
#include "operator_side.h"

#include "app/sources/site_request.h"
#include "app/sources/source_request.h"
#include "backend/core/steady_time.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/playback/pattern_program.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace teleta::test {

namespace {

using namespace std::chrono_literals;

/// As often as a view does while a key is held.
constexpr auto kTick = 5ms;
/// An arm that does not follow for so long was held.
constexpr double kHeld_s = 0.5;
/// An arm that was told to brake over the link rests after that.
constexpr double kRest_s = 0.4;
/// From a command to its effect in the readings.
constexpr double kLoop_s = 0.1;
constexpr double kElbowWait_s = 6.0;
constexpr double kDeceleration_radPerS2 = 3.0;

double now_s() {
    return 1e-9 * static_cast<double>(core::steadyNow_ns());
}

} // namespace

OperatorSide::OperatorSide(const std::string& file)
    : m_bracelet(m_stop) {
    auto devices = app::siteDevicesOf(file, m_stop, [] { return false; });
    if (!devices) {
        m_error = core::describe(devices.error());
        return;
    }
    m_client = devices->site;
    m_bracelet.choose(console::BraceletChoice::simulated);
    m_bracelet.setLibrary([](const std::string& id) {
        const pattern::Pattern* pattern = pattern::findBuiltIn(id);
        return pattern != nullptr ? playback::programOf(*pattern) : playback::Program{};
    });
    m_bracelet.setMap(pattern::PatternMap::defaults());
    m_bracelet.setMode(pipeline::FeedbackMode::stiffness);
    (void)m_pipeline.open(app::makeSourceFactory(devices->devices.front(), m_stop));
    (void)eventually([this] {
        for (const pipeline::ChannelEvent& event : m_pipeline.takeEvents()) {
            m_channel = std::dynamic_pointer_cast<pipeline::ArmChannel>(event.channel);
            m_error = event.channel ? "the arm has no pad" : core::describe(event.error);
        }
        return m_channel != nullptr || !m_error.empty();
    });
    if (!m_channel)
        return;
    // Pressed this slowly, a soft object is felt by the elbow long after the shoulder has felt it.
    pipeline::ArmSettings settings = m_channel->settings();
    settings.touch.elbowWait_s = kElbowWait_s;
    m_channel->post(settings);
    m_channel->setFeedback(m_bracelet.feedback());
    m_opened = eventually([this] { return m_bracelet.isReady() && m_channel->generation() > 0; });
}

OperatorSide::~OperatorSide() {
    if (m_channel)
        m_channel->setFeedback(nullptr);
}

void OperatorSide::tick() {
    std::this_thread::sleep_for(kTick);
    m_bracelet.setSiteClock(m_client->view().clock);
    m_bracelet.tick();
    if (!m_channel)
        return;
    (void)m_channel->update();
    for (pipeline::TouchRecord touch; m_channel->popTouch(touch);)
        m_touches.push_back(touch);
    for (core::JointSample sample; m_channel->popSample(sample);) {
    }
}

bool OperatorSide::eventually(const std::function<bool()>& holds, double longest_s) {
    for (const double end_s = now_s() + longest_s; now_s() < end_s;) {
        tick();
        if (holds())
            return true;
    }
    return false;
}

bool OperatorSide::takeControl() {
    const std::uint64_t id = m_client->request(site::RequestKind::request);
    return eventually([&] {
               const auto request = m_client->view().request;
               return request && request->id == id && request->answer == site::RequestAnswer::done;
           }) &&
           eventually([this] { return m_channel->device().hindrance().empty(); });
}

void OperatorSide::post(std::size_t joint, double rate_radPerS) {
    core::ArmCommand command;
    command.rate_radPerS = core::JointVector::zeros(m_channel->description().joints());
    command.rate_radPerS[joint] = rate_radPerS;
    command.time_ns = core::steadyNow_ns();
    m_channel->device().post(command);
}

double OperatorSide::angle(std::size_t joint) const {
    return m_channel->snapshot().newest.angle_rad[joint];
}

bool OperatorSide::turn(std::size_t joint, double rate_radPerS, double longest_s,
                        const std::function<bool()>& holds) {
    const double end_s = now_s() + longest_s;
    bool held = false;
    while (now_s() < end_s && !holds()) {
        if (m_rested_ns != 0)
            m_rests.push_back({m_rested_ns, core::steadyNow_ns()});
        m_rested_ns = 0;
        ++m_presses;
        double from_rad = angle(joint);
        double from_s = now_s();
        for (held = false; !held && now_s() < end_s && !holds();) {
            post(joint, rate_radPerS);
            tick();
            if (now_s() - from_s < kHeld_s)
                continue;
            // Half of the way, and no more than what the noise of the readings may hide.
            held = std::abs(angle(joint) - from_rad) < 0.5 * kHeld_s * std::abs(rate_radPerS);
            from_rad = angle(joint);
            from_s = now_s();
        }
        post(joint, 0.0);
        wait(kRest_s);
        m_rested_ns = core::steadyNow_ns();
    }
    return holds();
}

bool OperatorSide::turnTo(std::size_t joint, double angle_rad, double rate_radPerS) {
    // Quickly, then slowly.
    for (const double rate : {rate_radPerS, 0.2 * rate_radPerS}) {
        const double left_rad = angle_rad - angle(joint);
        const double early_rad = rate * kLoop_s + rate * rate / (2.0 * kDeceleration_radPerS2);
        if (std::abs(left_rad) <= early_rad)
            continue;
        const double sign = left_rad > 0.0 ? 1.0 : -1.0;
        if (!turn(joint, sign * rate, 5.0 + 3.0 * std::abs(left_rad) / rate,
                  [&] { return sign * (angle_rad - angle(joint)) <= early_rad; }))
            return false;
    }
    return true;
}

void OperatorSide::wait(double duration_s) {
    for (const double end_s = now_s() + duration_s; now_s() < end_s;)
        tick();
}

std::size_t OperatorSide::locatedTouches() const {
    return static_cast<std::size_t>(std::ranges::count_if(m_touches, &pipeline::TouchRecord::located));
}

std::vector<pipeline::FoundObject> OperatorSide::objects() const {
    return m_channel->snapshot().objects;
}

} // namespace teleta::test
