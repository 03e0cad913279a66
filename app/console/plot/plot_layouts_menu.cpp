// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/plot/plot_layouts_menu.h"

#include "widgets/base/mnemonics.h"

#include <QInputDialog>

#include <utility>

namespace teleta::console {

PlotLayoutsMenu::PlotLayoutsMenu(ConsoleSettings& settings, std::function<PlotLayout()> now, QWidget* parent)
    : QMenu(parent)
    , m_settings(settings)
    , m_now(std::move(now)) {
    connect(this, &QMenu::aboutToShow, this, &PlotLayoutsMenu::list);
}

void PlotLayoutsMenu::list() {
    for (QMenu* part : findChildren<QMenu*>(Qt::FindDirectChildrenOnly))
        part->deleteLater();
    clear();
    const QStringList names = m_settings.plotLayouts().keys();
    for (const QString& name : names)
        addAction(base::withoutMnemonic(name), this, [this, name] { choose(name); });
    if (!names.isEmpty())
        addSeparator();
    addAction(tr("&Save layout as\u2026"), this, &PlotLayoutsMenu::askForName);
    if (names.isEmpty())
        return;
    QMenu* removal = addMenu(tr("D&elete"));
    for (const QString& name : names)
        removal->addAction(base::withoutMnemonic(name), this,
                           [this, name] { m_settings.setPlotLayout(name, {}); });
}

void PlotLayoutsMenu::askForName() {
    auto* dialog = new QInputDialog(parentWidget());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Save layout"));
    dialog->setLabelText(tr("Name (a layout of the same name is replaced):"));
    dialog->setComboBoxItems(m_settings.plotLayouts().keys());
    dialog->setComboBoxEditable(true);
    connect(dialog, &QInputDialog::textValueSelected, this, &PlotLayoutsMenu::save);
    dialog->open();
}

void PlotLayoutsMenu::save(const QString& name) {
    if (!name.trimmed().isEmpty())
        m_settings.setPlotLayout(name.trimmed(), toJson(m_now()));
}

void PlotLayoutsMenu::choose(const QString& name) {
    if (const auto layout = plotLayoutOf(m_settings.plotLayouts().value(name)))
        emit chosen(*layout);
    else
        emit notRestored(name);
}

} // namespace teleta::console
