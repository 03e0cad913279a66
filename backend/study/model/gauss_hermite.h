// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace teleta::study {

/// A node of Gauss-Hermite quadrature.
struct QuadratureNode {
    double at = 0.0;
    double weight = 0.0;
};

/// Nodes for the integral of f(x) exp(-x^2): exact for polynomials up to degree 2 count - 1. count: 1 .. 100.
/// From the eigenvalues of Jacobi's matrix. Thread: any. Source: Golub and Welsch 1969,
/// doi:10.1090/S0025-5718-69-99647-1.
[[nodiscard]] std::vector<QuadratureNode> gaussHermite(std::size_t count);

} // namespace teleta::study
