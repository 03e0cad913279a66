// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/report_html.h"

namespace teleta::study::report_html {

QString text(const std::string& value) {
    return QString::fromStdString(value);
}

QString fixed(const std::optional<double>& value, int digits) {
    return value ? QString::number(*value, 'f', digits) : QStringLiteral("NA");
}

QString percent(const std::optional<double>& share) {
    return share ? QString::number(100.0 * *share, 'f', 1) : QStringLiteral("NA");
}

QString interval(const std::optional<Interval>& ends, double scale, int digits) {
    if (!ends)
        return QStringLiteral("NA");
    return QStringLiteral("%1 – %2")
        .arg(scale * ends->low, 0, 'f', digits)
        .arg(scale * ends->high, 0, 'f', digits);
}

QString probability(const std::optional<double>& p) {
    if (!p)
        return QStringLiteral("NA");
    return *p < 0.0001 ? QStringLiteral("< 0.0001") : QString::number(*p, 'f', 4);
}

QString heading(const QString& title) {
    return QStringLiteral("<h3>%1</h3>\n").arg(title.toHtmlEscaped());
}

QString paragraph(const QString& content) {
    return QStringLiteral("<p>%1</p>\n").arg(content.toHtmlEscaped());
}

QString figure(const figure::SvgCanvas& picture, const QString& caption) {
    return QStringLiteral("<figure>\n%1<figcaption>%2</figcaption>\n</figure>\n")
        .arg(QString::fromStdString(picture.embedded()), caption);
}

} // namespace teleta::study::report_html
