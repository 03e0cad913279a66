// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/results/confusion_view.h"

#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMenu>
#include <QPainter>

#include <utility>

namespace teleta::study {

ConfusionView::ConfusionView(QWidget* parent)
    : FigureView(parent, {24, 22}, {15, 14}) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    base::keepTranslated(this, &ConfusionView::describe);
}

void ConfusionView::setContent(ConfusionContent content) {
    content.percent = m_content.percent;
    if (content == m_content)
        return;
    m_content = std::move(content);
    describe();
    update();
}

void ConfusionView::setPercent(bool percent) {
    if (std::exchange(m_content.percent, percent) == percent)
        return;
    update();
    emit percentChanged(percent);
}

base::Figure ConfusionView::figure() {
    base::Figure figure;
    figure.name = QStringLiteral("confusion");
    const double side_px = 64.0;
    figure.size_px = QSizeF(side_px * (static_cast<double>(m_content.matrix.columns()) + 2.0),
                            side_px * (static_cast<double>(m_content.matrix.patterns()) + 1.8));
    figure.paint = [content = m_content, size = figure.size_px, font = font()](QPainter& painter) {
        painter.setFont(font);
        paintConfusion(painter, QRectF(QPointF(), size), content, base::designedPalette(false));
    };
    figure.csv = [content = m_content] { return confusionCsv(content); };
    return figure;
}

void ConfusionView::describe() {
    setAccessibleName(tr("Confusion matrix"));
    const std::optional<double> accuracy = m_content.matrix.accuracy();
    setAccessibleDescription(
        accuracy ? tr("%1 of %2 right").arg(m_content.matrix.correct()).arg(m_content.matrix.total())
                 : tr("No trials yet"));
    setWhatsThis(
        tr("<p>Rows: what was presented. Columns: what was answered, and NONE for no answer in time. "
           "<b>Space</b> or a double click switches between counts and percent of the row.</p>"));
}

QString ConfusionView::toolTipAt(const QPointF& point) const {
    const ConfusionMatrix& matrix = m_content.matrix;
    const ConfusionLayout layout(rect(), QFontMetricsF(font()).height(), matrix.patterns(), matrix.columns());
    const auto cell = layout.cellAt(point);
    if (!cell)
        return {};
    const auto [row, column] = *cell;
    const QString presented = m_content.letters.value(static_cast<qsizetype>(row));
    const QString counts =
        tr("%1 of %2", "count of a row").arg(matrix.count(row, column)).arg(matrix.rowTotal(row));
    const std::optional<double> percent = matrix.rowPercent(row, column);
    const QString share =
        percent ? QStringLiteral(" (%1 %)").arg(QLocale().toString(*percent, 'f', 1)) : QString();
    const QString text = column == matrix.noneColumn()
                             ? tr("%1 not answered in time: ", "pattern").arg(presented)
                             : tr("%1 answered as %2: ", "pattern, pattern")
                                   .arg(presented, m_content.letters.value(static_cast<qsizetype>(column)));
    return text + counts + share;
}

void ConfusionView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    paintConfusion(painter, rect(), m_content, palette());
}

void ConfusionView::addOwnActions(QMenu& menu, const QPoint& /*position*/) {
    QAction* percent = menu.addAction(tr("In &percent"));
    percent->setCheckable(true);
    percent->setChecked(m_content.percent);
    connect(percent, &QAction::toggled, this, &ConfusionView::setPercent);
}

void ConfusionView::mouseDoubleClickEvent(QMouseEvent* /*event*/) {
    setPercent(!m_content.percent);
}

void ConfusionView::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat())
        setPercent(!m_content.percent);
    else
        FigureView::keyPressEvent(event);
}

} // namespace teleta::study
