// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/shape_recogniser.h"

#include "backend/contour/contour_order.h"
#include "backend/contour/curve_models.h"
#include "backend/contour/model_evidence.h"
#include "backend/contour/polygon.h"
#include "backend/contour/polygon_models.h"
#include "backend/contour/polyline_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace teleta::contour {

namespace {

constexpr double kPointSharpness = 8.0;
constexpr double kConfidenceOfTwoPoints = 0.5;
constexpr double kPi = std::numbers::pi;
constexpr double kWidestGapOfCircle_rad = 0.25 * kPi;
constexpr double kWidestGapOfPolygon = 0.25; ///< of the perimeter
constexpr std::size_t kEdgesTried = 10;
constexpr double kOtherShare = 0.25; ///< prior of a model that is not named, relative to a named shape
constexpr double kRoughShare = 0.02; ///< the same of a curve that follows the best named shape only roughly
constexpr double kRoughness = 0.8;   ///< correlation of its neighbouring deviations

constexpr std::size_t kLineParameters = 2;
constexpr std::size_t kCircleParameters = 3;
constexpr std::size_t kRegularParameters = 4;
constexpr std::size_t kEllipseParameters = 5;
constexpr std::size_t kRectangleParameters = 5;
constexpr std::size_t kTriangleParameters = 6;

/// One explanation of a contour.
struct ShapeCandidate {
    Shape shape = Shape::unknown;
    double logWeight = 0.0; ///< log evidence plus log prior
    RobustFit fit;
    Evidence judged;
    std::vector<Point> vertices; ///< in units of the size, of shapes that have vertices
    std::optional<CurvedLine> circle;
};

/// All explanations listed in shape_recogniser.h except the point; at least one (scatter).
struct ShapeCandidates {
    std::vector<ShapeCandidate> all;
    bool closed = false; ///< the contour returns to its start, as given or as detected
};

/// Fits every explanation to a contour of at least two different points. closed: empty to detect it.
class Explainer {
public:
    Explainer(const PreparedContour& contour, std::optional<bool> closed)
        : m_points(contour.points)
        , m_ordered(mergedLaps(contour.points)) {
        m_result.closed = closed.value_or(returnsToItsStart(m_ordered));
        addLine();
        addCircle();
        addPolygons();
        addDepartures();
        const double scatter = logEvidenceOfScatter(m_points.size());
        addOther(scatter, {}, {});
    }

    [[nodiscard]] ShapeCandidates take() { return std::move(m_result); }

private:
    /// A model with as many parameters as points always fits and is no evidence.
    [[nodiscard]] bool testable(std::size_t parameters) const { return m_points.size() > parameters; }

    ShapeCandidate& addNamed(Shape shape, RobustFit fit, Explored way) {
        Evidence judged = evidence(fit, way.length);
        const double weight = judged.logEvidence;
        if (weight > m_bestWeight) {
            m_bestWeight = weight;
            m_bestFit = fit;
            m_bestWay = std::move(way);
        }
        return m_result.all.emplace_back(
            ShapeCandidate{shape, weight, std::move(fit), std::move(judged), {}, {}});
    }

    ShapeCandidate& addOther(double logEvidence, RobustFit fit, Evidence judged, double share = kOtherShare) {
        return m_result.all.emplace_back(ShapeCandidate{
            Shape::unknown, logEvidence + std::log(share), std::move(fit), std::move(judged), {}, {}});
    }

    void addLine() {
        if (!testable(kLineParameters))
            return;
        CurvedLineFit line = fitLine(m_points);
        const Evidence judged = evidence(line.fit, 1.0);
        const Point along(-std::sin(line.curve.theta_rad), std::cos(line.curve.theta_rad));
        Explored way;
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (std::size_t i = 0; i < m_points.size(); ++i) {
            way.places.push_back(along.dot(m_points[i] - line.curve.reference));
            if (!judged.outliers[i]) {
                low = std::min(low, way.places.back());
                high = std::max(high, way.places.back());
            }
        }
        if (low >= high)
            return;
        way.length = high - low;
        const Point foot = line.curve.foot(line.curve.reference);
        addNamed(Shape::line, std::move(line.fit), std::move(way)).vertices = {foot + low * along,
                                                                               foot + high * along};
    }

    void addCircle() {
        if (!testable(kCircleParameters))
            return;
        CurvedLineFit curved = fitCurvedLine(m_points);
        const CurvedLine& circle = curved.curve;
        if (circle.straight())
            return;
        const Evidence judged = evidence(curved.fit, 1.0);
        std::vector<double> angles_rad;
        Explored way;
        way.period = 2.0 * kPi * circle.radius();
        for (std::size_t i = 0; i < m_points.size(); ++i) {
            const Point p = m_points[i] - circle.centre();
            const double angle_rad = std::atan2(p.y(), p.x()) + kPi;
            way.places.push_back(circle.radius() * angle_rad);
            if (!judged.outliers[i])
                angles_rad.push_back(angle_rad);
        }
        const double gap_rad = gapBeyondSpacing(std::move(angles_rad), 2.0 * kPi);
        way.length = circle.radius() * (2.0 * kPi - std::max(0.0, gap_rad));
        const bool whole = gap_rad <= kWidestGapOfCircle_rad;
        addNamed(whole ? Shape::circle : Shape::arc, std::move(curved.fit), std::move(way)).circle = circle;

        if (testable(kEllipseParameters)) {
            RobustFit ellipse = fitEllipse(m_points, circle);
            Evidence other = evidence(ellipse, ellipseLength(ellipse.parameters));
            addOther(other.logEvidence, std::move(ellipse), std::move(other));
        }
        if (whole && testable(kRegularParameters))
            for (const int sides : {5, 6}) {
                PolygonFit regular = fitRegularPolygon(m_points, sides, circle.centre(), circle.radius());
                addOther(regular.judged.logEvidence, std::move(regular.fit), std::move(regular.judged))
                    .vertices = toVertices(regular.vertices);
            }
    }

    void addPolygons() {
        // Triangles and rectangles are convex, so the angle gives their order however they were explored.
        std::vector<ChainFit> triangles;
        std::vector<Eigen::VectorXd> quadrilaterals;
        const auto sort = [&](std::vector<ChainFit> chains, bool alsoOthers) {
            for (ChainFit& chain : chains) {
                if (chain.closed && chain.edges == 3) {
                    triangles.push_back(std::move(chain));
                    continue;
                }
                if (chain.closed && chain.edges == 4)
                    quadrilaterals.push_back(chain.fit.parameters);
                if (!alsoOthers || chain.edges == 1 || !testable(2 * chain.edges))
                    continue;
                ShapeCandidate& other =
                    addOther(chain.evidence.logEvidence, std::move(chain.fit), std::move(chain.evidence));
                other.vertices = toVertices(other.fit.parameters);
            }
        };
        sort(fitChains(orderedByAngle(m_points), true, 4), !m_result.closed);
        sort(fitChains(m_ordered, m_result.closed, kEdgesTried), true);
        triangles.push_back(fitClosedChain(m_points, largeTriangle(m_points)));

        if (testable(kTriangleParameters)) {
            const auto best = std::ranges::max_element(
                triangles, {}, [](const ChainFit& chain) { return chain.evidence.logEvidence; });
            RobustFit fit;
            fit.parameters = best->fit.parameters;
            polylineResiduals(m_points, fit.parameters, true, fit.residuals, fit.jacobian);
            const Eigen::VectorXd vertices = fit.parameters;
            addClosed(Shape::triangle, std::move(fit), vertices);
        }
        if (testable(kRectangleParameters)) {
            PolygonFit rectangle = fitRectangle(m_points, quadrilaterals);
            addClosed(Shape::rectangle, std::move(rectangle.fit), rectangle.vertices);
        }
    }

    void addClosed(Shape shape, RobustFit fit, const Eigen::VectorXd& vertices) {
        Explored way = explored(m_points, evidence(fit, polylineLength(vertices, true)), vertices);
        if (!way.everyEdge || way.gap > kWidestGapOfPolygon * way.period)
            return;
        std::vector<Point> corners = toVertices(vertices);
        const Point a = corners[1] - corners[0];
        const Point b = corners[2] - corners[1];
        if (cross(a, b) < 0.0)
            std::reverse(corners.begin(), corners.end());
        addNamed(shape, std::move(fit), std::move(way)).vertices = std::move(corners);
    }

    /// Explanations that only resemble the best named shape: a curve that follows it roughly, and a random
    /// walk.
    void addDepartures() {
        if (m_bestWeight == kImpossibleEvidence)
            return;
        Evidence rough = evidence(m_bestFit, m_bestWay.length, {.correlation = kRoughness});
        addOther(rough.logEvidence, m_bestFit, rough, kRoughShare);
        const double walk =
            logEvidenceOfWalk(m_points, m_bestFit, m_bestWay.places, m_bestWay.length, m_bestWay.period);
        addOther(walk, {}, {});
    }

    std::vector<Point> m_points;
    std::vector<Point> m_ordered; ///< one lap
    ShapeCandidates m_result;
    double m_bestWeight = kImpossibleEvidence; ///< of the named shapes
    RobustFit m_bestFit;
    Explored m_bestWay;
};

std::size_t index(Shape shape) {
    return static_cast<std::size_t>(shape);
}

/// Probability that a contour of this extent is a point.
double pointProbability(double extent_m, double resolution_m) {
    if (extent_m == 0.0)
        return 1.0;
    if (!(resolution_m > 0.0))
        return 0.0;
    const double ratio = std::min(extent_m / resolution_m, 1e6);
    return 1.0 / (1.0 + std::pow(ratio, kPointSharpness));
}

} // namespace

const char* toString(Shape shape) {
    static constexpr const char* kNames[kShapes] = {"circle", "rectangle", "triangle", "arc",
                                                    "line",   "point",     "unknown"};
    return kNames[index(shape)];
}

std::optional<Recognition> recogniseShape(std::span<const Point> points_m,
                                          const RecognitionSettings& settings) {
    if (!areUsable(points_m))
        return std::nullopt;
    Recognition result;
    result.closed = settings.closed.value_or(false);
    if (points_m.empty())
        return result;

    const PreparedContour contour = prepare(points_m);
    result.outliers = contour.rejected;
    const double point = pointProbability(contour.extent_m, settings.resolution_m);
    result.probability[index(Shape::point)] = point;
    const auto decide = [&](Shape shape) {
        result.shape = shape;
        result.confidence = result.probability[index(shape)];
    };
    if (contour.extent_m == 0.0 || contour.extent_m < settings.resolution_m) {
        result.probability[index(Shape::unknown)] = 1.0 - point;
        decide(Shape::point);
        return result;
    }
    if (contour.points.size() == 2) {
        result.probability[index(Shape::line)] = kConfidenceOfTwoPoints * (1.0 - point);
        result.probability[index(Shape::unknown)] = (1.0 - kConfidenceOfTwoPoints) * (1.0 - point);
        decide(Shape::line);
        for (const Point& p : contour.points)
            result.vertices_m.push_back(contour.toMetres(p));
        return result;
    }

    const ShapeCandidates candidates = Explainer(contour, settings.closed).take();
    std::array<double, kShapes> logWeights;
    logWeights.fill(-std::numeric_limits<double>::infinity());
    double total = -std::numeric_limits<double>::infinity();
    for (const ShapeCandidate& c : candidates.all) {
        logWeights[index(c.shape)] = logSum(logWeights[index(c.shape)], c.logWeight);
        total = logSum(total, c.logWeight);
    }
    for (std::size_t i = 0; i < kShapes; ++i)
        result.probability[i] += (1.0 - point) * std::exp(logWeights[i] - total);
    decide(static_cast<Shape>(std::max_element(logWeights.begin(), logWeights.end()) - logWeights.begin()));

    const ShapeCandidate* best = nullptr;
    for (const ShapeCandidate& c : candidates.all)
        if (c.shape == result.shape && (best == nullptr || c.logWeight > best->logWeight))
            best = &c;
    result.outliers += best->judged.outlierCount();
    result.rms_m = contour.size_m * rmsOfInliers(best->fit, best->judged);
    for (const Point& p : best->vertices)
        result.vertices_m.push_back(contour.toMetres(p));
    if (best->circle)
        result.circle = Circle{contour.toMetres(best->circle->centre()),
                               contour.size_m * best->circle->radius(), result.rms_m};
    if (!settings.closed) {
        const bool named = result.shape != Shape::unknown;
        const bool ends = result.shape == Shape::arc || result.shape == Shape::line;
        result.closed = named ? !ends : candidates.closed;
    }
    return result;
}

} // namespace teleta::contour
