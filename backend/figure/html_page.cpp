// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/figure/html_page.h"

#include "backend/figure/svg_canvas.h"

namespace teleta::figure {

namespace {

/// Colours of the page and, where the screen is dark, those of the pictures in it.
QString pageStyle() {
    return QStringLiteral(
               ":root{color-scheme:light dark;--ink:#1b1b1f;--soft:#5c5f66;--grid:#d4d6da;--paper:#fff;"
               "--warn:#fff4d6}"
               "body{font:16px/1.5 system-ui,sans-serif;color:var(--ink);background:var(--paper);"
               "max-width:72rem;margin:0 auto;padding:1rem 2rem}"
               "h1,h2{line-height:1.2}h2{margin-top:3rem;border-bottom:2px solid var(--grid)}"
               "table{border-collapse:collapse;font-variant-numeric:tabular-nums;margin:1rem 0}"
               "caption{text-align:left;color:var(--soft);padding-bottom:.4rem}"
               "th,td{padding:.25rem .7rem;border-bottom:1px solid var(--grid);text-align:right}"
               "td{white-space:nowrap}th[scope=row],thead "
               "th:first-child{text-align:left}.scroll{overflow-x:auto}"
               ".beside{display:flex;flex-wrap:wrap;gap:0 2rem}figure{margin:1.5rem 0}figure "
               "svg{max-width:100%;height:auto}"
               "figcaption{max-width:36rem;color:var(--soft)}.warning,.mode{background:var(--warn);padding:."
               "6rem 1rem;"
               "border-left:4px solid #d08700}.mode{font-weight:bold}"
               "@media (prefers-color-scheme:dark){:root{--ink:#e8e8ea;--soft:#a9adb5;--grid:#3a3d43;"
               "--paper:#17181b;--warn:#3a2f12}}"
               "@media print{:root{--ink:#000;--soft:#444;--grid:#bbb;--paper:#fff;--warn:#eee}"
               "body{max-width:none;padding:0;font-size:11px}figure,table{break-inside:avoid}}") +
           SvgCanvas::style() +
           QStringLiteral("text.ink{fill:var(--ink)}text.soft{fill:var(--soft)}line.ink{stroke:var(--ink)}"
                          "line.soft{stroke:var(--grid)}line.dashed{stroke:var(--soft)}");
}

} // namespace

QString htmlPage(const QString& language, const QString& title, const QString& body) {
    return QStringLiteral(
               "<!DOCTYPE html>\n<html lang=\"%1\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n"
               "<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" "
               "content=\"width=device-width, initial-scale=1\"/>\n<title>%2</title>\n<style>%3</style>\n"
               "</head>\n<body>\n<main>\n<h1>%2</h1>\n%4</main>\n</body>\n</html>\n")
        .arg(language, title.toHtmlEscaped(), pageStyle(), body);
}

} // namespace teleta::figure
