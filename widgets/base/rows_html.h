// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <utility>
#include <vector>

namespace teleta::base {

/// Names and their texts as the rows of an HTML table, both escaped. A row without a text is left out.
/// Thread: any (pure).
[[nodiscard]] inline QString rowsHtml(const std::vector<std::pair<QString, QString>>& rows) {
    QString html = QStringLiteral("<table cellspacing=\"0\" cellpadding=\"3\">");
    for (const auto& [name, text] : rows)
        if (!text.isEmpty())
            html += QStringLiteral("<tr><td width=\"130\">%1</td><td>%2</td></tr>")
                        .arg(name.toHtmlEscaped(), text.toHtmlEscaped());
    return html + QStringLiteral("</table>");
}

} // namespace teleta::base
