// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/base/console_settings.h"
#include "app/console/plot/plot_layout.h"

#include <QMenu>
#include <QString>

#include <functional>

namespace teleta::console {

/// The layouts of the plot that people have given a name: to save, choose and delete them. Thread: GUI.
class PlotLayoutsMenu : public QMenu {
    Q_OBJECT

public:
    /// now: the layout that is saved.
    PlotLayoutsMenu(ConsoleSettings& settings, std::function<PlotLayout()> now, QWidget* parent);

    /// Blanks at the ends of a name do not count, and no name is saved under nothing; one of this name is
    /// replaced.
    void save(const QString& name);
    void choose(const QString& name);

signals:
    void chosen(const PlotLayout& layout);
    /// It is not one that this version can read.
    void notRestored(const QString& name);

private:
    void list();
    void askForName();

    ConsoleSettings& m_settings;
    std::function<PlotLayout()> m_now;
};

} // namespace teleta::console
