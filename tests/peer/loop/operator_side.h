// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_service.h"
#include "backend/core/device/arm_device.h"
#include "backend/core/threads/stop_switch.h"
#include "backend/pipeline/arm_channel.h"
#include "backend/pipeline/touch_pipeline.h"
#include "devices/site/site_client.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace teleta::test {

/// A span of steady time in which the dead-man switch was let go.
struct Rest {
    std::int64_t from_ns = 0;
    std::int64_t to_ns = 0;
};

/// The operator's place without windows: what the console runs behind its pages (connection, pipeline,
/// touches, objects, bracelet), and a hand on the dead-man switch. Thread: one, the GUI's of a console.
class OperatorSide {
public:
    /// Opens the arm of a site, with its pad, by the file of the console.
    explicit OperatorSide(const std::string& file);
    ~OperatorSide();
    OperatorSide(const OperatorSide&) = delete;
    OperatorSide& operator=(const OperatorSide&) = delete;

    /// Whether arm, pad and bracelet are there.
    [[nodiscard]] bool opened() const { return m_opened; }
    /// Why not.
    [[nodiscard]] const std::string& error() const { return m_error; }
    /// Whether control was granted.
    [[nodiscard]] bool takeControl();
    /// Holds the switch and turns one joint at a rate until it holds; then lets go and waits until the arm
    /// rests. Presses anew where this machine was so busy that the arm was held. False: not within the time.
    bool turn(std::size_t joint, double rate_radPerS, double longest_s, const std::function<bool()>& holds);
    /// Turns a joint to an angle.
    bool turnTo(std::size_t joint, double angle_rad, double rate_radPerS);
    /// Goes on without the switch.
    void wait(double duration_s);

    [[nodiscard]] double angle(std::size_t joint) const;
    /// Touches so far, in order.
    [[nodiscard]] const std::vector<pipeline::TouchRecord>& touches() const { return m_touches; }
    [[nodiscard]] std::size_t locatedTouches() const;
    [[nodiscard]] std::vector<pipeline::FoundObject> objects() const;
    /// What came to the bracelet, with its times.
    [[nodiscard]] const std::deque<console::TouchReceipt>& receipts() const { return m_bracelet.receipts(); }
    [[nodiscard]] const std::vector<Rest>& rests() const { return m_rests; }
    [[nodiscard]] std::uint64_t presses() const { return m_presses; }
    [[nodiscard]] std::uint64_t samplesLost() const { return m_channel->jointStatus().framesLost; }
    [[nodiscard]] const site_link::SiteClient& client() const { return *m_client; }

private:
    void tick();
    void post(std::size_t joint, double rate_radPerS);
    [[nodiscard]] bool eventually(const std::function<bool()>& holds, double longest_s = 10.0);

    core::StopSwitch m_stop;
    console::BraceletService m_bracelet;
    std::shared_ptr<site_link::SiteClient> m_client;
    pipeline::TouchPipeline m_pipeline;
    std::shared_ptr<pipeline::ArmChannel> m_channel;
    bool m_opened = false;
    std::string m_error;
    std::vector<pipeline::TouchRecord> m_touches;
    std::vector<Rest> m_rests;
    std::int64_t m_rested_ns = 0;
    std::uint64_t m_presses = 0;
};

} // namespace teleta::test
