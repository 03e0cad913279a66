// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/column_reader.h"
#include "app/cli/base/command_io.h"
#include "app/cli/base/options.h"
#include "app/cli/commands/tactile/tactile_commands.h"
#include "backend/contour/cubic_spline.h"
#include "backend/contour/shape_recogniser.h"
#include "backend/core/data/csv_writer.h"

#include <QCoreApplication>
#include <QStringList>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <unistd.h>
#include <utility>
#include <vector>

namespace teleta::cli {

namespace {

using contour::CubicSpline;
using contour::Point;
using contour::Recognition;
using contour::Shape;
using contour::SplineKind;

struct ContourText {
    Q_DECLARE_TR_FUNCTIONS(ContourCommand)
};

/// Parameter of sample i of n, from one end of the curve to the other.
double parameter(const CubicSpline& spline, int sample, int samples) {
    return static_cast<double>(spline.segments()) * sample / (samples - 1);
}

double largestCurvature_perM(const CubicSpline& spline, int samples) {
    double largest_perM = 0.0;
    for (int i = 0; i < samples; ++i)
        largest_perM = std::max(largest_perM, std::abs(spline.curvature_perM(parameter(spline, i, samples))));
    return largest_perM;
}

QString shapeName(Shape shape) {
    switch (shape) {
    case Shape::circle:
        return ContourText::tr("circle");
    case Shape::rectangle:
        return ContourText::tr("rectangle");
    case Shape::triangle:
        return ContourText::tr("triangle");
    case Shape::arc:
        return ContourText::tr("arc");
    case Shape::line:
        return ContourText::tr("line");
    case Shape::point:
        return ContourText::tr("point");
    case Shape::unknown:
        return ContourText::tr("unknown");
    }
    return {};
}

/// "rectangle 0.55, circle 0.4"; a single one where the points decide.
QString candidateNames(const Recognition& seen) {
    QStringList names;
    for (const Shape shape : seen.candidates())
        names << QStringLiteral("%1 %2").arg(shapeName(shape),
                                             forPeople(seen.probability[static_cast<std::size_t>(shape)], 2));
    return names.join(QStringLiteral(", "));
}

nlohmann::ordered_json toJson(std::size_t points, const Recognition& seen, double length_m,
                              double curvature_perM) {
    nlohmann::ordered_json vertices = nlohmann::ordered_json::array();
    for (const Point& p : seen.vertices_m)
        vertices.push_back(nlohmann::ordered_json::array({p.x(), p.y()}));
    nlohmann::ordered_json probabilities = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < contour::kShapes; ++i)
        probabilities[contour::toString(static_cast<Shape>(i))] = seen.probability[i];
    nlohmann::ordered_json candidates = nlohmann::ordered_json::array();
    for (const Shape shape : seen.candidates())
        candidates.push_back(contour::toString(shape));
    nlohmann::ordered_json circle = nullptr;
    if (seen.circle)
        circle = {{"x", seen.circle->centre_m.x()},
                  {"y", seen.circle->centre_m.y()},
                  {"radius", seen.circle->radius_m},
                  {"rms", seen.circle->rms_m}};
    return {{"points", points},
            {"shape", contour::toString(seen.shape)},
            {"confidence", seen.confidence},
            {"candidates", std::move(candidates)},
            {"probabilities", std::move(probabilities)},
            {"closed", seen.closed},
            {"length_m", length_m},
            {"vertices", std::move(vertices)},
            {"circle", std::move(circle)},
            {"max_curvature_per_m", curvature_perM}};
}

core::Expected<void> printTable(std::size_t points, const Recognition& seen, double length_m,
                                double curvature_perM) {
    Fields fields{
        {ContourText::tr("Points"), QString::number(points)},
        {ContourText::tr("Shape"),
         ContourText::tr("%1 (confidence %2)").arg(shapeName(seen.shape), forPeople(seen.confidence, 3))},
        {ContourText::tr("Candidates"), candidateNames(seen)},
        {ContourText::tr("Closed"), seen.closed ? ContourText::tr("yes") : ContourText::tr("no")},
        {ContourText::tr("Length"), ContourText::tr("%1 m").arg(forPeople(length_m))},
        {ContourText::tr("Largest curvature"), ContourText::tr("%1 1/m").arg(forPeople(curvature_perM))}};
    if (seen.circle) {
        fields.emplace_back(ContourText::tr("Centre"), ContourText::tr("%1, %2 m")
                                                           .arg(forPeople(seen.circle->centre_m.x()),
                                                                forPeople(seen.circle->centre_m.y())));
        fields.emplace_back(ContourText::tr("Radius"),
                            ContourText::tr("%1 m (points off by %2 m)")
                                .arg(forPeople(seen.circle->radius_m), forPeople(seen.circle->rms_m)));
    }
    for (std::size_t i = 0; i < seen.vertices_m.size(); ++i)
        fields.emplace_back(ContourText::tr("Vertex %1").arg(i + 1),
                            ContourText::tr("%1, %2 m")
                                .arg(forPeople(seen.vertices_m[i].x()), forPeople(seen.vertices_m[i].y())));
    return printFields(fields);
}

class ContourCommand {
public:
    void declare(CLI::App& app) {
        addOption(app, "points", m_pointsPath,
                  ContourText::tr("CSV with the columns x_m,y_m, in the order of touch"), "POINTS.csv")
            ->required();
        addChoice(app, "--spline", m_spline,
                  ContourText::tr("approximating: the points are the control points; interpolating: the "
                                  "curve passes through them"),
                  {"approximating", "interpolating"})
            ->capture_default_str();
        addFlag(app, "--closed", m_closed,
                ContourText::tr("The contour is closed; otherwise the program decides"));
        addOption(app, "--samples", m_samples,
                  ContourText::tr("Points of the curve, for the CSV and the largest curvature"),
                  between(2, 1e7), "N");
        addOption(app, "--resolution-m", m_resolution_m,
                  ContourText::tr("A contour smaller than this is a point, m"), positive(), "M");
        addOption(app, "--curve", m_curvePath,
                  ContourText::tr("Write the curve as CSV t,x_m,y_m,curvature_per_m, t from 0 to 1"),
                  "OUT.csv");
        declareJson(app, m_json);
    }

    [[nodiscard]] core::Expected<void> run() {
        TELETA_TRY(const std::vector<Point> points, readPoints());

        contour::RecognitionSettings settings;
        settings.resolution_m = m_resolution_m;
        if (m_closed)
            settings.closed = true;
        const std::optional<Recognition> seen = contour::recogniseShape(points, settings);
        std::optional<CubicSpline> spline;
        if (seen)
            spline = CubicSpline::fit(
                points, m_spline == "interpolating" ? SplineKind::interpolating : SplineKind::approximating,
                seen->closed);
        if (!spline) {
            core::Error error;
            error.where.file = m_pointsPath;
            error.message = points.empty()
                                ? ContourText::tr("the file has no points").toStdString()
                                : ContourText::tr("a coordinate is too large to compute with").toStdString();
            error.expected = ContourText::tr("a row for each contact point, in metres").toStdString();
            return core::Unexpected(error);
        }
        if (!m_curvePath.empty()) {
            TELETA_CHECK(writeCurve(*spline));
        }
        const double length_m = spline->length_m();
        const double curvature_perM = largestCurvature_perM(*spline, m_samples);
        return m_json ? printDocument(toJson(points.size(), *seen, length_m, curvature_perM))
                      : printTable(points.size(), *seen, length_m, curvature_perM);
    }

private:
    [[nodiscard]] core::Expected<std::vector<Point>> readPoints() const {
        constexpr std::array<std::string_view, 2> kNames{"x_m", "y_m"};
        TELETA_TRY(ColumnReader reader, ColumnReader::open(m_pointsPath, kNames));
        std::vector<Point> points;
        TELETA_CHECK(reader.forEachRow(isatty(STDOUT_FILENO) != 0, [&](std::span<const double> row) {
            points.emplace_back(row[0], row[1]);
            return true;
        }));
        return points;
    }

    [[nodiscard]] core::Expected<void> writeCurve(const CubicSpline& spline) const {
        constexpr std::array<std::string_view, 4> kColumns{"t", "x_m", "y_m", "curvature_per_m"};
        TELETA_TRY(core::CsvWriter csv, core::CsvWriter::create(m_curvePath, kColumns));
        for (int i = 0; i < m_samples && !csv.failed(); ++i) {
            const double t = parameter(spline, i, m_samples);
            const Point p = spline.position_m(t);
            csv.number(static_cast<double>(i) / (m_samples - 1));
            csv.number(p.x());
            csv.number(p.y());
            csv.number(spline.curvature_perM(t));
            csv.endRow();
        }
        return csv.finish();
    }

    std::string m_pointsPath;
    std::string m_spline = "approximating";
    std::string m_curvePath;
    double m_resolution_m = contour::RecognitionSettings{}.resolution_m;
    int m_samples = 200;
    bool m_closed = false;
    bool m_json = false;
};

} // namespace

Command contourCommand() {
    return makeCommand<ContourCommand>(
        "contour", ContourText::tr("Shape, vertices and spline of a series of contact points"),
        "teleta simulate teleta-contour-circle --out run\n"
        "  teleta contour run/contour.csv --closed --curve curve.csv");
}

} // namespace teleta::cli
