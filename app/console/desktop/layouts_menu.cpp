// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/desktop/layouts_menu.h"

#include "app/console/operate/docks/operate_docks.h"
#include "widgets/base/mnemonics.h"

#include <QAction>
#include <QInputDialog>
#include <QMenu>

namespace teleta::console {

LayoutsMenu::LayoutsMenu(OperateDocks& docks, ConsoleSettings& settings, QWidget* window)
    : QObject(window)
    , m_docks(docks)
    , m_settings(settings)
    , m_window(window) {
}

void LayoutsMenu::fill(QMenu& view) {
    QAction* maximise = view.addAction(tr("Ma&ximise the view"), Qt::CTRL | Qt::SHIFT | Qt::Key_M, &m_docks,
                                       &OperateDocks::toggleMaximised);
    maximise->setObjectName(QStringLiteral("maximise"));
    maximise->setCheckable(true);
    maximise->setChecked(!m_docks.maximised().isEmpty());
    maximise->setToolTip(
        tr("Show the view with the focus alone, or all again; a double click on a title does the same"));
    connect(&m_docks, &OperateDocks::maximisedChanged, maximise, &QAction::setChecked);
    QMenu* menu = view.addMenu(tr("La&youts"));
    menu->setObjectName(QStringLiteral("layouts"));
    menu->setToolTipsVisible(true);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { list(*menu); });
    list(*menu);
}

void LayoutsMenu::list(QMenu& menu) {
    // One of its actions may have asked for this.
    for (QMenu* part : menu.findChildren<QMenu*>(Qt::FindDirectChildrenOnly))
        part->deleteLater();
    menu.clear();
    const QStringList names = m_settings.namedLayouts().keys();
    for (const QString& name : names)
        menu.addAction(base::withoutMnemonic(name), this, [this, name] { choose(name); });
    if (!names.isEmpty())
        menu.addSeparator();
    menu.addAction(tr("&Save layout as\u2026"), this, &LayoutsMenu::askForName);
    if (names.isEmpty())
        return;
    QMenu* removal = menu.addMenu(tr("D&elete"));
    for (const QString& name : names)
        removal->addAction(base::withoutMnemonic(name), this, [this, name] { remove(name); });
}

void LayoutsMenu::askForName() {
    auto* dialog = new QInputDialog(m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Save layout"));
    dialog->setLabelText(tr("Name (a layout of the same name is replaced):"));
    dialog->setComboBoxItems(m_settings.namedLayouts().keys());
    dialog->setComboBoxEditable(true);
    connect(dialog, &QInputDialog::textValueSelected, this, &LayoutsMenu::save);
    dialog->open();
}

void LayoutsMenu::save(const QString& name) {
    if (!name.trimmed().isEmpty())
        m_settings.setNamedLayout(name.trimmed(), m_docks.saveLayouts());
}

void LayoutsMenu::choose(const QString& name) {
    if (!m_docks.restoreLayouts(m_settings.namedLayouts().value(name)))
        emit notRestored(name);
}

void LayoutsMenu::remove(const QString& name) {
    m_settings.setNamedLayout(name, {});
}

} // namespace teleta::console
