// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace teleta::figure {

/// A table of plain texts for htmlPage(). Thread: one.
class HtmlTable {
public:
    HtmlTable(const QString& caption, const QStringList& columns);

    /// The first `heads` cells name the row.
    void row(const QStringList& cells, int heads = 1);

    [[nodiscard]] QString html() const { return m_html + QStringLiteral("</tbody>\n</table></div>\n"); }

private:
    QString m_html;
};

} // namespace teleta::figure
