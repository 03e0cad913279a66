// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/motors/motor_fit.h"

#include "backend/core/failure.h"
#include "backend/core/quantile.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

namespace teleta::motors {

namespace {

struct FitText {
    Q_DECLARE_TR_FUNCTIONS(MotorFit)
};

constexpr std::size_t kFewestSamples = 50;
constexpr std::size_t kPlateauSamples = 10;
constexpr double kPlateau_s = 0.08;
constexpr double kSameDrive = 0.002;
constexpr double kFullDrive = 0.995;
constexpr double kTurningShare = 0.05; ///< of the highest speed
constexpr double kSlowest_Hz = 5.0;
constexpr double kContradiction = 0.06; ///< of the start, in drive
constexpr double kFlatDrive = 0.1;
constexpr double kFlatShare = 0.01;
constexpr double kLargestError = 0.25; ///< of a time, relative
constexpr double kLeastExplained = 0.9;
constexpr double kClippedShare = 0.25;
constexpr double kSmallestStep_Hz = 1e-6;
constexpr double kLateGap = 3.0; ///< between two samples, in typical ones

QString percent(double drive) {
    return QString::number(100.0 * drive, 'f', 1) + QStringLiteral(" %");
}

struct Plateau {
    std::size_t begin = 0; ///< samples [begin, end)
    std::size_t end = 0;
    double drive = 0.0;
    double speed_Hz = 0.0;     ///< mean of the last third
    double deviation_Hz = 0.0; ///< of one sample there
    bool turns = false;
    bool slowsDown = false; ///< its speed still falls at its end
    bool fromBelow = false; ///< what came before was a lower drive
};

std::vector<Plateau> plateausOf(const MotorRecording& recording) {
    std::vector<Plateau> plateaus;
    double before = 0.0;
    for (std::size_t begin = 0; begin < recording.size();) {
        std::size_t end = begin;
        while (end < recording.size() && std::abs(recording.drive[end] - recording.drive[begin]) < kSameDrive)
            ++end;
        const double duration_s = recording.time_s[end - 1] - recording.time_s[begin];
        if (end - begin >= kPlateauSamples && duration_s >= kPlateau_s) {
            Plateau plateau{begin, end};
            plateau.drive = recording.drive[begin];
            const std::size_t settled = end - std::max<std::size_t>((end - begin) / 3, 3);
            const auto count = static_cast<double>(end - settled);
            for (std::size_t i = settled; i < end; ++i)
                plateau.speed_Hz += recording.speed_Hz[i] / count;
            for (std::size_t i = settled; i < end; ++i) {
                const double off_Hz = recording.speed_Hz[i] - plateau.speed_Hz;
                plateau.deviation_Hz += off_Hz * off_Hz / (count - 1.0);
            }
            plateau.deviation_Hz = std::sqrt(plateau.deviation_Hz);
            const std::size_t middle = settled - std::min(settled - begin, end - settled);
            double earlier_Hz = 0.0;
            for (std::size_t i = middle; i < settled; ++i)
                earlier_Hz += recording.speed_Hz[i] / static_cast<double>(settled - middle);
            plateau.slowsDown = earlier_Hz > 1.1 * plateau.speed_Hz;
            plateau.fromBelow = plateau.drive > before;
            before = plateau.drive;
            plateaus.push_back(plateau);
        }
        begin = end;
    }
    return plateaus;
}

/// Marks the plateaus on which the motor turns. Returns false when there are none.
bool markTurning(std::vector<Plateau>& plateaus) {
    double highest_Hz = 0.0;
    for (const Plateau& plateau : plateaus)
        highest_Hz = std::max(highest_Hz, plateau.speed_Hz);
    if (highest_Hz < kSlowest_Hz)
        return false;
    for (Plateau& plateau : plateaus) {
        const auto count = static_cast<double>((plateau.end - plateau.begin) / 3);
        const double sure_Hz = 4.0 * plateau.deviation_Hz / std::sqrt(std::max(count, 1.0));
        plateau.turns = plateau.speed_Hz > std::max(kTurningShare * highest_Hz, sure_Hz);
    }
    return std::ranges::any_of(plateaus, &Plateau::turns);
}

/// A sensor at the end of its range repeats exactly the same value although there is noise, or for different
/// drives.
bool isClipped(const MotorRecording& recording, const std::vector<Plateau>& plateaus) {
    const double highest_Hz = *std::ranges::max_element(recording.speed_Hz);
    const auto atEnd = [&](const Plateau& plateau) {
        const auto speeds = std::span(recording.speed_Hz).subspan(plateau.begin, plateau.end - plateau.begin);
        return static_cast<double>(std::ranges::count(speeds, highest_Hz)) /
               static_cast<double>(speeds.size());
    };
    std::vector<double> drives;
    double noise_Hz = 0.0;
    double most = 0.0;
    for (const Plateau& plateau : plateaus) {
        if (!plateau.turns)
            continue;
        const double share = atEnd(plateau);
        most = std::max(most, share);
        if (share > kClippedShare)
            drives.push_back(plateau.drive);
        else
            noise_Hz = std::max(noise_Hz, plateau.deviation_Hz);
    }
    const bool differentDrives =
        !drives.empty() && *std::ranges::max_element(drives) - *std::ranges::min_element(drives) > kSameDrive;
    return differentDrives || (most > kClippedShare && noise_Hz > 1e-3 * highest_Hz);
}

struct StartInterval {
    double low = 0.0;
    double high = 1.0;
};

core::Expected<StartInterval> startOf(const std::vector<Plateau>& plateaus) {
    double stood = 0.0;
    double started = 1.0;
    bool atRest = true;
    for (const Plateau& plateau : plateaus) {
        if (!plateau.turns)
            stood = std::max(stood, plateau.drive);
        else if (atRest)
            started = std::min(started, plateau.drive);
        atRest = !plateau.turns;
    }
    if (stood - started > kContradiction)
        return core::refused(
            FitText::tr("The motor started at %1 of the full drive but stood still at %2.")
                .arg(percent(started), percent(stood)),
            FitText::tr("a motor that starts at the same drive each time; look for a loose contact"));
    return StartInterval{std::min(stood, started), std::max(stood, started)};
}

std::vector<SpeedLevel> levelsOf(const std::vector<Plateau>& plateaus, double start) {
    std::map<long, std::vector<const Plateau*>> byDrive;
    for (const Plateau& plateau : plateaus)
        if (plateau.turns && plateau.drive >= start)
            byDrive[std::lround(plateau.drive / kSameDrive)].push_back(&plateau);
    std::vector<SpeedLevel> levels;
    for (const auto& [key, same] : byDrive) {
        SpeedLevel level;
        for (const Plateau* plateau : same) {
            level.drive += plateau->drive / static_cast<double>(same.size());
            level.speed_Hz += plateau->speed_Hz / static_cast<double>(same.size());
        }
        if (levels.empty() || level.drive - levels.back().drive > kSameDrive)
            levels.push_back(level);
    }
    return levels;
}

/// Where samples are missing.
struct Gaps {
    double longest_s = 0.0; ///< a longer time between two samples is a gap
    double share = 0.0;     ///< of the recording's time
};

Gaps gapsOf(const MotorRecording& recording) {
    std::vector<double> between_s;
    for (std::size_t i = 1; i < recording.size(); ++i)
        between_s.push_back(recording.time_s[i] - recording.time_s[i - 1]);
    Gaps gaps{kLateGap * core::medianOf(std::vector(between_s))};
    for (const double time_s : between_s)
        if (time_s > gaps.longest_s)
            gaps.share += time_s / (recording.time_s.back() - recording.time_s.front());
    return gaps;
}

/// Samples from which the model starts again with the measured speed: those in which the motor turns although
/// the drive is below its start, and those after a gap in which the drive changed at an unknown time.
std::vector<bool> restarts(const MotorRecording& recording, const std::vector<Plateau>& plateaus,
                           double start, double longestGap_s) {
    std::vector<bool> ignored(recording.size(), false);
    for (std::size_t i = 1; i < recording.size(); ++i)
        ignored[i] = recording.drive[i] != recording.drive[i - 1] &&
                     recording.time_s[i] - recording.time_s[i - 1] > longestGap_s;
    for (const Plateau& plateau : plateaus)
        if (plateau.turns && !plateau.slowsDown && plateau.drive > kSameDrive && plateau.drive < start)
            std::fill(ignored.begin() + static_cast<std::ptrdiff_t>(plateau.begin),
                      ignored.begin() + static_cast<std::ptrdiff_t>(plateau.end), true);
    return ignored;
}

bool falls(const MotorRecording& recording, const std::vector<Plateau>& plateaus) {
    return std::ranges::any_of(plateaus, [&](const Plateau& plateau) {
        return plateau.turns && plateau.end < recording.size() &&
               recording.drive[plateau.end] < plateau.drive - kSameDrive;
    });
}

/// The lowest drive above which the speed no longer rises; empty when it always rises.
std::optional<double> flatFrom(const std::vector<SpeedLevel>& levels) {
    const SpeedLevel& full = levels.back();
    for (const SpeedLevel& level : levels) {
        const double sure_Hz = 2.0 * std::hypot(level.error_Hz, full.error_Hz);
        if (full.drive - level.drive >= kFlatDrive &&
            full.speed_Hz - level.speed_Hz < std::max(sure_Hz, kFlatShare * full.speed_Hz))
            return level.drive;
    }
    return std::nullopt;
}

/// Makes the speeds rise: neighbours in the wrong order because of noise are pooled (pool adjacent
/// violators).
std::vector<pattern::SpeedPoint> risingCurve(const std::vector<SpeedLevel>& levels, double start) {
    struct Pool {
        double drive, speed_Hz, weight;
        int levels;
    };
    std::vector<Pool> pools;
    for (const SpeedLevel& level : levels) {
        const double error_Hz = std::max(level.error_Hz, kSmallestStep_Hz);
        pools.push_back({level.drive, level.speed_Hz, 1.0 / (error_Hz * error_Hz), 1});
        while (pools.size() > 1 &&
               pools.back().speed_Hz < pools[pools.size() - 2].speed_Hz + kSmallestStep_Hz) {
            const Pool last = pools.back();
            pools.pop_back();
            Pool& pool = pools.back();
            const double weight = pool.weight + last.weight;
            pool.speed_Hz = (pool.speed_Hz * pool.weight + last.speed_Hz * last.weight) / weight;
            pool.weight = weight;
            pool.drive = (pool.drive * pool.levels + last.drive * last.levels) / (pool.levels + last.levels);
            pool.levels += last.levels;
        }
    }
    std::vector<pattern::SpeedPoint> curve;
    if (pools.size() < 2)
        return curve;
    if (const Pool& a = pools[0]; a.drive > start) {
        const double slope = (pools[1].speed_Hz - a.speed_Hz) / (pools[1].drive - a.drive);
        const double atStart_Hz = std::max(a.speed_Hz - slope * (a.drive - start), 0.0);
        curve.push_back({start, std::min(atStart_Hz, 0.999 * a.speed_Hz)});
    }
    for (const Pool& pool : pools)
        curve.push_back({pool.drive, pool.speed_Hz});
    // The last level may have been pooled, or its drive written as 4094 of 4095.
    const pattern::SpeedPoint a = curve[curve.size() - 2];
    pattern::SpeedPoint& last = curve.back();
    last.speed_Hz += (last.speed_Hz - a.speed_Hz) / (last.drive - a.drive) * (1.0 - last.drive);
    last.drive = 1.0;
    return curve;
}

core::Expected<void> checkExtent(const MotorRecording& recording, const std::vector<Plateau>& plateaus) {
    const auto [lowest, highest] = std::ranges::minmax_element(recording.drive);
    if (*highest - *lowest < kSameDrive)
        return core::refused(FitText::tr("There is no step: the drive is the same all the time."),
                             FitText::tr("a staircase of drives from 0 to the full one"));
    if (*highest < kFullDrive)
        return core::refused(
            FitText::tr("The full drive was never commanded: the highest is %1.").arg(percent(*highest)),
            FitText::tr("a staircase of drives from 0 to the full one"));
    if (recording.drive.front() > 0.0)
        return core::refused(FitText::tr("The recording does not begin at rest."),
                             FitText::tr("a commanded drive of 0 at the beginning"));
    if (plateaus.empty())
        return core::refused(
            FitText::tr("The recording is too short: no drive was held for %1 s.").arg(kPlateau_s),
            FitText::tr("a drive that is held until the motor has followed, 0.3 s"));
    return {};
}

core::Expected<void> checkTimes(const LagFit& lag) {
    const auto unsure = [](double value, double error) { return !(error < kLargestError * value); };
    if (unsure(lag.up_s, lag.upError_s))
        return core::refused(
            FitText::tr("The rise time cannot be determined: %1 s with a standard error of %2 s.")
                .arg(lag.up_s * std::numbers::ln10, 0, 'g', 2)
                .arg(lag.upError_s * std::numbers::ln10, 0, 'g', 2),
            FitText::tr("more samples per second, or less noise"));
    if (unsure(lag.down_s, lag.downError_s))
        return core::refused(
            FitText::tr("The fall time cannot be determined: %1 s with a standard error of %2 s.")
                .arg(lag.down_s * std::numbers::ln10, 0, 'g', 2)
                .arg(lag.downError_s * std::numbers::ln10, 0, 'g', 2),
            FitText::tr("more samples per second, or less noise"));
    if (lag.explained < kLeastExplained)
        return core::refused(
            FitText::tr(
                "The motor does not behave like a motor with a lag: the model explains %1 of the speed.")
                .arg(percent(std::max(lag.explained, 0.0))),
            FitText::tr("a recording of one motor with the drive at the same times"));
    return {};
}

} // namespace

core::Expected<MotorFit> fitMotor(const MotorRecording& recording) {
    TELETA_CHECK(checkMotorRecording(recording));
    if (recording.size() < kFewestSamples)
        return core::refused(FitText::tr("The recording is too short: %1 samples.").arg(recording.size()),
                             FitText::tr("at least %1").arg(kFewestSamples));
    std::vector<Plateau> plateaus = plateausOf(recording);
    TELETA_CHECK(checkExtent(recording, plateaus));
    if (!markTurning(plateaus))
        return core::refused(FitText::tr("The motor does not turn, not even at the full drive."),
                             FitText::tr("a connected motor, and its sensor"));
    if (plateaus.front().drive == 0.0 && plateaus.front().turns)
        return core::refused(FitText::tr("The speed is not 0 although nothing is commanded: %1 Hz.")
                                 .arg(plateaus.front().speed_Hz, 0, 'f', 1),
                             FitText::tr("a sensor without an offset, and a motor at rest at the beginning"));
    if (isClipped(recording, plateaus))
        return core::refused(FitText::tr("The speed is clipped: it stays at the end of the sensor's range."),
                             FitText::tr("a sensor with a larger range"));
    TELETA_TRY(const auto start, startOf(plateaus));
    const double startDrive = 0.5 * (start.low + start.high);
    const std::vector<SpeedLevel> levels = levelsOf(plateaus, startDrive);
    if (levels.size() < 2)
        return core::refused(
            FitText::tr("The motor turned at one level of the drive only: neither its start nor "
                        "its curve can be determined."),
            FitText::tr("a staircase of drives from 0 to the full one"));
    if (!falls(recording, plateaus))
        return core::refused(
            FitText::tr("The drive never falls while the motor turns: the fall time cannot be determined."),
            FitText::tr("a step down at the end"));
    const Gaps gaps = gapsOf(recording);
    auto lag =
        fitLag(recording, startDrive, levels, restarts(recording, plateaus, startDrive, gaps.longest_s));
    if (!lag)
        return core::refused(FitText::tr("The samples do not determine the motor's lag."),
                             FitText::tr("more samples per second during the steps"));
    if (const auto flat = flatFrom(lag->levels))
        return core::refused(FitText::tr("The speed is saturated: it does not rise above %1 of the drive.")
                                 .arg(percent(*flat)),
                             FitText::tr("a supply and a sensor that reach the full drive"));
    TELETA_CHECK(checkTimes(*lag));

    MotorFit fit;
    fit.profile = pattern::MotorProfile::assumedCoinMotor();
    fit.profile.name.clear();
    fit.profile.assumed = fit.profile.rangeAssumed = false;
    fit.profile.startDrive = startDrive;
    fit.profile.riseTime_s = lag->up_s * std::numbers::ln10;
    fit.profile.fallTime_s = lag->down_s * std::numbers::ln10;
    fit.profile.curve = risingCurve(lag->levels, startDrive);
    fit.startLow = start.low;
    fit.startHigh = start.high;
    fit.startError = (start.high - start.low) / std::sqrt(12.0);
    fit.riseError_s = lag->upError_s * std::numbers::ln10;
    fit.fallError_s = lag->downError_s * std::numbers::ln10;
    fit.gapShare = gaps.share;
    fit.levels = std::move(lag->levels);
    fit.residual_Hz = lag->residual_Hz;
    fit.explained = lag->explained;
    fit.predicted_Hz = std::move(lag->predicted_Hz);
    if (!fit.profile.valid())
        return core::refused(FitText::tr(
            "The measurement does not describe a motor: the speed does not rise with the drive."));
    return fit;
}

} // namespace teleta::motors
