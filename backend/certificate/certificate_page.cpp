// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/certificate/certificate_page.h"

#include "backend/figure/html_page.h"
#include "backend/figure/html_table.h"
#include "backend/figure/svg_canvas.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace teleta::certificate {

namespace {

struct CertificateText {
    Q_DECLARE_TR_FUNCTIONS(CertificateText)
};

QString ms(const std::optional<double>& time_s) {
    return time_s ? QString::number(1e3 * *time_s, 'f', 1) : QStringLiteral("NA");
}

QString paragraph(const QString& text, const QString& attributes = {}) {
    return QStringLiteral("<p%1>%2</p>\n").arg(attributes, text.toHtmlEscaped());
}

QString heading(const QString& text) {
    return QStringLiteral("<h2>%1</h2>\n").arg(text.toHtmlEscaped());
}

/// What is done, for people who read the table.
QString meaningOf(FaultKind kind) {
    switch (kind) {
    case FaultKind::kill:
        return CertificateText::tr(
            "The program is ended by SIGKILL. Only what watches over the device is left.");
    case FaultKind::terminate:
        return CertificateText::tr("SIGTERM, as when a session ends.");
    case FaultKind::interrupt:
        return CertificateText::tr("SIGINT, as by Ctrl-C.");
    case FaultKind::hangUp:
        return CertificateText::tr("SIGHUP, as when a terminal closes.");
    case FaultKind::sleep:
        return CertificateText::tr("SIGSTOP, later SIGCONT, as when the computer sleeps.");
    case FaultKind::unplug:
        return CertificateText::tr("The line is cut and cannot be opened for a while.");
    case FaultKind::lateAnswers:
        return CertificateText::tr("The driver's answers are held back.");
    case FaultKind::lostRequests:
        return CertificateText::tr("What the program sends does not arrive.");
    case FaultKind::lies:
        return CertificateText::tr(
            "The driver's answers are replaced by garbage, by refusals, or by answers to other requests.");
    case FaultKind::stop:
        return CertificateText::tr("STOP is engaged.");
    case FaultKind::diskFull:
        return CertificateText::tr("The recording can no longer grow; then STOP. Timed from STOP.");
    case FaultKind::memoryRefused:
        return CertificateText::tr("The program gets no more memory; then STOP. Timed from STOP.");
    case FaultKind::clockStep:
        return CertificateText::tr(
            "The wall clock is set an hour forward or back; then STOP. Timed from STOP.");
    }
    return {};
}

bool isOfArm(const Certificate& certificate) {
    return certificate.system.actuator == Actuator::arm;
}

QString verdictOnArm(const Certificate& certificate, const FaultTally& all) {
    if (certificate.passes())
        return paragraph(
            CertificateText::tr("Passed: after each of %1 faults the arm was at rest within %2 ms. It never "
                                "moved again by itself. With 95 % confidence, at most %3 % of such faults "
                                "take longer.")
                .arg(all.faults)
                .arg(ms(certificate.bound_s))
                .arg(100.0 * shareOverBoundAtMost(all), 0, 'f', 2));
    return paragraph(CertificateText::tr("Not passed: of %1 faults, %2 left the arm moving for more than %3 "
                                         "ms. After %4 of them it moved again by itself.")
                         .arg(all.faults)
                         .arg(all.overBound)
                         .arg(ms(certificate.bound_s))
                         .arg(all.restarted),
                     QStringLiteral(" class=\"warning\""));
}

QString verdict(const Certificate& certificate) {
    const FaultTally all = certificate.total();
    const QString bound = ms(certificate.bound_s);
    if (all.faults == 0)
        return paragraph(CertificateText::tr("No fault was injected."), QStringLiteral(" class=\"warning\""));
    if (isOfArm(certificate))
        return verdictOnArm(certificate, all);
    if (certificate.passes())
        return paragraph(
            CertificateText::tr("Passed: after each of %1 faults the motors were at zero within %2 ms. They "
                                "never restarted by themselves, and no recorded frame was lost. With 95 % "
                                "confidence, at most %3 % of such faults take longer.")
                .arg(all.faults)
                .arg(bound)
                .arg(100.0 * shareOverBoundAtMost(all), 0, 'f', 2));
    return paragraph(
        CertificateText::tr(
            "Not passed: of %1 faults, %2 left the motors on for more than %3 ms. After %4 of them the "
            "motors restarted by themselves. %5 recorded frames were lost, and %6 recordings were damaged.")
            .arg(all.faults)
            .arg(all.overBound)
            .arg(bound)
            .arg(all.restarted)
            .arg(all.framesLost)
            .arg(all.filesDamaged),
        QStringLiteral(" class=\"warning\""));
}

/// What was recorded is shown where something records.
QString kindTable(const Certificate& certificate) {
    const bool records = !isOfArm(certificate);
    QStringList head{CertificateText::tr("Fault"),
                     CertificateText::tr("Number"),
                     CertificateText::tr("Median"),
                     CertificateText::tr("99 %"),
                     CertificateText::tr("Longest"),
                     CertificateText::tr("Over the bound"),
                     CertificateText::tr("Share, upper limit (%)"),
                     CertificateText::tr("Restarted by itself")};
    if (records)
        head << CertificateText::tr("Frames lost") << CertificateText::tr("Files damaged");
    figure::HtmlTable table(
        records ? CertificateText::tr("Time from the fault until the motors were at zero, in ms")
                : CertificateText::tr("Time from the fault until the arm was at rest, in ms"),
        head);
    const auto addRow = [&](const QString& name, const FaultTally& tally) {
        QStringList row{name,
                        QString::number(tally.faults),
                        ms(tally.median_s),
                        ms(tally.p99_s),
                        ms(tally.longest_s),
                        QString::number(tally.overBound),
                        QString::number(100.0 * shareOverBoundAtMost(tally), 'f', 2),
                        QString::number(tally.restarted)};
        if (records)
            row << QString::number(tally.framesLost) << QString::number(tally.filesDamaged);
        table.row(row);
    };
    for (const FaultTally& tally : certificate.tallies())
        addRow(nameOf(tally.kind), tally);
    addRow(CertificateText::tr("All"), certificate.total());
    return table.html();
}

/// All times, one row of dots for each kind, with the bound.
QString timePicture(const Certificate& certificate) {
    constexpr double kLeft = 190.0;
    constexpr double kRight = 760.0;
    constexpr double kTop = 24.0;
    constexpr double kRow = 26.0;
    constexpr double kStep_s = 0.05;
    const std::vector<FaultTally> tallies = certificate.tallies();
    double end_s = certificate.bound_s;
    for (const FaultOutcome& outcome : certificate.outcomes)
        end_s = std::max(end_s, outcome.zero_s.value_or(0.0));
    end_s *= 1.05;
    const double bottom = kTop + kRow * static_cast<double>(tallies.size());
    figure::SvgCanvas canvas(
        kRight + 30.0, bottom + 50.0,
        isOfArm(certificate) ? CertificateText::tr("Times until the arm was at rest, by kind of fault")
                             : CertificateText::tr("Times until the motors were at zero, by kind of fault"));
    const auto at = [&](double time_s) { return kLeft + (kRight - kLeft) * time_s / end_s; };
    for (int k = 0; k * kStep_s <= end_s; ++k) {
        canvas.line(at(k * kStep_s), kTop, at(k * kStep_s), bottom, QStringLiteral("soft"));
        canvas.text(at(k * kStep_s), bottom + 18.0, QString::number(std::lround(1e3 * k * kStep_s)),
                    QStringLiteral("soft small middle"));
    }
    canvas.text(0.5 * (kLeft + kRight), bottom + 40.0,
                isOfArm(certificate) ? CertificateText::tr("Time until rest (ms)")
                                     : CertificateText::tr("Time until zero (ms)"),
                QStringLiteral("ink middle"));
    canvas.path({{at(certificate.bound_s), kTop}, {at(certificate.bound_s), bottom}},
                QStringLiteral("class=\"hollow series1\""));
    canvas.text(at(certificate.bound_s), kTop - 8.0, CertificateText::tr("bound"),
                QStringLiteral("ink small middle"));
    for (std::size_t row = 0; row < tallies.size(); ++row) {
        const double y = kTop + kRow * (static_cast<double>(row) + 0.5);
        canvas.text(kLeft - 10.0, y + 4.0, nameOf(tallies[row].kind), QStringLiteral("ink end"));
        int k = 0;
        for (const FaultOutcome& outcome : certificate.outcomes)
            if (outcome.kind == tallies[row].kind && outcome.zero_s)
                // Spread over the row, so that equal times can be told apart.
                canvas.circle(at(*outcome.zero_s), y + 3.0 * (k++ % 5 - 2), 1.8,
                              QStringLiteral("class=\"series0\""));
    }
    return QStringLiteral("<figure>\n%1</figure>\n").arg(QString::fromStdString(canvas.embedded()));
}

QString systemTable(const Certificate& certificate) {
    const CertifiedSystem& system = certificate.system;
    figure::HtmlTable table(CertificateText::tr("System under test"), {CertificateText::tr("Part"), {}});
    table.row({CertificateText::tr("Program"), QString::fromStdString(system.version)});
    table.row(
        {isOfArm(certificate) ? CertificateText::tr("Arm") : CertificateText::tr("Driver of the motors"),
         system.simulated ? CertificateText::tr("%1 (SIMULATED)").arg(QString::fromStdString(system.driver))
                          : QString::fromStdString(system.driver)});
    table.row({CertificateText::tr("Started"), QString::fromStdString(system.started)});
    table.row({CertificateText::tr("System"), QString::fromStdString(system.kernel)});
    table.row({CertificateText::tr("Processor"), CertificateText::tr("%1, %n core(s)", nullptr, system.cores)
                                                     .arg(QString::fromStdString(system.processor))});
    table.row({CertificateText::tr("Load average (1 min)"), QString::number(system.load, 'f', 2)});
    table.row({CertificateText::tr("Longest gap between two readings"),
               CertificateText::tr("%1 ms").arg(ms(system.resolution_s))});
    table.row({CertificateText::tr("Seed"), QString::number(certificate.seed)});
    return table.html();
}

} // namespace

QString nameOf(FaultKind kind) {
    switch (kind) {
    case FaultKind::kill:
        return CertificateText::tr("Killed");
    case FaultKind::terminate:
        return CertificateText::tr("Terminated");
    case FaultKind::interrupt:
        return CertificateText::tr("Interrupted");
    case FaultKind::hangUp:
        return CertificateText::tr("Terminal closed");
    case FaultKind::sleep:
        return CertificateText::tr("Put to sleep");
    case FaultKind::unplug:
        return CertificateText::tr("Unplugged");
    case FaultKind::lateAnswers:
        return CertificateText::tr("Answers late");
    case FaultKind::lostRequests:
        return CertificateText::tr("Requests lost");
    case FaultKind::lies:
        return CertificateText::tr("Answers wrong");
    case FaultKind::stop:
        return CertificateText::tr("STOP");
    case FaultKind::diskFull:
        return CertificateText::tr("Disk full, STOP");
    case FaultKind::memoryRefused:
        return CertificateText::tr("Memory refused, STOP");
    case FaultKind::clockStep:
        return CertificateText::tr("Clock set, STOP");
    }
    return {};
}

QString certificatePage(const Certificate& certificate) {
    QString body;
    if (certificate.system.simulated)
        body += paragraph(isOfArm(certificate)
                              ? CertificateText::tr("SIMULATED: the arm is a program.")
                              : CertificateText::tr("SIMULATED: the driver of the motors is a program."),
                          QStringLiteral(" class=\"mode\""));
    body += verdict(certificate);
    if (!certificate.outcomes.empty())
        body += heading(CertificateText::tr("Faults")) + kindTable(certificate) + timePicture(certificate);
    body += heading(CertificateText::tr("System")) + systemTable(certificate);
    body += heading(CertificateText::tr("What each fault does"));
    for (const FaultTally& tally : certificate.tallies())
        body += QStringLiteral("<p><b>%1.</b> %2</p>\n")
                    .arg(nameOf(tally.kind).toHtmlEscaped(), meaningOf(tally.kind).toHtmlEscaped());
    for (const std::string& remark : certificate.remarks)
        body += paragraph(QString::fromStdString(remark));
    return figure::htmlPage(CertificateText::tr("en", "language of the page, as BCP 47 has it"),
                            CertificateText::tr("Certificate of faults"), body);
}

} // namespace teleta::certificate
