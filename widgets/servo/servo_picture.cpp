// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/servo/servo_picture.h"

#include "widgets/base/number_format.h"
#include "widgets/base/tabular_text.h"
#include "widgets/base/theme.h"
#include "widgets/servo/servo_texts.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <array>
#include <numbers>

namespace teleta::servo {

namespace {

constexpr int kRows = 6;

struct Shown {
    double factor;
    QString unit;
};

/// From the feature's own unit to the one that is shown.
Shown shownAs(int row, double compliance_mPerN) {
    if (row == kZ)
        return {1.0 / compliance_mPerN, QStringLiteral("N")};
    if (row == kWz)
        return {180.0 / std::numbers::pi, QStringLiteral("\u00b0")};
    return {1e3, QStringLiteral("mm")};
}

QString elementText(double value) {
    return value > 0.0 ? QStringLiteral("1") : value < 0.0 ? QStringLiteral("\u22121") : QStringLiteral("0");
}

} // namespace

ServoPicture::ServoPicture(QWidget* parent)
    : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    describe();
}

void ServoPicture::setReport(const std::optional<ServoReport>& report) {
    m_report = report;
    update();
}

std::array<QString, 3> ServoPicture::featureTexts(int row) const {
    if (!m_report)
        return {base::threeDigits(std::nullopt), base::threeDigits(std::nullopt),
                base::threeDigits(std::nullopt)};
    const ServoOutput& output = m_report->output;
    const double factor = shownAs(row, m_report->normalCompliance_mPerN).factor;
    const auto shown = [&](double value, bool known) {
        return base::threeDigits(known ? std::optional(factor * value) : std::nullopt);
    };
    const bool known = output.known[static_cast<std::size_t>(row)];
    return {shown(output.desired[row], true), shown(output.actual[row], known),
            shown(output.desired[row] - output.actual[row], known)};
}

QStringList ServoPicture::matrixTexts(const Matrix6& matrix) {
    QStringList rows;
    for (int row = 0; row < kRows; ++row) {
        QStringList elements;
        for (int column = 0; column < kRows; ++column)
            elements << elementText(matrix(row, column));
        rows << elements.join(QLatin1Char(' '));
    }
    return rows;
}

double ServoPicture::lineHeight() const {
    return 1.35 * base::em(this, 1);
}

QSize ServoPicture::sizeHint() const {
    const int matrix = base::em(this, 7.5);
    return {base::em(this, 22), static_cast<int>(7.3 * lineHeight()) + matrix + base::em(this, 2.2)};
}

void ServoPicture::describe() {
    setAccessibleName(tr("Features and matrices of the servo"));
    setToolTip(
        tr("Desired and actual features as the inverse tactile Jacobian selects them; bold rows act on the "
           "motion through the projection matrix P."));
}

void ServoPicture::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        describe();
    update();
}

void ServoPicture::paintFeatures(QPainter& painter) const {
    const double em = base::em(this, 1);
    const double line = lineHeight();
    const double margin = 0.5 * em;
    const double unitWidth = 2.2 * em;
    const double column = (width() - 2.0 * margin - unitWidth) / 4.0;
    const auto cell = [&](int row, int index) {
        return QRectF(margin + index * column, row * line, column, line);
    };
    const QColor quiet =
        base::mixed(palette().color(QPalette::WindowText), palette().color(QPalette::Window), 0.35);
    painter.setFont(base::sized(font(), base::kSmallText));
    painter.setPen(quiet);
    const std::array<QString, 4> titles{tr("Feature"), tr("Desired"), tr("Actual"), tr("Error")};
    for (int i = 0; i < 4; ++i)
        painter.drawText(cell(0, i), (i == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter,
                         titles[static_cast<std::size_t>(i)]);
    painter.setPen(
        base::mixed(palette().color(QPalette::WindowText), palette().color(QPalette::Window), 0.75));
    painter.drawLine(QPointF(margin, line), QPointF(width() - margin, line));

    const ServoReport empty;
    const ServoOutput& output = m_report ? m_report->output : empty.output;
    for (int row = 0; row < kRows; ++row) {
        const bool acts = m_report && output.projection.col(row).any();
        QFont rowFont = font();
        rowFont.setBold(acts);
        painter.setFont(rowFont);
        painter.setPen(acts ? palette().color(QPalette::WindowText) : quiet);
        painter.drawText(cell(row + 1, 0), Qt::AlignLeft | Qt::AlignVCenter,
                         ServoTexts::feature(row, output.edge));
        const std::array<QString, 3> values = featureTexts(row);
        for (int i = 0; i < 3; ++i)
            base::drawTabularText(painter, cell(row + 1, i + 1), Qt::AlignRight | Qt::AlignVCenter,
                                  values[static_cast<std::size_t>(i)]);
        painter.setFont(font());
        painter.setPen(quiet);
        painter.drawText(QRectF(margin + 4.0 * column + 0.4 * em, (row + 1) * line, unitWidth, line),
                         Qt::AlignLeft | Qt::AlignVCenter,
                         shownAs(row, m_report ? m_report->normalCompliance_mPerN : 1.0).unit);
    }
}

void ServoPicture::paintMatrix(QPainter& painter, const QRectF& rect, const QString& name,
                               const Matrix6& matrix) const {
    const double em = base::em(this, 1);
    const QColor text = palette().color(QPalette::WindowText);
    const QColor window = palette().color(QPalette::Window);
    painter.setFont(base::sized(font(), base::kSmallText));
    painter.setPen(text);
    painter.drawText(QRectF(rect.left(), rect.top(), rect.width(), 1.3 * em),
                     Qt::AlignLeft | Qt::AlignVCenter, name);
    const double side = std::min(rect.width(), rect.height() - 1.4 * em) / kRows;
    const QPointF corner(rect.left(), rect.top() + 1.4 * em);
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kRows; ++column) {
            const double value = matrix(row, column);
            const QRectF square(corner.x() + column * side, corner.y() + row * side, side, side);
            const QColor fill = value > 0.0   ? palette().color(QPalette::Highlight)
                                : value < 0.0 ? base::statusColours(palette()).simulated
                                              : palette().color(QPalette::Base);
            painter.setPen(base::mixed(text, window, 0.75));
            painter.setBrush(fill);
            painter.drawRect(square);
            painter.setPen(value != 0.0 ? base::readableOn(fill)
                                        : base::mixed(text, palette().color(QPalette::Base), 0.5));
            painter.drawText(square, Qt::AlignCenter, elementText(value));
        }
}

void ServoPicture::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintFeatures(painter);
    const double em = base::em(this, 1);
    const double top = 7.3 * lineHeight() + 0.3 * em;
    const double half = 0.5 * width();
    const double height = base::em(this, 9);
    const ServoOutput output = m_report ? m_report->output : ServoOutput{};
    const Matrix6 none = Matrix6::Zero();
    paintMatrix(painter, QRectF(0.5 * em, top, half - em, height), tr("J\u207b\u00b9, features"),
                m_report ? output.inverseJacobian : none);
    paintMatrix(painter, QRectF(half + 0.5 * em, top, half - em, height), tr("P, motions"),
                m_report ? output.projection : none);
}

} // namespace teleta::servo
