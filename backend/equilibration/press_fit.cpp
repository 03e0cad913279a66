// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/equilibration/press_fit.h"

#include "backend/core/failure.h"
#include "backend/core/quantile.h"
#include "backend/equilibration/robust_slope.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <ranges>
#include <span>
#include <utility>

namespace teleta::equilibration {

namespace {

struct PressText {
    Q_DECLARE_TR_FUNCTIONS(TaxelGains)
};

constexpr double kLoaded = 0.5;       ///< share of it from which a frame is used
constexpr double kExtreme = 10.0;     ///< a response that differs more from the median is none
constexpr double kSignificance = 5.0; ///< standard errors
constexpr int kMostRounds = 20;
constexpr double kSettled = 1e-9;
constexpr double kStuck = 0.9; ///< share of the frames in which a stuck taxel reads one value
constexpr double kStepsExpected = 3.0;
constexpr double kClipped = 3.0; ///< noise by which a clipped taxel reads too little
constexpr std::size_t kFewestBelow = kFewestPressFrames / 2; ///< frames that judge a clipped taxel
constexpr double kWeaker = 0.2;                              ///< quantile of the taxels' readings in a frame
constexpr std::size_t kMostClipped = 4; ///< one of so many taxels may be clipped in a frame that is used

/// Fits one press; see findTaxelGains().
class PressFitter {
public:
    PressFitter(std::size_t taxels, std::span<const float> raw, const contact::ConditioningSettings& settings)
        : m_taxels(taxels)
        , m_frames(raw.size() / taxels)
        , m_raw(raw)
        , m_reading(raw.size())
        , m_states(taxels, TaxelState::good)
        , m_response(taxels, 1.0)
        , m_error(taxels, 0.0)
        , m_noise(taxels, 0.0)
        , m_clip(taxels, std::numeric_limits<double>::infinity()) {
        const double sign = settings.inverted != (settings.gain < 0.0) ? -1.0 : 1.0;
        for (std::size_t i = 0; i < raw.size(); ++i) {
            const std::size_t taxel = i % taxels;
            const float tare = settings.tare.size() == taxels ? settings.tare[taxel] : 0.0F;
            m_reading[i] = sign * (static_cast<double>(raw[i]) - static_cast<double>(tare));
        }
        if (settings.dead.size() == taxels) {
            for (std::size_t i = 0; i < taxels; ++i) {
                if (settings.dead[i] != 0)
                    m_states[i] = TaxelState::dead;
            }
        }
    }

    [[nodiscard]] core::Expected<PressFit> fit() {
        const auto wanted = static_cast<std::size_t>(std::ranges::count(m_states, TaxelState::good));
        leaveOutDead();
        TELETA_CHECK(findLoadedFrames());
        TELETA_CHECK(leaveOutStuck());
        TELETA_CHECK(leaveOutClippedFrames());
        for (int round = 0; round < kMostRounds && good() > 0; ++round) {
            const double change = fitResponses(round);
            fitLevels();
            if (change < kSettled)
                break;
        }
        if (good() == 0 || 2 * good() < wanted)
            return core::refused(PressText::tr("Only %1 of %2 taxels feel the load.").arg(good()).arg(wanted),
                                 PressText::tr("a load on the whole array, and a tare taken without load"));
        return result();
    }

private:
    [[nodiscard]] double reading(std::size_t frame, std::size_t taxel) const {
        return m_reading[frame * m_taxels + taxel];
    }
    [[nodiscard]] bool isGood(std::size_t taxel) const { return m_states[taxel] == TaxelState::good; }
    [[nodiscard]] std::size_t good() const {
        return static_cast<std::size_t>(std::ranges::count(m_states, TaxelState::good));
    }

    /// A loop over them may change the state of the taxel that it is at.
    [[nodiscard]] auto goodTaxels() const {
        return std::views::iota(std::size_t{0}, m_taxels) |
               std::views::filter([this](std::size_t taxel) { return isGood(taxel); });
    }
    /// Median of the good taxels' values; 0: none is good.
    [[nodiscard]] double medianOfGood(const std::vector<double>& values) {
        m_buffer.clear();
        for (const std::size_t taxel : goodTaxels())
            m_buffer.push_back(values[taxel]);
        return m_buffer.empty() ? 0.0 : core::medianOf(m_buffer);
    }

    /// Puts the readings of the good taxels in a frame that are above a value into m_x.
    void collectFrame(std::size_t frame, double above) {
        m_x.clear();
        for (const std::size_t taxel : goodTaxels()) {
            const double y = reading(frame, taxel);
            if (std::isfinite(y) && y > above)
                m_x.push_back(y);
        }
    }

    void leaveOutDead() {
        for (std::size_t taxel = 0; taxel < m_taxels; ++taxel) {
            std::size_t finite = 0;
            for (std::size_t frame = 0; frame < m_frames; ++frame)
                finite += std::isfinite(reading(frame, taxel)) ? 1 : 0;
            if (2 * finite <= m_frames)
                m_states[taxel] = TaxelState::dead;
        }
    }

    /// levels: in rising order. A single frame in which all taxels spark is not the highest load.
    [[nodiscard]] static double peakOf(const std::vector<double>& sorted) {
        for (std::size_t i = sorted.size(); i-- > 0 && sorted[i] > 0.0;) {
            const auto half = std::lower_bound(sorted.begin(), sorted.end(), kLoaded * sorted[i]);
            if (sorted.begin() + static_cast<std::ptrdiff_t>(i) + 1 - half >=
                static_cast<std::ptrdiff_t>(kFewestPressFrames))
                return sorted[i];
        }
        return sorted.empty() ? 0.0 : sorted.back();
    }

    /// Selects the frames with at least half the highest load. The median of the taxels is the first estimate
    /// of the level.
    [[nodiscard]] core::Expected<void> findLoadedFrames() {
        std::vector<double> levels(m_frames, -std::numeric_limits<double>::infinity());
        for (std::size_t frame = 0; frame < m_frames; ++frame) {
            collectFrame(frame, -std::numeric_limits<double>::infinity());
            if (2 * m_x.size() > good())
                levels[frame] = core::medianOf(m_x);
        }
        std::vector<double> sorted = levels;
        std::ranges::sort(sorted);
        std::erase_if(sorted, [](double level) { return !std::isfinite(level); });
        const double peak = peakOf(sorted);
        for (std::size_t frame = 0; frame < m_frames; ++frame) {
            if (peak > 0.0 && levels[frame] >= kLoaded * peak) {
                m_loaded.push_back(frame);
                m_level.push_back(levels[frame]);
            }
        }
        if (m_loaded.size() < kFewestPressFrames)
            return core::refused(PressText::tr("Only %1 frames are under load.").arg(m_loaded.size()),
                                 PressText::tr("at least %1").arg(kFewestPressFrames));
        return {};
    }

    /// A taxel that reads one value although the change of the others implies several steps of the readings.
    [[nodiscard]] core::Expected<void> leaveOutStuck() {
        struct Constant {
            std::size_t taxel;
            double reading;
        };
        std::vector<Constant> constant;
        std::vector<double> usuals;
        std::vector<double> ranges;
        std::vector<double> steps;
        for (const std::size_t taxel : goodTaxels()) {
            m_x.clear();
            for (const std::size_t frame : m_loaded) {
                if (std::isfinite(reading(frame, taxel)))
                    m_x.push_back(reading(frame, taxel));
            }
            if (m_x.empty()) {
                m_states[taxel] = TaxelState::dead;
                continue;
            }
            std::ranges::sort(m_x);
            const double usual = core::quantileOf(m_x, 0.5);
            usuals.push_back(usual);
            if (static_cast<double>(std::ranges::count(m_x, usual)) >=
                kStuck * static_cast<double>(m_x.size())) {
                constant.push_back({taxel, usual});
                continue;
            }
            ranges.push_back(core::quantileOf(m_x, 0.95) - core::quantileOf(m_x, 0.05));
            double step = std::numeric_limits<double>::infinity();
            for (std::size_t i = 1; i < m_x.size(); ++i) {
                if (m_x[i] > m_x[i - 1])
                    step = std::min(step, m_x[i] - m_x[i - 1]);
            }
            steps.push_back(step);
        }
        if (constant.empty())
            return {};
        if (ranges.empty()) {
            m_y.clear();
            for (const Constant& taxel : constant)
                m_y.push_back(rawOf(taxel.taxel, taxel.reading).value_or(taxel.reading));
            const double common = core::medianOf(m_y);
            const auto same = static_cast<std::size_t>(std::ranges::count(m_y, common));
            if (constant.size() > 2 && 2 * same > constant.size())
                return core::refused(
                    PressText::tr("Most taxels read the same value in all frames: %1.").arg(common),
                    PressText::tr("a load that the taxels can measure"));
            return {};
        }
        const double range = core::medianOf(ranges);
        const double step = core::medianOf(steps);
        const double usual = core::medianOf(usuals);
        if (!(usual > 0.0))
            return {};
        for (const Constant& taxel : constant) {
            if (range * std::clamp(taxel.reading / usual, 0.0, 1.0) > kStepsExpected * step)
                m_states[taxel.taxel] = TaxelState::stuck;
        }
        return {};
    }

    /// The reading as the array gave it in a loaded frame. Empty when there is no such frame.
    [[nodiscard]] std::optional<double> rawOf(std::size_t taxel, double wanted) const {
        for (const std::size_t frame : m_loaded) {
            if (reading(frame, taxel) == wanted)
                return m_raw[frame * m_taxels + taxel];
        }
        return std::nullopt;
    }

    /// The reading of the weaker taxels in each loaded frame: they are the last to be clipped. Taxels that
    /// feel nothing are not used.
    [[nodiscard]] std::vector<double> lowLevels() {
        std::vector<double> levels;
        levels.reserve(m_loaded.size());
        for (std::size_t i = 0; i < m_loaded.size(); ++i) {
            collectFrame(m_loaded[i], m_level[i] / kExtreme);
            std::ranges::sort(m_x);
            levels.push_back(m_x.empty() ? m_level[i] : core::quantileOf(m_x, kWeaker));
        }
        return levels;
    }

    /// Where many taxels are clipped, the level that the others read is too low. A taxel is clipped in the
    /// frames of its highest reading when the load changes by several steps of its readings during them.
    [[nodiscard]] core::Expected<void> leaveOutClippedFrames() {
        const std::vector<double> low = lowLevels();
        std::vector<std::size_t> clipped(m_loaded.size(), 0);
        for (const std::size_t taxel : goodTaxels()) {
            double top = -std::numeric_limits<double>::infinity();
            double next = top;
            for (const std::size_t frame : m_loaded) {
                const double y = reading(frame, taxel);
                if (!std::isfinite(y))
                    continue;
                if (y > top) {
                    next = top;
                    top = y;
                } else if (y > next && y < top) {
                    next = y;
                }
            }
            double lowest = std::numeric_limits<double>::infinity();
            double highest = -lowest;
            for (std::size_t i = 0; i < m_loaded.size(); ++i) {
                if (reading(m_loaded[i], taxel) == top) {
                    lowest = std::min(lowest, low[i]);
                    highest = std::max(highest, low[i]);
                }
            }
            // Scaled from the weaker taxels to this one.
            if (!std::isfinite(next) || !((highest - lowest) * top > kStepsExpected * (top - next) * highest))
                continue;
            for (std::size_t i = 0; i < m_loaded.size(); ++i)
                clipped[i] += reading(m_loaded[i], taxel) == top ? 1 : 0;
        }
        std::vector<std::size_t> loaded;
        std::vector<double> level;
        for (std::size_t i = 0; i < m_loaded.size(); ++i) {
            if (kMostClipped * clipped[i] <= good()) {
                loaded.push_back(m_loaded[i]);
                level.push_back(m_level[i]);
            }
        }
        if (loaded.size() < kFewestPressFrames)
            return core::refused(
                PressText::tr("Only %1 frames under load are within the range of the taxels.")
                    .arg(loaded.size()),
                PressText::tr("at least %1, under a smaller load").arg(kFewestPressFrames));
        m_loaded = std::move(loaded);
        m_level = std::move(level);
        return {};
    }

    /// Puts the frames of a taxel and their levels into m_x and m_y, with the frames of its highest reading
    /// set apart.
    void collect(std::size_t taxel) {
        m_x.clear();
        m_y.clear();
        m_topX.clear();
        double top = -std::numeric_limits<double>::infinity();
        for (const std::size_t frame : m_loaded) {
            if (std::isfinite(reading(frame, taxel)))
                top = std::max(top, reading(frame, taxel));
        }
        m_top = top;
        for (std::size_t i = 0; i < m_loaded.size(); ++i) {
            const double y = reading(m_loaded[i], taxel);
            if (!std::isfinite(y) || !(m_level[i] > 0.0))
                continue;
            if (y < top) {
                m_x.push_back(m_level[i]);
                m_y.push_back(y);
            } else {
                m_topX.push_back(m_level[i]);
            }
        }
    }

    /// Empty when no frame determines it. A taxel that is clipped in too many frames is stuck.
    [[nodiscard]] std::optional<Slope> responseOf(std::size_t taxel, int round) {
        collect(taxel);
        m_clip[taxel] = std::numeric_limits<double>::infinity();
        if (m_x.empty() && m_topX.empty())
            return std::nullopt;
        if (m_topX.size() > 1 && !m_x.empty()) {
            const Slope below = robustSlope(m_x, m_y, m_buffer);
            double excess = 0.0;
            for (const double level : m_topX)
                excess += below.slope * level - m_top;
            excess /= static_cast<double>(m_topX.size());
            const bool judged = m_x.size() >= kFewestBelow;
            // A few frames do not determine their own noise; that of the others is known after one round.
            const double noise = judged ? below.noise : std::max(below.noise, m_usualNoise);
            if (excess > std::max(kClipped * noise, 1e-9 * m_top)) {
                if (judged) {
                    m_clip[taxel] = m_top;
                    return below;
                }
                if (round > 0) {
                    m_states[taxel] = TaxelState::stuck;
                    return std::nullopt;
                }
            }
        }
        m_y.insert(m_y.end(), m_topX.size(), m_top);
        m_x.insert(m_x.end(), m_topX.begin(), m_topX.end());
        return robustSlope(m_x, m_y, m_buffer);
    }

    /// Returns the largest relative change.
    double fitResponses(int round) {
        const std::vector<double> before = m_response;
        for (const std::size_t taxel : goodTaxels()) {
            const Slope slope = responseOf(taxel, round).value_or(Slope());
            m_response[taxel] = slope.slope;
            m_error[taxel] = slope.error;
            m_noise[taxel] = slope.noise;
        }
        m_usualNoise = medianOfGood(m_noise);
        leaveOutExtremes();
        double mean = 0.0;
        const auto used = static_cast<double>(good());
        for (const std::size_t taxel : goodTaxels())
            mean += m_response[taxel] / used;
        double change = 0.0;
        for (const std::size_t taxel : goodTaxels()) {
            m_response[taxel] /= mean;
            m_error[taxel] /= mean;
            change = std::max(change, std::abs(m_response[taxel] - before[taxel]));
        }
        return change;
    }

    void leaveOutExtremes() {
        const double usual = medianOfGood(m_response);
        for (const std::size_t taxel : goodTaxels()) {
            if (!(m_response[taxel] > std::max(usual / kExtreme, 0.0)) ||
                m_response[taxel] < kSignificance * m_error[taxel])
                m_states[taxel] = TaxelState::weak;
            else if (m_response[taxel] > usual * kExtreme)
                m_states[taxel] = TaxelState::strong;
        }
    }

    void fitLevels() {
        for (std::size_t i = 0; i < m_loaded.size(); ++i) {
            m_x.clear();
            m_y.clear();
            for (const std::size_t taxel : goodTaxels()) {
                const double y = reading(m_loaded[i], taxel);
                if (std::isfinite(y) && y < m_clip[taxel]) {
                    m_x.push_back(m_response[taxel]);
                    m_y.push_back(y);
                }
            }
            if (!m_x.empty())
                m_level[i] = robustSlope(m_x, m_y, m_buffer).slope;
        }
    }

    [[nodiscard]] PressFit result() const {
        PressFit result;
        result.states = m_states;
        result.response = m_response;
        result.error = m_error;
        result.frames = m_loaded.size();
        for (const double level : m_level)
            result.level += level / static_cast<double>(m_level.size());
        double squares = 0.0;
        for (const std::size_t taxel : goodTaxels())
            squares += std::pow(m_noise[taxel] / (m_response[taxel] * result.level), 2);
        result.scatter = std::sqrt(squares / static_cast<double>(good()));
        return result;
    }

    std::size_t m_taxels;
    std::size_t m_frames;
    std::span<const float> m_raw;
    std::vector<double> m_reading; ///< raw units above the tare, rising with the load
    std::vector<TaxelState> m_states;
    std::vector<double> m_response;
    std::vector<double> m_error;
    std::vector<double> m_noise;
    std::vector<double> m_clip; ///< the reading at which a taxel is clipped
    double m_usualNoise = 0.0;
    std::vector<std::size_t> m_loaded;
    std::vector<double> m_level; ///< of each loaded frame
    std::vector<double> m_x;
    std::vector<double> m_y;
    std::vector<double> m_topX;
    double m_top = 0.0;
    std::vector<double> m_buffer;
};

} // namespace

core::Expected<PressFit> fitPress(std::size_t taxels, const GainPress& press) {
    return PressFitter(taxels, press.frames, press.conditioning).fit();
}

} // namespace teleta::equilibration
