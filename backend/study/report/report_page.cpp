// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/report_page.h"

#include "backend/figure/html_page.h"

#include <QCoreApplication>

namespace teleta::study {

namespace {

struct PageText {
    Q_DECLARE_TR_FUNCTIONS(ReportText)
};

QString modeBanner(std::optional<Mode> mode) {
    if (!mode || *mode == Mode::run)
        return {};
    return QStringLiteral("<p class=\"mode\">%1</p>\n")
        .arg(*mode == Mode::pilot
                 ? PageText::tr("PILOT: these data were taken to try the study out.")
                 : PageText::tr("SIMULATED: these answers were made by a program, not by people."));
}

} // namespace

QString reportPage(const QString& title, std::optional<Mode> mode, const QString& body) {
    return figure::htmlPage(PageText::tr("en", "language of the report, as BCP 47 has it"), title,
                            modeBanner(mode) + body);
}

} // namespace teleta::study
