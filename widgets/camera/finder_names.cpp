// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/finder_names.h"

#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/theme.h"

#include <QApplication>
#include <QPainter>
#include <QStyle>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::camera {

QString FinderNames::code(const vision::ContactRung& finder) {
    return QString::fromLatin1(finder.name.data(), static_cast<qsizetype>(finder.name.size()));
}

QString FinderNames::title(const vision::ContactRung& finder) {
    if (finder.paper)
        return tr("As published");
    QString flow;
    switch (finder.method) {
    case vision::FlowMethod::dots:
        return tr("Printed dots");
    case vision::FlowMethod::disUltrafast:
        flow = tr("Coarse flow");
        break;
    case vision::FlowMethod::disFast:
        flow = tr("Quick flow");
        break;
    case vision::FlowMethod::disMedium:
        flow = tr("Fine flow");
        break;
    }
    if (finder.changedOnly)
        return tr("%1, changed parts", "a finder that looks only at those").arg(flow);
    if (finder.warmStart)
        return tr("%1, from the last picture", "a finder that starts there").arg(flow);
    return finder.scale < 1.0 ? tr("%1, 1 : %2", "a finder and how many times its picture is smaller")
                                    .arg(flow, base::significantDigits(1.0 / finder.scale, 2))
                              : tr("%1, whole picture", "a finder").arg(flow);
}

QString FinderNames::cost(const vision::ContactRung& finder) {
    const QString points =
        tr("%1 % of the picture's points").arg(std::round(100.0 * finder.scale * finder.scale));
    if (finder.paper)
        return tr("fine; %1, mean of those that moved").arg(points);
    switch (finder.method) {
    case vision::FlowMethod::dots:
        return tr("follows each dot alone; the default");
    case vision::FlowMethod::disUltrafast:
        return tr("quickest and coarsest; %1").arg(points);
    case vision::FlowMethod::disFast:
        return finder.changedOnly ? tr("quick; %1, where they differ from the reference").arg(points)
                                  : tr("quick; %1").arg(points);
    case vision::FlowMethod::disMedium:
        return tr("slowest and finest; %1").arg(points);
    }
    return {};
}

QString FinderNames::explanation(const vision::ContactRung& finder) {
    if (finder.paper)
        return tr("As in the published work: dense flow in a picture of 512 \u00d7 288, and the "
                  "mean of the points that moved");
    QString preset;
    switch (finder.method) {
    case vision::FlowMethod::dots:
        return tr("Each printed dot is followed in the whole picture. The default.");
    case vision::FlowMethod::disUltrafast:
        preset = tr("the quickest and coarsest");
        break;
    case vision::FlowMethod::disFast:
        preset = tr("a quick one");
        break;
    case vision::FlowMethod::disMedium:
        preset = tr("the slowest and finest");
        break;
    }
    QString text = finder.scale < 1.0
                       ? tr("Dense flow by a preset of OpenCV (%1), in a picture %2 times smaller")
                             .arg(preset, base::significantDigits(1.0 / finder.scale, 2))
                       : tr("Dense flow by a preset of OpenCV (%1), in the whole picture").arg(preset);
    if (finder.changedOnly)
        text += QLatin1Char('\n') + tr("Only where the picture differs from the reference");
    if (finder.warmStart)
        text += QLatin1Char('\n') + tr("Starts from the flow of the previous picture");
    return text;
}

void FinderDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const {
    QStyleOptionViewItem item = option;
    initStyleOption(&item, index);
    const QString title = std::exchange(item.text, {});
    const QStyle* style = item.widget != nullptr ? item.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);
    const bool selected = item.state.testFlag(QStyle::State_Selected);
    const QColor ink = item.palette.color(selected ? QPalette::HighlightedText : QPalette::Text);
    const QColor grey = selected ? ink : item.palette.color(QPalette::PlaceholderText);
    const QFont small = base::sized(item.font, base::kSmallText);
    const int gap = QFontMetrics(item.font).height() / 2;
    const QRect room = item.rect.adjusted(gap, gap / 4, -gap, -gap / 4);
    const QRect upper(room.left(), room.top(), room.width(), QFontMetrics(item.font).height());
    painter->save();
    painter->setFont(item.font);
    painter->setPen(ink);
    painter->drawText(upper, Qt::AlignLeft | Qt::AlignVCenter, title);
    painter->setFont(small);
    painter->setPen(grey);
    painter->drawText(upper, Qt::AlignRight | Qt::AlignVCenter, index.data(kCode).toString());
    painter->drawText(room.adjusted(0, upper.height(), 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                      index.data(kCost).toString());
    painter->restore();
}

QSize FinderDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    QStyleOptionViewItem item = option;
    initStyleOption(&item, index);
    const QFontMetrics usual(item.font);
    const QFontMetrics small(base::sized(item.font, base::kSmallText));
    const int gap = usual.height() / 2;
    const int upper =
        usual.horizontalAdvance(item.text) + 2 * gap + small.horizontalAdvance(index.data(kCode).toString());
    const int lower = small.horizontalAdvance(index.data(kCost).toString());
    return {std::max(upper, lower) + 2 * gap, usual.height() + small.height() + gap / 2};
}

} // namespace teleta::camera
