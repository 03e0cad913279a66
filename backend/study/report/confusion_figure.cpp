// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/report/confusion_figure.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <cmath>

namespace teleta::study {

namespace {

struct FigureText {
    Q_DECLARE_TR_FUNCTIONS(FigureText)
};

constexpr double kCell = 56.0;
constexpr double kLeft = 96.0;
constexpr double kTop = 92.0;
constexpr double kMargin = 16.0;
constexpr double kDarkFrom_percent = 60.0;
constexpr double kLetterWidth = 8.5; // of a bold title, on average

QString percentText(const std::optional<double>& percent) {
    if (!percent)
        return QStringLiteral("NA");
    return *percent == 0.0 ? QStringLiteral("0") : QString::number(*percent, 'f', 1);
}

QString headingOf(ConfusionValues values) {
    switch (values) {
    case ConfusionValues::percent:
        return FigureText::tr("Subject response, %");
    case ConfusionValues::counts:
        return FigureText::tr("Subject response, trials");
    case ConfusionValues::both:
        break;
    }
    return FigureText::tr("Subject response, % and trials");
}

void drawCell(figure::SvgCanvas& canvas, double x, double y, const ConfusionMatrix& matrix, std::size_t i,
              std::size_t j, ConfusionValues values) {
    const std::optional<double> percent = matrix.rowPercent(i, j);
    const auto shade = 255 - std::lround(percent.value_or(0.0) * 2.0);
    const QString ink =
        percent.value_or(0.0) > kDarkFrom_percent ? QStringLiteral("white") : QStringLiteral("black");
    canvas.rectangle(x, y, kCell, kCell, QStringLiteral("fill=\"rgb(%1,%1,%1)\" stroke=\"#888\"").arg(shade));
    const QString colour = QStringLiteral("fill=\"%1\"").arg(ink);
    const QString number = QString::number(matrix.count(i, j));
    const double middle = x + kCell / 2.0;
    switch (values) {
    case ConfusionValues::percent:
        canvas.text(middle, y + kCell / 2.0 + 5.0, percentText(percent), QStringLiteral("middle"), colour);
        break;
    case ConfusionValues::counts:
        canvas.text(middle, y + kCell / 2.0 + 5.0, number, QStringLiteral("middle"), colour);
        break;
    case ConfusionValues::both:
        canvas.text(middle, y + kCell / 2.0 - 2.0, percentText(percent), QStringLiteral("middle"), colour);
        canvas.text(middle, y + kCell / 2.0 + 16.0,
                    QStringLiteral("%1/%2").arg(number).arg(matrix.rowTotal(i)),
                    QStringLiteral("middle small"), colour);
        break;
    }
}

} // namespace

figure::SvgCanvas confusionFigure(const ConfusionMatrix& matrix, const std::vector<std::string>& patterns,
                                  const std::string& title, ConfusionValues values,
                                  std::optional<Mode> mode) {
    const std::size_t columns = matrix.unanswered() > 0 ? matrix.columns() : matrix.patterns();
    const double tableWidth = kCell * static_cast<double>(columns);
    const QString name = QString::fromStdString(title);
    const double width = std::max(kLeft + tableWidth + kMargin,
                                  kLetterWidth * static_cast<double>(name.size()) + 2.0 * kMargin);
    const double height = kTop + kCell * static_cast<double>(matrix.patterns()) + kMargin;
    const QString bold = QStringLiteral("ink middle bold");
    figure::SvgCanvas canvas(width, height, name);
    canvas.text(width / 2.0, 24.0, name, bold);
    canvas.text(kLeft + tableWidth / 2.0, 52.0, headingOf(values), bold);
    const double rowsMiddle = kTop + (height - kTop - kMargin) / 2.0;
    canvas.text(20.0, rowsMiddle, FigureText::tr("Actual pattern"), bold,
                QStringLiteral("transform=\"rotate(-90 20 %1)\"").arg(figure::svgNumber(rowsMiddle)));
    for (std::size_t j = 0; j < columns; ++j)
        canvas.text(kLeft + kCell * (static_cast<double>(j) + 0.5), 80.0,
                    j == matrix.noneColumn() ? QStringLiteral("NONE") : QString::fromStdString(patterns[j]),
                    bold);
    for (std::size_t i = 0; i < matrix.patterns(); ++i) {
        const double y = kTop + kCell * static_cast<double>(i);
        canvas.text(kLeft - 28.0, y + kCell / 2.0 + 5.0, QString::fromStdString(patterns[i]), bold);
        for (std::size_t j = 0; j < columns; ++j)
            drawCell(canvas, kLeft + kCell * static_cast<double>(j), y, matrix, i, j, values);
    }
    canvas.watermark(watermarkOf(mode));
    return canvas;
}

QString watermarkOf(std::optional<Mode> mode) {
    if (!mode || *mode == Mode::run)
        return {};
    return *mode == Mode::pilot ? QCoreApplication::translate("StudyFigure", "PILOT")
                                : QCoreApplication::translate("StudyFigure", "SIMULATED");
}

std::string confusionSvg(const ConfusionMatrix& matrix, const std::vector<std::string>& patterns,
                         const std::string& title, ConfusionValues values, std::optional<Mode> mode) {
    return confusionFigure(matrix, patterns, title, values, mode).standalone();
}

} // namespace teleta::study
