// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/speed_from_signal.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace teleta::motors {

namespace {

struct SignalText {
    Q_DECLARE_TR_FUNCTIONS(MotorRecording)
};

constexpr double kQuiet_s = 0.1;
constexpr double kNoiseFactor = 4.0;
constexpr double kSamplesPerTurn = 8.0;
constexpr double kFarOutShare = 0.02; ///< of the samples that are further out than half the largest one
constexpr int kClippedInARow = 3;
/// How long a motor may turn without being seen: below the slowest vibration, or within the noise.
constexpr double kUnseenBefore_s = 1.0 / kSlowestVibration_Hz;
constexpr double kUnseenAfter_s = 3.0 / kSlowestVibration_Hz;

/// Consecutive samples with the same extreme value mean that the converter is clipped.
bool isClipped(std::span<const double> signal, double zero) {
    for (const double side : {1.0, -1.0}) {
        double end = 0.0;
        for (const double value : signal)
            end = std::max(end, side * (value - zero));
        std::size_t out = 0;
        std::size_t flat = 0;
        int run = 0;
        for (const double value : signal) {
            const double height = side * (value - zero);
            out += height > 0.5 * end ? 1 : 0;
            run = height == end ? run + 1 : 0;
            flat += run >= kClippedInARow ? 1 : 0;
        }
        if (end > 0.0 && static_cast<double>(flat) > kFarOutShare * static_cast<double>(out))
            return true;
    }
    return false;
}

/// Times of the upward zero crossings, one per turn.
std::vector<double> crossings(std::span<const double> time_s, std::span<const double> signal, double zero,
                              double threshold) {
    std::vector<double> times_s;
    bool below = false;
    double crossed_s = 0.0;
    bool pending = false;
    for (std::size_t i = 1; i < signal.size(); ++i) {
        const double a = signal[i - 1] - zero;
        const double b = signal[i] - zero;
        if (b < -threshold) {
            below = true;
            pending = false;
        }
        if (below && a < 0.0 && b >= 0.0) {
            crossed_s = time_s[i - 1] + (time_s[i] - time_s[i - 1]) * a / (a - b);
            pending = true;
        }
        if (pending && b > threshold) {
            times_s.push_back(crossed_s);
            below = pending = false;
        }
    }
    return times_s;
}

} // namespace

core::Expected<MotorRecording> speedFromSignal(std::span<const double> time_s, std::span<const double> drive,
                                               std::span<const double> signal) {
    std::size_t quiet = 0;
    while (quiet < drive.size() && drive[quiet] == 0.0)
        ++quiet;
    const double quiet_s = quiet > 0 ? time_s[quiet - 1] - time_s[0] : 0.0;
    if (quiet < 10 || quiet_s < kQuiet_s)
        return core::refused(SignalText::tr("The recording does not begin at rest."),
                             SignalText::tr("at least %1 s with a commanded drive of 0").arg(kQuiet_s));
    double zero = 0.0;
    for (std::size_t i = 0; i < quiet; ++i)
        zero += signal[i] / static_cast<double>(quiet);
    double variance = 0.0;
    for (std::size_t i = 0; i < quiet; ++i)
        variance += (signal[i] - zero) * (signal[i] - zero) / static_cast<double>(quiet - 1);
    if (isClipped(signal, zero))
        return core::refused(SignalText::tr("The signal is clipped: it stays at the end of its range."),
                             SignalText::tr("a recording with less gain"));
    double largest = 0.0;
    for (const double value : signal)
        largest = std::max(largest, std::abs(value - zero));
    // Even without noise a threshold between rest and vibration is needed.
    const double threshold = std::max(kNoiseFactor * std::sqrt(variance), 1e-3 * largest);
    const std::vector<double> times_s = crossings(time_s, signal, zero, threshold);
    if (times_s.size() < 10)
        return core::refused(
            SignalText::tr("The signal shows no vibration above its noise."),
            SignalText::tr("a sensor on the motor, with a signal above four times its noise"));

    MotorRecording recording{{time_s.begin(), time_s.end()},
                             {drive.begin(), drive.end()},
                             std::vector<double>(time_s.size(), 0.0),
                             std::vector<bool>(time_s.size(), false)};
    std::vector<double> middles_s;
    std::vector<double> speeds_Hz;
    double fastest_Hz = 0.0;
    for (std::size_t i = 1; i < times_s.size(); ++i) {
        const double speed_Hz = 1.0 / (times_s[i] - times_s[i - 1]);
        if (speed_Hz > kFastestVibration_Hz)
            continue;
        // A longer turn is a rest between two turns.
        if (speed_Hz < kSlowestVibration_Hz)
            continue;
        middles_s.push_back(0.5 * (times_s[i] + times_s[i - 1]));
        speeds_Hz.push_back(speed_Hz);
        fastest_Hz = std::max(fastest_Hz, speed_Hz);
    }
    const double rate_Hz = static_cast<double>(time_s.size() - 1) / (time_s.back() - time_s.front());
    if (rate_Hz < kSamplesPerTurn * fastest_Hz)
        return core::refused(SignalText::tr("%1 samples per second are too few for %2 turns per second.")
                                 .arg(rate_Hz, 0, 'f', 0)
                                 .arg(fastest_Hz, 0, 'f', 0),
                             SignalText::tr("at least %1 samples per turn").arg(kSamplesPerTurn));
    std::size_t next = 0;
    for (std::size_t i = 0; i < recording.size(); ++i) {
        while (next < middles_s.size() && middles_s[next] <= time_s[i])
            ++next;
        const double a_s = next > 0 ? middles_s[next - 1] : -HUGE_VAL;
        const double b_s = next < middles_s.size() ? middles_s[next] : HUGE_VAL;
        if (b_s - a_s > 1.0 / kSlowestVibration_Hz)
            recording.unknown[i] = time_s[i] - a_s < kUnseenAfter_s || b_s - time_s[i] < kUnseenBefore_s;
        else
            recording.speed_Hz[i] = speeds_Hz[next - 1] +
                                    (speeds_Hz[next] - speeds_Hz[next - 1]) * (time_s[i] - a_s) / (b_s - a_s);
    }
    return recording;
}

} // namespace teleta::motors
