// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tactile/heatmap_content.h"

#include "backend/core/data/column_unit.h"
#include "widgets/base/numbers/number_format.h"

#include <QCoreApplication>

#include <algorithm>

namespace teleta::tactile {

const contact::Contact* HeatmapContent::contactAt(std::size_t index) const {
    if (snapshot.labels.empty() || snapshot.labels[index] == 0)
        return nullptr;
    const auto found =
        std::ranges::find(snapshot.contacts, snapshot.labels[index], &contact::Contact::region);
    return found == snapshot.contacts.end() ? nullptr : &*found;
}

bool isConsistent(const pipeline::TouchSnapshot& snapshot) {
    const std::size_t taxels = snapshot.layout.taxels();
    return taxels > 0 && snapshot.load_N.size() == taxels &&
           (snapshot.dead.empty() || snapshot.dead.size() == taxels) &&
           (snapshot.labels.empty() || snapshot.labels.size() == taxels);
}

QString taxelText(const HeatmapContent& content, const Taxel& taxel) {
    constexpr double kMillimetres = 1e3;
    const std::size_t index = content.index(taxel);
    const core::ArrayLayout& layout = content.snapshot.layout;
    const QString load =
        content.isDead(index)
            ? QCoreApplication::translate("HeatmapView", "dead")
            : base::withUnit(base::threeDigits(static_cast<double>(content.snapshot.load_N[index])),
                             content.unit());
    const contact::Contact* contact = content.contactAt(index);
    const QString identity = contact
                                 ? QCoreApplication::translate("HeatmapView", "contact #%1").arg(contact->id)
                                 : QCoreApplication::translate("HeatmapView", "no contact");
    return QCoreApplication::translate("HeatmapView", "row %1, column %2   %3   %4   x %5 mm, y %6 mm")
        .arg(taxel.row)
        .arg(taxel.column)
        .arg(load, identity, base::threeDigits(layout.x_m(taxel.column) * kMillimetres),
             base::threeDigits(layout.y_m(taxel.row) * kMillimetres));
}

QString frameCsv(const HeatmapContent& content) {
    const core::ArrayLayout& layout = content.snapshot.layout;
    QString csv = QStringLiteral("row,column,x_m,y_m,load_%1,dead,contact_id\n")
                      .arg(QString::fromStdString(core::columnUnit(content.unit().toStdString())));
    if (!content.valid)
        return csv;
    constexpr int kDoubleDigits = 15;
    constexpr int kFloatDigits = 9;
    for (int row = 0; row < layout.rows; ++row)
        for (int column = 0; column < layout.columns; ++column) {
            const std::size_t i = content.index({row, column});
            const contact::Contact* contact = content.contactAt(i);
            csv +=
                QStringLiteral("%1,%2,%3,%4,%5,%6,%7\n")
                    .arg(row)
                    .arg(column)
                    .arg(QString::number(layout.x_m(column), 'g', kDoubleDigits),
                         QString::number(layout.y_m(row), 'g', kDoubleDigits),
                         QString::number(static_cast<double>(content.snapshot.load_N[i]), 'g', kFloatDigits))
                    .arg(content.isDead(i) ? 1 : 0)
                    .arg(contact ? contact->id : 0);
        }
    return csv;
}

} // namespace teleta::tactile
