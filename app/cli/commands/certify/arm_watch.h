// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commands/certify/actuator_watch.h"
#include "backend/core/error.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace teleta::cli {

/// Where a joint is, as somebody else than the program under test reads it: from the topic of joint states,
/// or at a site as one more viewer. Thread: one.
class JointView : public core::Interface {
public:
    /// Waits at most so long; all positions in rad or m that came, in order.
    virtual std::vector<double> wait(std::int64_t longest_ns) = 0;
    /// Of the arm.
    [[nodiscard]] virtual std::string name() const = 0;
    [[nodiscard]] virtual bool simulated() const = 0;
};

/// Reads the joint states of an arm's file (kind = "ros_arm"). Error: that of the file and of the topic.
[[nodiscard]] core::Expected<std::unique_ptr<JointView>> viewRosJoint(const std::string& path,
                                                                      const std::string& joint);
/// Reads an arm at a site. path: of the file of a viewer, or of one without certificates, which then comes
/// with a name of its own. device: the arm's name; empty: the only one. Error: that of openSiteArm(). Throws
/// CLI::ValidationError for an unknown joint.
[[nodiscard]] core::Expected<std::unique_ptr<JointView>>
viewSiteJoint(const std::string& path, const std::string& device, const std::string& joint);

/// Watches whether a joint moves. It is at rest from the sample on after which it stayed, for kStill_ns at
/// least, within a tolerance of where it is now: what it goes at full rate in kTolerance_s. An arm of whose
/// joint nothing is heard is not at rest.
class ArmWatch : public ActuatorWatch {
public:
    static constexpr double kTolerance_s = 0.01;
    static constexpr std::int64_t kStill_ns = 50'000'000;

    /// rate: > 0, with which the joint is moved. Waits for the first position. Error: unavailable, none
    /// came within 5 s.
    [[nodiscard]] static core::Expected<std::unique_ptr<ArmWatch>> start(std::unique_ptr<JointView> view,
                                                                         double rate);
    ArmWatch(std::unique_ptr<JointView> view, double rate);

    [[nodiscard]] const JointView& view() const { return *m_view; }
    /// The newest position; empty: none came yet.
    [[nodiscard]] std::optional<double> position() const;

    [[nodiscard]] Look newest() const override;
    [[nodiscard]] std::optional<Look> offSince(std::int64_t from_ns) const override;
    [[nodiscard]] bool wasOnAfter(std::int64_t from_ns) const override;
    [[nodiscard]] std::int64_t longestGap_ns(std::int64_t from_ns) const override;
    [[nodiscard]] bool failed() const override;

private:
    struct Sample {
        std::int64_t time_ns = 0; ///< when it arrived
        double position = 0.0;
    };

    void run(const std::stop_token& stop);

    double m_tolerance;
    std::unique_ptr<JointView> m_view;
    mutable std::mutex m_mutex;
    std::vector<Sample> m_samples; ///< guarded by m_mutex; of the last seconds
    std::jthread m_thread;         ///< last, so that it ends first
};

} // namespace teleta::cli
