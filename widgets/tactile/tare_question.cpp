// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tactile/tare_question.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>
#include <utility>

namespace teleta::tactile {

namespace {

struct TareText {
    Q_DECLARE_TR_FUNCTIONS(TareQuestion)
};

} // namespace

LoadedTaxels loadedTaxels(const pipeline::TouchSnapshot& snapshot, double threshold_N) {
    const auto least = static_cast<float>(threshold_N);
    return {.usable = static_cast<std::size_t>(std::ranges::count(snapshot.dead, std::uint8_t{0})),
            .loaded = static_cast<std::size_t>(
                std::ranges::count_if(snapshot.load_N, [least](float load) { return load >= least; }))};
}

void askToTare(QWidget* parent, const LoadedTaxels& taxels, std::function<void()> tare) {
    if (taxels.loaded == 0) {
        tare();
        return;
    }
    auto* ask =
        new QMessageBox(QMessageBox::Question, TareText::tr("Tare the array"),
                        TareText::tr("%1 of %2 taxels are under load.").arg(taxels.loaded).arg(taxels.usable),
                        QMessageBox::Cancel, parent);
    ask->setObjectName(QStringLiteral("tareUnderLoad"));
    ask->setInformativeText(
        TareText::tr("What presses on the array during the tare counts as no load afterwards. Tare "
                     "only if nothing touches the array and the loads shown are drift."));
    auto* yes = ask->addButton(TareText::tr("&Tare under load"), QMessageBox::AcceptRole);
    ask->setDefaultButton(QMessageBox::Cancel);
    ask->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(yes, &QPushButton::clicked, parent, std::move(tare));
    ask->open();
}

} // namespace teleta::tactile
