// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/shear_load.h"
#include "backend/core/data/array_layout.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace teleta::contact {

enum class ContactType { none, point, edge };

/// Which taxels the principal axis is computed from.
enum class OrientationMode {
    binarised, ///< covariance of the active taxels' coordinates, n - 1 in the denominator
    weighted,  ///< the same, each taxel weighted with its load
};

/// Which taxels force and centre of pressure are summed over.
enum class MomentRange {
    image,  ///< the whole image, as in (B.1)
    active, ///< active taxels only; for large arrays, where the noise of many unloaded taxels adds up
};

struct FeatureSettings {
    double threshold_N = 0.2; ///< a taxel is active when its load is at least this (compared as float). A
                              ///< value that is not > 0 acts as the smallest positive load
    bool automaticThreshold = false; ///< use the threshold of automaticThreshold() in each frame, with
                                     ///< threshold_N as its lower bound
    OrientationMode orientation = OrientationMode::binarised;
    MomentRange range = MomentRange::image;
    double edgeRatio = 4.0; ///< a contact becomes an edge when lambda1/lambda2 rises above this
    double pointRatio =
        2.5; ///< an edge becomes a point again when lambda1/lambda2 falls below this; < edgeRatio
};

/// Tactile features of one frame, in the sensor frame {s}. An undefined feature is empty, never 0.
struct TactileFeatures {
    ContactType type = ContactType::none;
    double force_N = 0.0;         ///< M_00
    std::optional<double> copX_m; ///< centre of pressure, M_10/M_00
    std::optional<double> copY_m;
    std::optional<double> cocX_m; ///< centre of contact: centroid of the binary image
    std::optional<double> cocY_m;
    std::optional<double> dzmpX_m;    ///< CoP_y - CoC_y: moment about x
    std::optional<double> dzmpY_m;    ///< CoP_x - CoC_x: moment about y
    std::optional<double> alphaZ_rad; ///< direction of the first principal axis, (-pi/2, pi/2]; empty for one
                                      ///< taxel or an isotropic contact
    std::optional<double>
        lambda1_m2; ///< eigenvalues of the covariance, lambda1 >= lambda2; need two active taxels
    std::optional<double> lambda2_m2;
    std::optional<ShearLoad> shear; ///< of a frame of vectors in which something touches
    int active = 0;                 ///< number of taxels at or above the threshold
    int dead = 0;                   ///< number of taxels left out because they are dead or not finite
    double peak_N = 0.0;            ///< largest load
    double threshold_N = 0.0;       ///< the threshold used
};

/// Computes the features of frames of one stream.
///   M_ij = sum x^i y^j I(x,y)                                         (B.1)
///   CoP = (M_10, M_01)/M_00;  CoC the same of the binary image        (B.2)-(B.3)
///   DZMP_x = CoP_y - CoC_y,  DZMP_y = CoP_x - CoC_x
///   lambda_1,2 from the 2 x 2 covariance in closed form, without cancellation
/// The decision between point and edge has hysteresis, so the object remembers the type of the previous
/// frame; reset() forgets it. Thread: one; compute() allocates nothing. Source: tactile servoing paper,
/// section 3 and appendix B; (B.4) with n = taxels in contact (erratum 1).
class FeatureExtractor {
public:
    explicit FeatureExtractor(const core::ArrayLayout& layout, const FeatureSettings& settings = {});

    /// load_N: layout.taxels() loads >= 0, row-major, as FrameConditioner gives them. dead: 1 for each taxel
    /// to leave out, or empty. Non-finite and negative values are left out and counted as dead.
    [[nodiscard]] TactileFeatures compute(std::span<const float> load_N,
                                          std::span<const std::uint8_t> dead = {});

    /// The least load that is active by the settings' own threshold.
    [[nodiscard]] float activeFrom_N() const;

    /// The type of the next frame's contact, after that of the frame before. lambda1, lambda2: the
    /// eigenvalues in taxels^2, of two active taxels or more.
    ContactType typeOf(std::int64_t active, double lambda1, double lambda2) {
        m_previous = active > 1    ? classify(lambda1, lambda2)
                     : active == 1 ? ContactType::point
                                   : ContactType::none;
        return m_previous;
    }

    void setSettings(const FeatureSettings& settings) { m_settings = settings; }
    [[nodiscard]] const FeatureSettings& settings() const { return m_settings; }
    void reset() { m_previous = ContactType::none; }

private:
    int clean(std::span<const float> load_N, std::span<const std::uint8_t> dead);

    [[nodiscard]] ContactType classify(double lambda1, double lambda2) const {
        if (m_previous == ContactType::edge) {
            const double ratio =
                m_settings.pointRatio < m_settings.edgeRatio ? m_settings.pointRatio : m_settings.edgeRatio;
            return lambda1 >= ratio * lambda2 ? ContactType::edge : ContactType::point;
        }
        return lambda1 > m_settings.edgeRatio * lambda2 ? ContactType::edge : ContactType::point;
    }

    core::ArrayLayout m_layout;
    FeatureSettings m_settings;
    std::size_t m_stride;        ///< columns of a cleaned row
    std::vector<float> m_clean;  ///< the frame, with 0 at the taxels that are left out
    std::vector<float> m_usable; ///< the loads of the other taxels
    ContactType m_previous = ContactType::none;
};

/// Name in files and on the command line: "none", "point", "edge".
[[nodiscard]] const char* toString(ContactType type);

} // namespace teleta::contact
