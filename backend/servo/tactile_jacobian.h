// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/tactile_features.h"
#include "backend/servo/arm/rigid_motion.h"

#include <array>

namespace teleta::servo {

/// The features in the order of the rows of the tactile Jacobian: [CoP_x, CoP_y, d_z, CoC_y, CoC_x, alpha_z];
/// in m, the last in rad. In this order rows 4 and 5 of the inverse Jacobian subtract centre of pressure and
/// centre of contact of the same axis; the paper's (6) prints CoC_x before CoC_y.
using FeatureVector = Vector6;

/// Components of a twist or of a feature error.
enum Component : int { kX = 0, kY, kZ, kWx, kWy, kWz };

/// The feature vector s of a frame; undefined features are 0 in s and false in `defined`. compliance_mPerN:
/// C_z > 0, which gives the depth of the contact d_z = C_z f.
struct MeasuredFeatures {
    FeatureVector s = FeatureVector::Zero();
    std::array<bool, 6> defined{};
};
[[nodiscard]] MeasuredFeatures featureVector(const contact::TactileFeatures& features,
                                             double compliance_mPerN);

/// Inverse tactile Jacobian, which maps features to the quantities that are controlled:
///   rows 1-3: CoP_x, CoP_y, d_z;  row 4: CoC_y - beta CoP_y;  row 5: CoC_x - beta CoP_x;  row 6: beta
///   alpha_z
/// edge = true: beta = 1, rows 4 and 5 are -DZMP_x and -DZMP_y. false: beta = 0, a point. Source: eq. (8).
[[nodiscard]] Matrix6 inverseTactileJacobian(bool edge);

/// Which errors are controlled, and by which motions.
struct Projection {
    bool x = false;
    bool y = false;
    bool z = false;
    bool wx = false;
    bool wy = false;
    bool wz = false;
    bool com = false; ///< the error of row 5 moves the sensor along x (co-manipulation)

    bool operator==(const Projection&) const = default;
};

/// Projection matrix: the diagonal, and gamma_com in row 1, column 5. Source: eq. (10); (20) prints it in
/// column 4.
[[nodiscard]] Matrix6 projectionMatrix(const Projection& projection);

/// Follows the direction of an edge, which is known modulo pi, without jumps. Of all equivalent angles the
/// one nearest to the previous one is taken. Only when the error desired - alpha has exceeded 90 degrees by
/// kMargin_rad does it switch by pi, so that the control error does not jump between both signs for an edge
/// at exactly +-90 degrees. Thread: one.
class EdgeDirection {
public:
    static constexpr double kMargin_rad = 0.26; ///< 15 degrees

    /// Returns the angle, equal to alpha_rad modulo pi, that continues the followed direction. alpha_rad:
    /// (-pi/2, pi/2].
    double follow(double alpha_rad, double desired_rad);
    void reset() { m_known = false; }

private:
    bool m_known = false;
    double m_alpha_rad = 0.0;
};

} // namespace teleta::servo
