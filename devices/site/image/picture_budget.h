// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace teleta::site_link {

/// How a camera's pictures are sent to consoles.
struct PictureSettings {
    static constexpr int kLowestQuality = 10;
    static constexpr double kLowest_kbitPerS = 50.0;
    static constexpr double kHighest_kbitPerS = 1e6;

    int quality = 70; ///< of JPEG, at most: kLowestQuality to 100
    double most_kbitPerS = 3000.0;
};

/// Keeps the pictures of one camera below a bound. In any time T at most most_kbitPerS T is sent, and one
/// picture more. First the quality falls, so that a picture costs no more than its share of the camera's
/// rate; below kLowestQuality pictures are passed over. Thread: one (time is an argument).
class PictureBudget {
public:
    explicit PictureBudget(const PictureSettings& settings);

    /// What a picture costs on the way: its bytes, and what DDS, UDP and encryption put around each fragment.
    [[nodiscard]] static double bitsOf(std::size_t bytes);

    /// The camera gave a picture that was read at this time.
    void arrived(std::int64_t read_ns);
    /// The time for the next picture has come.
    [[nodiscard]] bool mayWrite(std::int64_t now_ns) const { return now_ns >= m_next_ns; }
    /// With which it is coded.
    [[nodiscard]] int quality() const;
    /// A picture of so many bytes is written.
    void written(std::size_t bytes, std::int64_t now_ns);

private:
    PictureSettings m_settings;
    double m_coarseness; ///< divides the coefficients, in percent, as the quality of JPEG files means it
    double m_interval_s = 0.0; ///< of the camera; 0: not known yet
    std::int64_t m_lastRead_ns = 0;
    std::int64_t m_next_ns = 0;
};

} // namespace teleta::site_link
