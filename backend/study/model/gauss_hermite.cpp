// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/model/gauss_hermite.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>

namespace teleta::study {

std::vector<QuadratureNode> gaussHermite(std::size_t count) {
    const auto n = static_cast<Eigen::Index>(count);
    Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index i = 1; i < n; ++i) {
        jacobi(i, i - 1) = std::sqrt(static_cast<double>(i) / 2.0);
        jacobi(i - 1, i) = jacobi(i, i - 1);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(jacobi);
    std::vector<QuadratureNode> nodes;
    for (Eigen::Index i = 0; i < n; ++i) {
        const double first = solver.eigenvectors()(0, i);
        nodes.push_back({solver.eigenvalues()(i), std::sqrt(std::numbers::pi) * first * first});
    }
    return nodes;
}

} // namespace teleta::study
