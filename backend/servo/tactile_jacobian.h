// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contact/tactile_features.h"
#include "backend/servo/rigid_motion.h"

#include <array>

namespace teleta::servo {

/// The features in the order of the rows of the tactile Jacobian: [CoP_x, CoP_y, d_z, CoC_y, CoC_x, alpha_z];
/// m, and rad for the last. With this order rows 4 and 5 of the inverse Jacobian subtract a centre of
/// pressure from the centre of contact of the same axis; the paper's (6) prints CoC_x before CoC_y.
using FeatureVector = Vector6;

/// Components of a twist or of a feature error.
enum Component : int { kX = 0, kY, kZ, kWx, kWy, kWz };

/// d_z = C_z f, the depth of the contact. compliance_mPerN: > 0. Features that are not defined are 0 in the
/// vector, and false in defined.
struct MeasuredFeatures {
    FeatureVector s = FeatureVector::Zero();
    std::array<bool, 6> defined{};
};
[[nodiscard]] MeasuredFeatures featureVector(const contact::TactileFeatures& features,
                                             double compliance_mPerN);

/// Inverse tactile Jacobian: what of the features the error is made of.
///   rows 1-3: CoP_x, CoP_y, d_z;  row 4: CoC_y - beta CoP_y;  row 5: CoC_x - beta CoP_x;  row 6: beta
///   alpha_z
/// edge = true is beta = 1: rows 4 and 5 are -DZMP_x and -DZMP_y. false is beta = 0, a point.
/// Source: eq. (8).
[[nodiscard]] Matrix6 inverseTactileJacobian(bool edge);

/// Which errors act, and on which motions. Each is on or off.
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

/// What the environment does not allow at a contact: for each component either no force (the motion is free
/// and can be commanded) or no motion (the force can be commanded).
struct NaturalConstraints {
    std::array<bool, 6> noForce{};
    std::array<bool, 6> noMotion{};
};

/// For a contact frame with z along the normal and, for an edge, x along it.
/// Source: Table C.3; the row "mu_z = w_z = 0" of a point is both at once.
[[nodiscard]] NaturalConstraints naturalConstraints(contact::ContactType type);

/// Follows the direction of an edge, which is known modulo pi, without a jump.
/// The error desired - alpha is that of the branch that is nearest to the one before; the branch changes only
/// when the error has grown beyond 90 degrees by a margin, so that an edge at exactly +-90 degrees does not
/// make the control error jump between its signs. Thread: one.
class EdgeDirection {
public:
    static constexpr double kMargin_rad = 0.26; ///< 15 degrees

    /// alpha_rad in (-pi/2, pi/2] -> the same direction as the branch that is followed.
    double follow(double alpha_rad, double desired_rad);
    void reset() { m_known = false; }

private:
    bool m_known = false;
    double m_alpha_rad = 0.0;
};

} // namespace teleta::servo
