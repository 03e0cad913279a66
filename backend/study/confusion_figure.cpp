// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/confusion_figure.h"

#include "backend/core/output_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QString>

#include <cmath>
#include <set>

namespace teleta::study {

namespace {

struct FigureText {
    Q_DECLARE_TR_FUNCTIONS(StudyFigure)
};

constexpr int kCell = 56;
constexpr int kLeft = 96;
constexpr int kTop = 92;
constexpr int kMargin = 16;
constexpr double kDarkFrom_percent = 60.0;

QString text(int x, int y, const QString& content, const QString& style) {
    return QStringLiteral("<text x=\"%1\" y=\"%2\" %3>%4</text>\n")
        .arg(x)
        .arg(y)
        .arg(style, content.toHtmlEscaped());
}

QString percentText(const std::optional<double>& percent) {
    if (!percent)
        return QStringLiteral("NA");
    return *percent == 0.0 ? QStringLiteral("0") : QString::number(*percent, 'f', 1);
}

QString cell(int x, int y, const std::optional<double>& percent) {
    const int shade = 255 - static_cast<int>(std::lround(percent.value_or(0.0) * 2.0));
    const QString ink =
        percent.value_or(0.0) > kDarkFrom_percent ? QStringLiteral("white") : QStringLiteral("black");
    return QStringLiteral("<rect x=\"%1\" y=\"%2\" width=\"%3\" height=\"%3\" fill=\"rgb(%4,%4,%4)\" "
                          "stroke=\"#888\"/>\n")
               .arg(x)
               .arg(y)
               .arg(kCell)
               .arg(shade) +
           text(x + kCell / 2, y + kCell / 2 + 5, percentText(percent),
                QStringLiteral("class=\"cell\" fill=\"%1\"").arg(ink));
}

QString safeName(const std::string& name) {
    QString safe = QString::fromStdString(name);
    for (QChar& c : safe) {
        const bool plain = c.unicode() < 128 && (c.isLetterOrNumber() || c == QLatin1Char('-'));
        c = plain ? c : QLatin1Char('_');
    }
    return safe;
}

} // namespace

std::string confusionSvg(const ConfusionMatrix& matrix, const std::vector<std::string>& patterns,
                         const std::string& title) {
    const std::size_t columns = matrix.unanswered() > 0 ? matrix.columns() : matrix.patterns();
    const int width = kLeft + kCell * static_cast<int>(columns) + kMargin;
    const int height = kTop + kCell * static_cast<int>(matrix.patterns()) + kMargin;
    const QString bold = QStringLiteral("class=\"head\"");
    QString svg = QStringLiteral("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%1\" height=\"%2\" "
                                 "viewBox=\"0 0 %1 %2\" font-family=\"sans-serif\" font-size=\"14\">\n"
                                 "<style>.cell,.head{text-anchor:middle}.head{font-weight:bold}</style>\n"
                                 "<rect width=\"%1\" height=\"%2\" fill=\"white\"/>\n")
                      .arg(width)
                      .arg(height);
    const int middle = kLeft + kCell * static_cast<int>(columns) / 2;
    svg += text(width / 2, 24, QString::fromStdString(title), bold);
    svg += text(middle, 52, FigureText::tr("Subject response, %"), bold);
    const int rowsMiddle = kTop + kCell * static_cast<int>(matrix.patterns()) / 2;
    svg += text(20, rowsMiddle, FigureText::tr("Actual pattern"),
                QStringLiteral("class=\"head\" transform=\"rotate(-90 20 %1)\"").arg(rowsMiddle));
    for (std::size_t j = 0; j < columns; ++j) {
        const QString name =
            j == matrix.noneColumn() ? QStringLiteral("NONE") : QString::fromStdString(patterns[j]);
        svg += text(kLeft + kCell * static_cast<int>(j) + kCell / 2, 80, name, bold);
    }
    for (std::size_t i = 0; i < matrix.patterns(); ++i) {
        const int y = kTop + kCell * static_cast<int>(i);
        svg += text(kLeft - 28, y + kCell / 2 + 5, QString::fromStdString(patterns[i]), bold);
        for (std::size_t j = 0; j < columns; ++j)
            svg += cell(kLeft + kCell * static_cast<int>(j), y, matrix.rowPercent(i, j));
    }
    return (svg + QStringLiteral("</svg>\n")).toStdString();
}

core::Expected<void> writeFigures(const std::vector<TaskResults>& results, const std::string& folder) {
    const QDir figures(QDir(QString::fromStdString(folder)).filePath(QStringLiteral("figures")));
    if (!figures.mkpath(QStringLiteral(".")))
        return core::Unexpected(core::Error{core::ErrorKind::ioFailed,
                                            FigureText::tr("cannot make the folder").toStdString(),
                                            {},
                                            {figures.path().toStdString()}});
    std::set<QString> names;
    for (const TaskResults& task : results) {
        for (const GroupSummary& group : task.groups) {
            const QString name =
                QStringLiteral("confusion_%1_%2.svg").arg(safeName(task.task), safeName(group.condition));
            const std::string path = figures.filePath(name).toStdString();
            if (!names.insert(name).second)
                return core::Unexpected(
                    core::Error{core::ErrorKind::refused,
                                FigureText::tr("two figures have the same name").toStdString(),
                                {},
                                {path}});
            core::Expected<core::OutputFile> file = core::OutputFile::create(path);
            if (!file)
                return core::Unexpected(file.error());
            file->write(confusionSvg(group.matrix, task.patterns, task.task + ", " + group.condition));
            if (const core::Expected<void> finished = file->finish(); !finished)
                return finished;
        }
    }
    return {};
}

} // namespace teleta::study
