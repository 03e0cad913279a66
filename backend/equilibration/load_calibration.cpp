// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/equilibration/load_calibration.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

#include <Eigen/SVD>

#include <vector>

namespace teleta::equilibration {

namespace {

struct LoadText {
    Q_DECLARE_TR_FUNCTIONS(LoadCalibration)
};

/// The rows with and without load.
struct Sorted {
    std::vector<Eigen::Index> pressed, free;
};

Sorted sorted(const Eigen::MatrixXd& load) {
    Sorted rows;
    for (Eigen::Index row = 0; row < load.rows(); ++row)
        (load.row(row).isZero(0.0) ? rows.free : rows.pressed).push_back(row);
    return rows;
}

} // namespace

LoadCalibration::Loads LoadCalibration::at(const Eigen::VectorXd& values) const {
    const bool outside = values.allFinite() && !(((values - least).array() >= 0.0).all() &&
                                                 ((greatest - values).array() >= 0.0).all());
    const Eigen::VectorXd moved = values - rest;
    const Eigen::VectorXd ofGains = error * moved.cwiseAbs();
    return {.loads = gain * moved,
            .errors = (scatter.array().square() + ofGains.array().square()).sqrt(),
            .extrapolated = outside};
}

core::Expected<LoadCalibration> findLoadCalibration(const KnownPresses& presses) {
    const Eigen::Index channels = presses.signal.cols();
    const Sorted rows = sorted(presses.load);
    const auto pressed = static_cast<Eigen::Index>(rows.pressed.size());
    const Eigen::Index needed = channels + kSparePresses;
    if (pressed < needed)
        return core::refused(
            LoadText::tr("%1 presses under load are too few for %2 signals").arg(pressed).arg(channels),
            LoadText::tr("at least %1 presses").arg(needed));
    for (Eigen::Index i = 0; i < presses.load.cols(); ++i) {
        const auto load = presses.load.col(i);
        if (!(load.maxCoeff() > load.minCoeff()))
            return core::refused(LoadText::tr("%1 is the same in all presses")
                                     .arg(QString::fromStdString(presses.loads[static_cast<std::size_t>(i)])),
                                 LoadText::tr("loads of different sizes"));
    }
    LoadCalibration found{.loads = presses.loads,
                          .channels = presses.channels,
                          .rest = Eigen::VectorXd::Zero(channels),
                          .least = presses.signal.colwise().minCoeff(),
                          .greatest = presses.signal.colwise().maxCoeff()};
    if (!rows.free.empty())
        found.rest = presses.signal(rows.free, Eigen::all).colwise().mean();
    const Eigen::MatrixXd load = presses.load(rows.pressed, Eigen::all);
    Eigen::MatrixXd x = presses.signal(rows.pressed, Eigen::all).rowwise() - found.rest.transpose();
    const Eigen::VectorXd size = x.colwise().norm();
    for (Eigen::Index i = 0; i < channels; ++i) {
        if (!(found.greatest[i] > found.least[i]) || !(size[i] > 0.0))
            return core::refused(
                LoadText::tr("%1 is the same in all presses")
                    .arg(QString::fromStdString(presses.channels[static_cast<std::size_t>(i)])),
                LoadText::tr("presses that change each signal"));
        x.col(i) /= size[i];
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(x, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::VectorXd& singular = svd.singularValues();
    found.condition =
        singular[channels - 1] > 0.0 ? singular[0] / singular[channels - 1] : kMostCondition + 1.0;
    if (!(found.condition <= kMostCondition))
        return core::refused(LoadText::tr("the presses do not tell the signals apart"),
                             LoadText::tr("presses in which each signal changes without the others"));
    const Eigen::MatrixXd scaled = svd.solve(load); // signals x loads
    found.gain = (size.cwiseInverse().asDiagonal() * scaled).transpose();
    const Eigen::VectorXd squares = (load - x * scaled).colwise().squaredNorm();
    found.scatter = (squares / static_cast<double>(pressed - channels)).cwiseSqrt();
    const Eigen::MatrixXd half = svd.matrixV() * singular.cwiseInverse().asDiagonal();
    const Eigen::VectorXd spread = half.rowwise().norm().cwiseQuotient(size); // sqrt(diag((X'X)^-1))
    found.error = found.scatter * spread.transpose();
    return found;
}

} // namespace teleta::equilibration
