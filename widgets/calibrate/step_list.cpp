// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibrate/step_list.h"

#include "widgets/base/controls/badge.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QStyledItemDelegate>

#include <algorithm>
#include <utility>

namespace teleta::calibrate {

namespace {

constexpr double kRow_em = 3.6;
constexpr double kNumber_em = 1.5; ///< diameter

QColor colourOf(StepState state, const QPalette& palette) {
    const base::StatusColours& colours = base::statusColours(palette);
    switch (state) {
    case StepState::running:
        return palette.color(QPalette::Highlight);
    case StepState::notSaved:
        return colours.stale;
    case StepState::done:
        return colours.live;
    case StepState::failed:
        return colours.lost;
    case StepState::toDo:
        break;
    }
    return colours.neutral;
}

class StepDelegate : public QStyledItemDelegate {
public:
    explicit StepDelegate(StepList& list)
        : QStyledItemDelegate(&list)
        , m_list(list) {}

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        QStyleOptionViewItem ground = option;
        initStyleOption(&ground, index);
        const QString name = std::exchange(ground.text, QString());
        m_list.style()->drawControl(QStyle::CE_ItemViewItem, &ground, painter, &m_list);
        const StepReading& reading = m_list.reading(index.row());
        const QColor colour = colourOf(reading.state, option.palette);
        const bool chosen = option.state & QStyle::State_Selected;
        const QColor text = option.palette.color(chosen ? QPalette::HighlightedText : QPalette::Text);
        const QRectF row = QRectF(option.rect).adjusted(base::grid(&m_list), 0, -base::grid(&m_list), 0);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        const double number_px = base::em(&m_list, kNumber_em);
        const QRectF disc(row.left(), row.center().y() - 0.5 * number_px, number_px, number_px);
        painter->setPen(QPen(text, 1.5));
        painter->setBrush(Qt::NoBrush);
        painter->drawEllipse(disc.adjusted(1, 1, -1, -1));
        painter->setFont(base::bold(option.font));
        painter->drawText(disc, Qt::AlignCenter, m_list.locale().toString(index.row() + 1));
        const QString chip = m_list.stateText(index.row());
        const QSizeF chipSize = base::badgeSize(option.font, chip);
        const double left = disc.right() + base::grid(&m_list);
        const QFontMetricsF metrics(option.font);
        const double gap = base::grid(&m_list, base::kTight);
        const double top = row.center().y() - 0.5 * (metrics.height() + gap + chipSize.height());
        const QRectF title(left, top, row.right() - left, metrics.height());
        painter->setFont(option.font);
        painter->drawText(title, Qt::AlignLeft | Qt::AlignVCenter,
                          metrics.elidedText(name, Qt::ElideRight, title.width()));
        const QRectF box(QPointF(left, title.bottom() + gap), chipSize);
        base::paintBadge(*painter, box, chip, colour);
        if (chosen && reading.state == StepState::running) {
            // Its ground is the colour of the row.
            painter->setBrush(Qt::NoBrush);
            painter->setPen(QPen(text, 1.0));
            painter->drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), 0.2 * box.height(),
                                     0.2 * box.height());
        }
        if (reading.state == StepState::running && reading.share) {
            const double height = base::grid(&m_list, base::kStripe);
            const QRectF bar(option.rect.left(), option.rect.bottom() + 1 - height,
                             option.rect.width() * std::clamp(*reading.share, 0.0, 1.0), height);
            painter->fillRect(bar, chosen ? text : colour);
        }
        painter->restore();
    }

private:
    StepList& m_list;
};

} // namespace

StepList::StepList(int steps, QWidget* parent)
    : QListWidget(parent)
    , m_readings(static_cast<std::size_t>(steps)) {
    setItemDelegate(new StepDelegate(*this));
    for (int step = 0; step < steps; ++step)
        addItem(QString());
    sizeRows();
    base::onChange(this, &StepList::sizeRows, {QEvent::FontChange});
    base::keepTranslated(this, &StepList::retranslate);
}

void StepList::sizeRows() {
    for (int step = 0; step < count(); ++step)
        item(step)->setSizeHint(QSize(0, base::em(this, kRow_em)));
}

void StepList::setName(int step, const QString& name) {
    item(step)->setText(name);
    describe(step);
}

void StepList::setReading(int step, const StepReading& reading) {
    StepReading& shown = m_readings[static_cast<std::size_t>(step)];
    if (shown == reading)
        return;
    shown = reading;
    describe(step);
    viewport()->update();
}

QString StepList::stateText(int step) const {
    const StepReading& reading = this->reading(step);
    switch (reading.state) {
    case StepState::running:
        return reading.of > 1 ? tr("running: %1 of %2").arg(reading.number).arg(reading.of) : tr("running");
    case StepState::notSaved:
        return tr("not saved", "a calibration");
    case StepState::done:
        return tr("done", "a calibration");
    case StepState::failed:
        return tr("failed", "a calibration");
    case StepState::toDo:
        break;
    }
    return reading.number > 0 ? tr("%1 of %2 done").arg(reading.number).arg(reading.of)
                              : tr("to do", "a calibration");
}

void StepList::describe(int step) {
    item(step)->setData(Qt::AccessibleTextRole, tr("%1. %2: %3", "number, name and state of a step")
                                                    .arg(step + 1)
                                                    .arg(item(step)->text(), stateText(step)));
    item(step)->setToolTip(stateText(step));
}

void StepList::retranslate() {
    for (int step = 0; step < count(); ++step)
        describe(step);
    viewport()->update();
}

} // namespace teleta::calibrate
