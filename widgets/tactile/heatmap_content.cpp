// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tactile/heatmap_content.h"

#include "backend/core/data/column_unit.h"
#include "widgets/base/numbers/number_format.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace teleta::tactile {

const contact::Contact* HeatmapContent::contactAt(std::size_t index) const {
    if (snapshot.labels.empty() || snapshot.labels[index] == 0)
        return nullptr;
    const auto found =
        std::ranges::find(snapshot.contacts, snapshot.labels[index], &contact::Contact::region);
    return found == snapshot.contacts.end() ? nullptr : &*found;
}

bool HeatmapContent::isPart(const contact::Contact& contact) const {
    return contact.id > 0 && std::ranges::count(snapshot.contacts, contact.id, &contact::Contact::id) > 1;
}

std::size_t HeatmapContent::contacts() const {
    std::size_t count = 0;
    for (auto at = snapshot.contacts.begin(); at != snapshot.contacts.end(); ++at)
        count += at->id > 0 && std::find_if(
                                   snapshot.contacts.begin(), at,
                                   [&](const contact::Contact& before) { return before.id == at->id; }) != at
                     ? 0
                     : 1;
    return count;
}

bool isConsistent(const pipeline::TouchSnapshot& snapshot) {
    const std::size_t taxels = snapshot.layout.taxels();
    return taxels > 0 && snapshot.load_N.size() == taxels &&
           (snapshot.dead.empty() || snapshot.dead.size() == taxels) &&
           (snapshot.labels.empty() || snapshot.labels.size() == taxels) &&
           (!snapshot.layout.isVector() ||
            (snapshot.shearX_N.size() == taxels && snapshot.shearY_N.size() == taxels));
}

QString taxelText(const HeatmapContent& content, const Taxel& taxel) {
    constexpr double kMillimetres = 1e3;
    const std::size_t index = content.index(taxel);
    const core::TaxelLayout& layout = content.snapshot.layout;
    const auto loadText = [&](float load) {
        return base::withUnit(base::threeDigits(static_cast<double>(load)), content.unit());
    };
    QString load = QCoreApplication::translate("HeatmapView", "dead");
    if (layout.isAbsent(index))
        load = QCoreApplication::translate("HeatmapView", "no taxel");
    else if (!content.isDead(index))
        load = loadText(content.snapshot.load_N[index]);
    if (content.hasShear() && !content.isDead(index))
        load += QStringLiteral("   ") + QCoreApplication::translate("HeatmapView", "shear %1")
                                            .arg(loadText(std::hypot(content.snapshot.shearX_N[index],
                                                                     content.snapshot.shearY_N[index])));
    const contact::Contact* contact = content.contactAt(index);
    QString identity = contact ? QCoreApplication::translate("HeatmapView", "contact #%1").arg(contact->id)
                               : QCoreApplication::translate("HeatmapView", "no contact");
    if (contact && contact->shear) {
        const contact::ShearLoad& shear = *contact->shear;
        const double shear_N = std::hypot(shear.x_N, shear.y_N);
        //: Of a contact: the force along the surface, and it divided by the force into the surface
        identity = QCoreApplication::translate("HeatmapView", "contact #%1 with shear %2, friction %3")
                       .arg(contact->id)
                       .arg(base::withUnit(base::threeDigits(shear_N), content.unit()),
                            base::threeDigits(shear.friction));
    }
    const QString place =
        layout.isGrid()
            ? QCoreApplication::translate("HeatmapView", "row %1, column %2").arg(taxel.row).arg(taxel.column)
            : QCoreApplication::translate("HeatmapView", "taxel %1").arg(taxel.column);
    return QCoreApplication::translate("HeatmapView", "%1   %2   %3   x %4 mm, y %5 mm")
        .arg(place, load, identity, base::threeDigits(layout.x_m(index) * kMillimetres),
             base::threeDigits(layout.y_m(index) * kMillimetres));
}

QString frameCsv(const HeatmapContent& content) {
    const core::TaxelLayout& layout = content.snapshot.layout;
    const QString unit = QString::fromStdString(core::columnUnit(content.unit().toStdString()));
    QString csv = layout.isGrid() ? QStringLiteral("row,column") : QStringLiteral("taxel");
    csv += QStringLiteral(",x_m,y_m,load_%1").arg(unit);
    if (content.hasShear())
        csv += QStringLiteral(",shear_x_%1,shear_y_%1").arg(unit);
    csv += QStringLiteral(",dead,contact_id\n");
    if (!content.valid)
        return csv;
    constexpr int kDoubleDigits = 15;
    constexpr int kFloatDigits = 9;
    const auto loadText = [](float load) {
        return QString::number(static_cast<double>(load), 'g', kFloatDigits);
    };
    const auto columns = static_cast<std::size_t>(layout.grid().columns);
    for (std::size_t i = 0; i < layout.taxels(); ++i) {
        if (layout.isAbsent(i))
            continue;
        QStringList cells;
        if (layout.isGrid())
            cells << QString::number(i / columns);
        cells << QString::number(i % columns) << QString::number(layout.x_m(i), 'g', kDoubleDigits)
              << QString::number(layout.y_m(i), 'g', kDoubleDigits) << loadText(content.snapshot.load_N[i]);
        if (content.hasShear())
            cells << loadText(content.snapshot.shearX_N[i]) << loadText(content.snapshot.shearY_N[i]);
        const contact::Contact* contact = content.contactAt(i);
        cells << QString::number(content.isDead(i) ? 1 : 0) << QString::number(contact ? contact->id : 0);
        csv += cells.join(QLatin1Char(',')) + QLatin1Char('\n');
    }
    return csv;
}

} // namespace teleta::tactile
