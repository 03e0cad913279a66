// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/contour/point.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace teleta::contour {

/// A model after fitting. At most kMostParameters parameters. jacobian: of the residuals, points x
/// parameters.
struct RobustFit {
    Eigen::VectorXd parameters;
    Eigen::VectorXd residuals;
    Eigen::MatrixXd jacobian;
    double scale = 0.0; ///< of the biweight, in units of the size
};

/// Most parameters of a model: two coordinates of each vertex of the longest chain of edges.
inline constexpr int kMostParameters = 34;
using NormalMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostParameters, kMostParameters>;

/// J^T W J, of a Jacobian with at most kMostParameters columns and a weight of each point. Thread: any
/// (pure).
[[nodiscard]] NormalMatrix normalMatrix(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& weights);

/// Points as columns, filled up with copies of the first to a multiple of kLanes, so that several can be
/// computed at once.
struct PointColumns {
    explicit PointColumns(std::span<const Point> points);

    std::size_t count; ///< of the points
    std::vector<double> x;
    std::vector<double> y;
    [[nodiscard]] std::size_t filled() const { return x.size(); }
};

/// The equations of a step: the upper half of J^T W J and J^T W r.
struct StepEquations {
    int count = 0;                                                ///< of the parameters
    std::array<int, kMostParameters> first{};                     ///< first row of a column that is not zero
    std::array<double, kMostParameters * kMostParameters> normal; ///< (column, row <= column)
    std::array<double, kMostParameters> gradient;

    [[nodiscard]] double& at(int row, int column) {
        return normal[static_cast<std::size_t>(column * kMostParameters + row)];
    }
    [[nodiscard]] double at(int row, int column) const {
        return normal[static_cast<std::size_t>(column * kMostParameters + row)];
    }
};

/// What fitRobustly() fits: a curve whose distance from each point depends on parameters. Residuals and
/// derivatives are columns of PointColumns::filled() numbers; what stands beyond the points has no weight.
class RobustModel {
public:
    using Parameters = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostParameters, 1>;
    /// The model at some parameters. derivatives: as the model likes.
    struct At {
        Parameters parameters;
        std::vector<double> residuals;
        std::vector<double> derivatives;
    };

    virtual ~RobustModel() = default;
    [[nodiscard]] virtual const PointColumns& points() const = 0;
    /// Fills residuals and derivatives; resizes both where needed.
    virtual void evaluate(At& at) const = 0;
    /// Normal matrix by these weights; gradient by weightedResiduals, which are weights times residuals.
    virtual void equations(const At& at, const double* weights, const double* weightedResiduals,
                           StepEquations& equations) const = 0;
    [[nodiscard]] virtual Eigen::MatrixXd jacobian(const At& at) const = 0;
};

/// A model whose derivatives are a column for each of its few parameters.
template <int P>
class ColumnModel : public RobustModel {
public:
    explicit ColumnModel(const PointColumns& points)
        : m_points(points) {}
    [[nodiscard]] const PointColumns& points() const final { return m_points; }
    void equations(const At& at, const double* weights, const double* weightedResiduals,
                   StepEquations& equations) const final;
    [[nodiscard]] Eigen::MatrixXd jacobian(const At& at) const final;

protected:
    /// Where evaluate() writes to.
    [[nodiscard]] std::array<double*, P> columns(At& at) const;

private:
    const PointColumns& m_points;
};
extern template class ColumnModel<2>;
extern template class ColumnModel<3>;
extern template class ColumnModel<4>;
extern template class ColumnModel<5>;

/// Fits a model to points that contain outliers: Levenberg-Marquardt on Tukey's biweight of the residuals.
/// The scale is first a quarter of the size, so that any sensible start converges, then 4.685 times the
/// robust standard deviation (1.4826 MAD, corrected for the number of parameters), but never less than a
/// hundredth of the size. It ends when a step lowers the loss by less than a ten-thousandth. Thread: any
/// (pure).
[[nodiscard]] RobustFit fitRobustly(const RobustModel& model, const RobustModel::Parameters& start);

/// The same in two parts, for several starts: nearly as far, then for the best the rest of the way.
[[nodiscard]] RobustFit fitRoughly(const RobustModel& model, const RobustModel::Parameters& start);
[[nodiscard]] RobustFit refined(const RobustModel& model, const RobustFit& fit);

/// Goes on from a fit as far as the loss falls: points without noise are met to rounding error, whatever
/// their outliers. Thread: any (pure).
[[nodiscard]] RobustFit polished(const RobustModel& model, const RobustFit& fit);

/// Scale of robustLoss() for comparing starts.
inline constexpr double kStartScale = 0.1;

/// Mean biweight loss, from 0 (all residuals zero) to 1 (all beyond the scale); for comparing starts before
/// they are fitted.
[[nodiscard]] double robustLoss(std::span<const double> residuals, double scale);
[[nodiscard]] double robustLoss(const RobustFit& fit);
/// The same of the points of a model, by kStartScale.
[[nodiscard]] double lossOfStart(const RobustModel& model, const RobustModel::Parameters& start);

} // namespace teleta::contour
