// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/base/console_settings.h"

#include <QObject>
#include <QString>

class QMenu;
class QWidget;

namespace teleta::console {

class OperateDocks;

/// The layouts of the docks that people have given a name: to save, choose and delete them. One that was
/// saved with other docks than there are now is restored as far as it goes. Thread: GUI.
class LayoutsMenu : public QObject {
    Q_OBJECT

public:
    /// window: parent of dialogs, and owner.
    LayoutsMenu(OperateDocks& docks, ConsoleSettings& settings, QWidget* window);

    /// Adds the action that maximises a dock, and a menu of the layouts.
    void fill(QMenu& view);

    /// Saves the present layout; one of this name is replaced. Blanks at the ends of a name do not count, and
    /// no name is saved under nothing.
    void save(const QString& name);
    void choose(const QString& name);
    void remove(const QString& name);

signals:
    /// A layout could not be restored; the default one is shown.
    void notRestored(const QString& name);

private:
    void askForName();
    void list(QMenu& menu);

    OperateDocks& m_docks;
    ConsoleSettings& m_settings;
    QWidget* m_window;
};

} // namespace teleta::console
