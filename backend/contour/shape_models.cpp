// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/contour/shape_models.h"

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

constexpr double kTurn_rad = 2.0 * std::numbers::pi;
constexpr double kWidestGapOfRegularPolygon = 0.25; ///< of the circle around it
constexpr std::size_t kEdgesTried = 10;
/// What a chain nearly always remains below its expectation; 0.3 to 0.7 times this is the logarithm of the
/// odds.
constexpr double kUsualShortfall = 8.0;

class Explainer {
public:
    Explainer(const PreparedContour& contour, std::optional<bool> closed)
        : m_points(contour.points)
        , m_ordered(mergedLaps(contour.points)) {
        m_result.closed = closed.value_or(returnsToItsStart(m_ordered));
        addLine();
        // Of three points everything but a line is as good as anything else.
        if (m_points.size() > 3) {
            addCircle();
            addPolygons();
        }
        addDepartures();
    }

    [[nodiscard]] Explanations take() { return std::move(m_result); }

private:
    Explanation& add(Model model, double logEvidence, RobustFit fit = {}, Evidence judged = {}) {
        return m_result.all.emplace_back(
            Explanation{model, logEvidence, std::move(fit), std::move(judged), {}, {}});
    }

    /// A named shape, or a part of it, and a curve that follows it only roughly.
    Explanation& addNamed(Model model, RobustFit fit, Explored way) {
        Evidence judged = evidence(fit, way.length);
        const double order = logEvidenceOfOrder(way.places, way.length, way.period);
        const double weight = judged.logEvidence + order;
        add(Model::roughly, logEvidenceOfDeparture(fit, way.places, way.length, way.period) + order, fit,
            judged);
        Explanation named{model, weight, fit, std::move(judged)};
        named.untouched = way.untouched;
        named.everyEdge = way.everyEdge;
        if (weight > m_bestWeight) {
            m_bestWeight = weight;
            m_bestOrder = order;
            m_bestFit = std::move(fit);
            m_bestWay = std::move(way);
        }
        return m_result.all.emplace_back(std::move(named));
    }

    void addLine() {
        CurvedLineFit line = fitLine(m_points);
        const Evidence judged = judge(line.fit.residuals, 1.0);
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
        addNamed(Model::line, std::move(line.fit), std::move(way)).vertices = {foot + low * along,
                                                                               foot + high * along};
    }

    void addCircle() {
        CurvedLineFit curved = fitCurvedLine(m_points);
        const CurvedLine& circle = curved.curve;
        if (circle.straight())
            return;
        const Evidence judged = judge(curved.fit.residuals, 1.0);
        std::vector<double> touched;
        Explored way;
        way.period = kTurn_rad * circle.radius();
        for (std::size_t i = 0; i < m_points.size(); ++i) {
            const Point p = m_points[i] - circle.centre();
            way.places.push_back(circle.radius() * (std::atan2(p.y(), p.x()) + std::numbers::pi));
            if (!judged.outliers[i])
                touched.push_back(way.places.back());
        }
        way.untouched = untouchedShare(std::move(touched), way.period);
        way.length = way.period * (1.0 - way.untouched);
        addNamed(Model::circle, std::move(curved.fit), way).circle = circle;
        addEllipse(circle);
        if (way.untouched <= kWidestGapOfRegularPolygon)
            for (const int sides : {5, 6}) {
                PolygonFit regular = fitRegularPolygon(m_points, sides, circle.centre(), circle.radius());
                const double order = logEvidenceOfOrder(way.places, way.period, way.period);
                const double weight = regular.judged.logEvidence + order;
                add(Model::regularPolygon, weight, std::move(regular.fit), std::move(regular.judged))
                    .vertices = toVertices(regular.vertices);
            }
    }

    void addEllipse(const CurvedLine& circle) {
        RobustFit ellipse = fitEllipse(m_points, circle);
        const double perimeter = ellipseLength(ellipse.parameters);
        const std::vector<double> places = placesOnEllipse(m_points, ellipse.parameters);
        const double length = perimeter * (1.0 - untouchedShare(places, perimeter));
        Evidence judged = evidence(ellipse, length);
        const double weight = judged.logEvidence + logEvidenceOfOrder(places, length, perimeter);
        add(Model::ellipse, weight, std::move(ellipse), std::move(judged));
    }

    void addPolygons() {
        std::vector<Eigen::VectorXd> triangles{largeTriangle(m_points)};
        std::vector<Eigen::VectorXd> quadrilaterals;
        const auto start = [&](const ChainFitter& closed) {
            if (closed.mostEdges() >= 3)
                triangles.push_back(closed.start(3));
            if (closed.mostEdges() >= 4)
                quadrilaterals.push_back(closed.start(4));
        };
        // Triangles and rectangles are convex, so the angle gives their order however they were explored.
        const std::vector<Point> byAngle = orderedByAngle(m_points);
        const ChainFitter chains(m_points, m_ordered, m_result.closed, kEdgesTried);
        std::optional<ChainFitter> convex;
        if (m_result.closed)
            start(chains);
        if (!m_result.closed || !isSameLap(byAngle, m_ordered))
            start(convex.emplace(m_points, byAngle, true, 4));

        RobustFit triangle = fitClosedChain(m_points, triangles);
        const Eigen::VectorXd vertices = triangle.parameters;
        addClosed(Model::triangle, std::move(triangle), vertices);
        PolygonFit rectangle = fitRectangle(m_points, quadrilaterals);
        addClosed(Model::rectangle, std::move(rectangle.fit), rectangle.vertices);

        const Rival rival{m_bestWeight - m_bestOrder + kUsualShortfall, m_bestWay.length};
        if (!m_result.closed)
            for (ChainFit& chain : convex->fitFrom(4, rival))
                addChain(std::move(chain));
        for (ChainFit& chain : chains.fitFrom(m_result.closed ? 4 : 2, rival))
            addChain(std::move(chain));
    }

    void addChain(ChainFit chain) {
        const double length = polylineLength(chain.fit.parameters, chain.closed);
        const std::vector<double> places = waysOnPolyline(m_points, chain.fit.parameters, chain.closed);
        const double order = logEvidenceOfOrder(places, length, chain.closed ? length : 0.0);
        const double weight = chain.evidence.logEvidence + order;
        Explanation& other = add(Model::chain, weight, std::move(chain.fit), std::move(chain.evidence));
        other.vertices = toVertices(other.fit.parameters);
    }

    void addClosed(Model model, RobustFit fit, const Eigen::VectorXd& vertices) {
        Explored way = explored(m_points, judge(fit.residuals, polylineLength(vertices, true)), vertices);
        std::vector<Point> corners = toVertices(vertices);
        const Point a = corners[1] - corners[0];
        const Point b = corners[2] - corners[1];
        if (cross(a, b) < 0.0)
            std::reverse(corners.begin(), corners.end());
        addNamed(model, std::move(fit), std::move(way)).vertices = std::move(corners);
    }

    void addDepartures() {
        add(Model::scatter, logEvidenceOfScatter(m_points));
        if (m_bestWeight == kImpossibleEvidence)
            return;
        const double walk =
            logEvidenceOfWalk(m_points, m_bestFit, m_bestWay.places, m_bestWay.length, m_bestWay.period);
        add(Model::walk, m_bestOrder + walk);
    }

    std::vector<Point> m_points;
    std::vector<Point> m_ordered; ///< one lap
    Explanations m_result;
    double m_bestWeight = kImpossibleEvidence; ///< of the named shapes
    double m_bestOrder = 0.0;
    RobustFit m_bestFit;
    Explored m_bestWay;
};

} // namespace

Explanations explain(const PreparedContour& contour, std::optional<bool> closed) {
    return Explainer(contour, closed).take();
}

} // namespace teleta::contour
