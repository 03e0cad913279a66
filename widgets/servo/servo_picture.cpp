// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/servo/servo_picture.h"

#include "widgets/base/numbers/number_format.h"
#include "widgets/base/numbers/tabular_text.h"
#include "widgets/base/theme.h"
#include "widgets/servo/servo_texts.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

namespace teleta::servo {

namespace {

constexpr int kRows = 6;
constexpr double kMargin_em = 0.5;
constexpr double kGap_em = 0.8; ///< between columns

struct Shown {
    double factor;
    QString unit;
};

/// Factor from the unit of a feature to the one shown.
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

void ServoPicture::showMatrices(bool shown) {
    m_hasMatrices = shown;
    updateGeometry();
    update();
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

QSize ServoPicture::minimumSizeHint() const {
    const int matrices = m_hasMatrices ? base::em(this, 9.7) : 0;
    return {base::em(this, 22), static_cast<int>(7.3 * lineHeight()) + matrices};
}

QSize ServoPicture::sizeHint() const {
    const Columns natural = columns(0.0);
    const double width_px = std::accumulate(natural.width_px.begin(), natural.width_px.end(), 0.0) +
                            natural.unit_px + 2.0 * kMargin_em * base::em(this, 1);
    return minimumSizeHint().expandedTo({static_cast<int>(std::ceil(width_px)), 0});
}

std::array<QString, 4> ServoPicture::titles() {
    return {tr("Feature"), tr("Desired"), tr("Actual"), tr("Error")};
}

ServoPicture::Columns ServoPicture::columns(double width_px) const {
    const double em = base::em(this, 1);
    const QFontMetricsF small(base::sized(font(), base::kSmallText));
    const QFontMetricsF text(base::bold(font()));
    // Names and numbers must be fully visible; titles may be shortened.
    std::array<double, 4> least_px{};
    for (int row = 0; row < kRows; ++row)
        for (const bool edge : {true, false})
            least_px[0] = std::max(least_px[0], text.horizontalAdvance(ServoTexts::feature(row, edge)));
    for (std::size_t i = 1; i < 4; ++i)
        least_px[i] = text.horizontalAdvance(QStringLiteral("\u2212188.8")) + kGap_em * em;
    Columns columns;
    const std::array<QString, 4> titles = ServoPicture::titles();
    double more_px = 0.0; // additional width for the titles
    for (std::size_t i = 0; i < 4; ++i) {
        const double gap_px = i == 0 ? 0.0 : kGap_em * em;
        columns.width_px[i] = std::max(least_px[i], std::ceil(small.horizontalAdvance(titles[i])) + gap_px);
        more_px += columns.width_px[i] - least_px[i];
    }
    columns.unit_px = text.horizontalAdvance(QStringLiteral("mm")) + kGap_em * em;
    if (width_px <= 0.0)
        return columns;
    const double free_px = width_px - 2.0 * kMargin_em * em - columns.unit_px -
                           std::accumulate(columns.width_px.begin(), columns.width_px.end(), 0.0);
    for (std::size_t i = 0; i < 4; ++i) {
        if (free_px >= 0.0)
            columns.width_px[i] += i == 0 ? 0.0 : free_px / 3.0;
        else if (more_px > 0.0)
            columns.width_px[i] -= std::min(1.0, -free_px / more_px) * (columns.width_px[i] - least_px[i]);
    }
    return columns;
}

QRectF ServoPicture::titleRect(const Columns& columns, std::size_t index) const {
    const double left = kMargin_em * base::em(this, 1) +
                        std::accumulate(columns.width_px.begin(),
                                        columns.width_px.begin() + static_cast<std::ptrdiff_t>(index), 0.0);
    return {left, 0.0, columns.width_px[index], lineHeight()};
}

std::array<QString, 4> ServoPicture::shownTitles() const {
    return shownTitles(columns(width()));
}

std::array<QString, 4> ServoPicture::shownTitles(const Columns& columns) const {
    const QFontMetricsF small(base::sized(font(), base::kSmallText));
    std::array<QString, 4> shown = titles();
    for (std::size_t i = 0; i < 4; ++i)
        shown[i] = small.elidedText(shown[i], Qt::ElideRight, columns.width_px[i] + 0.5);
    return shown;
}

bool ServoPicture::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const std::array<QString, 4> whole = titles();
        const Columns columns = this->columns(width());
        const std::array<QString, 4> shown = shownTitles(columns);
        for (std::size_t i = 0; i < 4; ++i)
            if (const QRectF rect = titleRect(columns, i);
                shown[i] != whole[i] && rect.contains(help->pos())) {
                QToolTip::showText(help->globalPos(), whole[i], this, rect.toAlignedRect());
                return true;
            }
    }
    return QWidget::event(event);
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
    updateGeometry();
    update();
}

void ServoPicture::paintFeatures(QPainter& painter) const {
    const double em = base::em(this, 1);
    const double line = lineHeight();
    const double margin = kMargin_em * em;
    const Columns columns = this->columns(width()); // computed once, because it measures all texts
    const auto cell = [&](int row, std::size_t index) {
        return titleRect(columns, index).translated(0.0, row * line);
    };
    const QColor quiet =
        base::mixed(palette().color(QPalette::WindowText), palette().color(QPalette::Window), 0.35);
    painter.setFont(base::sized(font(), base::kSmallText));
    painter.setPen(quiet);
    const std::array<QString, 4> titles = shownTitles(columns);
    for (std::size_t i = 0; i < 4; ++i)
        painter.drawText(cell(0, i), (i == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter, titles[i]);
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
        for (std::size_t i = 0; i < 3; ++i)
            base::drawTabularText(painter, cell(row + 1, i + 1), Qt::AlignRight | Qt::AlignVCenter,
                                  values[i]);
        painter.setFont(font());
        painter.setPen(quiet);
        const QRectF last = cell(row + 1, 3);
        painter.drawText(QRectF(last.right() + 0.4 * em, last.top(), width() - last.right(), line),
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
    if (!m_hasMatrices)
        return;
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
