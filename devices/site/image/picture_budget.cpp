// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/site/image/picture_budget.h"

#include <algorithm>
#include <cmath>

namespace teleta::site_link {

namespace {

/// Of a fragment, as devices/dds sets it for networks.
constexpr double kFragment_bytes = 1200.0;
/// IP, UDP, RTPS, and the headers and footers of encryption and signature.
constexpr double kAround_bytes = 150.0;
/// Of its share of the rate a picture may take; the rest is for those that come out larger.
constexpr double kAim = 0.9;
/// A picture that needs more than this of the aim keeps its quality.
constexpr double kEnough = 0.75;
/// Size falls with a power of the coarseness: about 0.6 for natural pictures. One step goes most of the way.
constexpr double kStep = 1.2;
constexpr double kSmallestStep = 0.5;
constexpr double kLargestStep = 8.0;
constexpr double kIntervalShare = 0.2;
constexpr double kLongestInterval_s = 2.0;

/// The scale of the Independent JPEG Group, percent of the tables of ITU-T T.81, annex K.
double coarsenessOf(double quality) {
    return quality < 50.0 ? 5000.0 / quality : std::max(1.0, 200.0 - 2.0 * quality);
}

double qualityOf(double coarseness) {
    return coarseness > 100.0 ? 5000.0 / coarseness : 0.5 * (200.0 - coarseness);
}

} // namespace

PictureBudget::PictureBudget(const PictureSettings& settings)
    : m_settings(settings)
    , m_coarseness(coarsenessOf(settings.quality)) {
}

double PictureBudget::bitsOf(std::size_t bytes) {
    const auto size = static_cast<double>(bytes);
    return 8.0 * (size + kAround_bytes * std::ceil((size + kAround_bytes) / kFragment_bytes));
}

void PictureBudget::arrived(std::int64_t read_ns) {
    const double interval_s = static_cast<double>(read_ns - m_lastRead_ns) * 1e-9;
    const bool follows = m_lastRead_ns != 0 && interval_s > 0.0 && interval_s < kLongestInterval_s;
    m_lastRead_ns = read_ns;
    if (follows)
        m_interval_s =
            m_interval_s > 0.0 ? m_interval_s + kIntervalShare * (interval_s - m_interval_s) : interval_s;
}

int PictureBudget::quality() const {
    return std::clamp(static_cast<int>(std::lround(qualityOf(m_coarseness))),
                      std::min(PictureSettings::kLowestQuality, m_settings.quality), m_settings.quality);
}

void PictureBudget::written(std::size_t bytes, std::int64_t now_ns) {
    const double cost_s = bitsOf(bytes) / (1e3 * m_settings.most_kbitPerS);
    m_next_ns = now_ns + static_cast<std::int64_t>(std::ceil(1e9 * cost_s));
    if (!(m_interval_s > 0.0))
        return;
    const double used = cost_s / (kAim * m_interval_s);
    if (used <= 1.0 && used > kEnough)
        return;
    m_coarseness = std::clamp(m_coarseness * std::clamp(std::pow(used, kStep), kSmallestStep, kLargestStep),
                              coarsenessOf(m_settings.quality),
                              coarsenessOf(std::min(PictureSettings::kLowestQuality, m_settings.quality)));
}

} // namespace teleta::site_link
