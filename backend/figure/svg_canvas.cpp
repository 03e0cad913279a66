// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/figure/svg_canvas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::figure {

QString svgNumber(double value) {
    return QString::number(std::round(value * 100.0) / 100.0, 'g', 8);
}

SvgCanvas::SvgCanvas(double width, double height, const QString& title)
    : m_width(width)
    , m_height(height)
    , m_title(title) {
}

void SvgCanvas::text(double x, double y, const QString& content, const QString& classes,
                     const QString& attributes) {
    m_body +=
        QStringLiteral("<text x=\"%1\" y=\"%2\" class=\"%3\"%4>%5</text>\n")
            .arg(svgNumber(x), svgNumber(y), classes,
                 attributes.isEmpty() ? QString() : QLatin1Char(' ') + attributes, content.toHtmlEscaped());
}

void SvgCanvas::line(double x1, double y1, double x2, double y2, const QString& classes) {
    m_body += QStringLiteral("<line x1=\"%1\" y1=\"%2\" x2=\"%3\" y2=\"%4\" class=\"%5\"/>\n")
                  .arg(svgNumber(x1), svgNumber(y1), svgNumber(x2), svgNumber(y2), classes);
}

void SvgCanvas::rectangle(double x, double y, double width, double height, const QString& attributes) {
    m_body += QStringLiteral("<rect x=\"%1\" y=\"%2\" width=\"%3\" height=\"%4\" %5/>\n")
                  .arg(svgNumber(x), svgNumber(y), svgNumber(width), svgNumber(height), attributes);
}

void SvgCanvas::circle(double x, double y, double radius, const QString& attributes) {
    m_body += QStringLiteral("<circle cx=\"%1\" cy=\"%2\" r=\"%3\" %4/>\n")
                  .arg(svgNumber(x), svgNumber(y), svgNumber(radius), attributes);
}

void SvgCanvas::diamond(double x, double y, double radius, const QString& attributes) {
    m_body += QStringLiteral("<path d=\"M%1 %2L%3 %4L%1 %5L%6 %4Z\" %7/>\n")
                  .arg(svgNumber(x), svgNumber(y - radius), svgNumber(x + radius), svgNumber(y),
                       svgNumber(y + radius), svgNumber(x - radius), attributes);
}

void SvgCanvas::path(const std::vector<std::pair<double, double>>& points, const QString& attributes) {
    if (points.empty())
        return;
    QString way;
    for (const auto& [x, y] : points)
        way += (way.isEmpty() ? u'M' : u'L') + svgNumber(x) + u' ' + svgNumber(y);
    m_body += QStringLiteral("<path d=\"%1\" %2/>\n").arg(way, attributes);
}

void SvgCanvas::watermark(const QString& word) {
    if (word.isEmpty())
        return;
    // As wide as four fifths of the diagonal; a capital letter is about 0.72 as wide as its font is high.
    const double size = 0.8 * std::hypot(m_width, m_height) / (0.72 * static_cast<double>(word.size()));
    const double angle_deg = -std::atan2(m_height, m_width) * 180.0 / std::numbers::pi;
    text(m_width / 2.0, m_height / 2.0, word, QStringLiteral("ink middle bold"),
         QStringLiteral("font-size=\"%1\" fill-opacity=\"0.06\" dominant-baseline=\"middle\" "
                        "transform=\"rotate(%2 %3 %4)\"")
             .arg(svgNumber(std::min(size, 0.5 * m_height)), svgNumber(angle_deg), svgNumber(m_width / 2.0),
                  svgNumber(m_height / 2.0)));
}

QString SvgCanvas::style(const SvgColours& colours) {
    QString style =
        QStringLiteral(".middle{text-anchor:middle}.end{text-anchor:end}.bold{font-weight:bold}"
                       ".small{font-size:12px}text.ink{fill:%1}text.soft{fill:%2}"
                       "line.ink{stroke:%1;stroke-width:1}line.soft{stroke:%3;stroke-width:1}"
                       "line.dashed{stroke:%2;stroke-width:1.5;stroke-dasharray:6 4}"
                       "path.dashed{fill:none;stroke:%2;stroke-width:1.2;stroke-dasharray:6 4}"
                       "path.dotted{fill:none;stroke:%1;stroke-width:1.2;stroke-dasharray:2 3}"
                       "line.bar{stroke-width:2}.faint{fill-opacity:0.35}.hollow{fill:none;stroke-width:2}"
                       ".thin{stroke-width:1.4}")
            .arg(colours.ink, colours.soft, colours.grid);
    for (std::size_t i = 0; i < kSeries; ++i)
        style += QStringLiteral("line.series%1,.hollow.series%1{stroke:%2}.series%1{fill:%2}"
                                ".hollow.series%1{fill:none}")
                     .arg(QString::number(i), colours.series[i]);
    return style;
}

QString SvgCanvas::head() const {
    return QStringLiteral("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%1\" height=\"%2\" "
                          "viewBox=\"0 0 %1 %2\" font-family=\"sans-serif\" font-size=\"14\" role=\"img\">\n"
                          "<title>%3</title>\n")
        .arg(svgNumber(m_width), svgNumber(m_height), m_title.toHtmlEscaped());
}

std::string SvgCanvas::standalone(const SvgColours& colours) const {
    const QString paper =
        QStringLiteral("<style>%1</style>\n<rect width=\"%2\" height=\"%3\" fill=\"%4\"/>\n")
            .arg(style(colours), svgNumber(m_width), svgNumber(m_height), colours.paper);
    return (head() + paper + m_body + QStringLiteral("</svg>\n")).toStdString();
}

std::string SvgCanvas::embedded() const {
    return (head() + m_body + QStringLiteral("</svg>\n")).toStdString();
}

} // namespace teleta::figure
