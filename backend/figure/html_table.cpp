// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/figure/html_table.h"

namespace teleta::figure {

HtmlTable::HtmlTable(const QString& caption, const QStringList& columns) {
    m_html = QStringLiteral("<div class=\"scroll\"><table>\n<caption>%1</caption>\n<thead><tr>")
                 .arg(caption.toHtmlEscaped());
    for (const QString& column : columns)
        m_html += QStringLiteral("<th scope=\"col\">%1</th>").arg(column.toHtmlEscaped());
    m_html += QStringLiteral("</tr></thead>\n<tbody>\n");
}

void HtmlTable::row(const QStringList& cells, int heads) {
    m_html += QStringLiteral("<tr>");
    for (int i = 0; i < cells.size(); ++i)
        m_html += (i < heads ? QStringLiteral("<th scope=\"row\">%1</th>") : QStringLiteral("<td>%1</td>"))
                      .arg(cells[i].toHtmlEscaped());
    m_html += QStringLiteral("</tr>\n");
}

} // namespace teleta::figure
