// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/source_chooser.h"

#include "widgets/base/compose.h"
#include "widgets/base/icons.h"
#include "widgets/base/mnemonics.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QHBoxLayout>
#include <QSignalBlocker>

namespace teleta::chrome {

SourceChooser::SourceChooser(QWidget* parent)
    : QWidget(parent) {
    m_box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_box->setMinimumContentsLength(18);
    m_open->setPopupMode(QToolButton::InstantPopup);
    m_open->setMenu(m_menu);
    m_open->setFocusPolicy(Qt::TabFocus);
    m_close->setAutoRaise(true);
    m_close->setFocusPolicy(Qt::TabFocus);
    m_close->setEnabled(false);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(base::grid(this, 0.5));
    base::addWidgets(layout, {m_box, m_badge, m_close, m_open});

    connect(m_box, &QComboBox::activated, this,
            [this] { emit sourceChosen(m_box->currentData().toULongLong()); });
    connect(m_close, &QToolButton::clicked, this,
            [this] { emit closeRequested(m_box->currentData().toULongLong()); });
    base::keepTranslated(this, &SourceChooser::retranslate);
    base::onChange(this,
                   [this] {
                       rebuildMenu();
                       m_close->setIcon(base::themeIcon(base::Icon::close));
                   },
                   {QEvent::PaletteChange});
}

void SourceChooser::setSources(const std::vector<Source>& sources, std::uint64_t active) {
    m_sources = sources;
    const QSignalBlocker blocked(m_box);
    m_box->clear();
    base::Provenance shown = base::Provenance::live;
    for (const Source& source : sources) {
        const QString provenance = base::provenanceText(source.provenance);
        QString text = source.name;
        if (source.opening)
            text = tr("%1 (opening\u2026)", "a source").arg(text);
        m_box->addItem(base::themeIcon(source.provenance == base::Provenance::simulated ? base::Icon::scene
                                       : source.provenance == base::Provenance::recorded ||
                                               source.provenance == base::Provenance::recordedSimulation
                                           ? base::Icon::recording
                                           : base::Icon::sensor),
                       text, QVariant::fromValue<qulonglong>(source.key));
        if (!provenance.isEmpty()) // in the list; the badge stands beside the one that is shown
            m_box->setItemData(m_box->count() - 1,
                               tr("%1 \u2014 %2", "a source and whether its data are simulated or recorded")
                                   .arg(source.name, provenance),
                               Qt::AccessibleTextRole);
        if (source.key == active) {
            m_box->setCurrentIndex(m_box->count() - 1);
            shown = source.provenance;
        }
    }
    m_badge->setProvenance(shown);
    m_box->setAccessibleDescription(base::provenanceText(shown)); // the closed box does not speak its item's
    m_box->setEnabled(!sources.empty());
    m_close->setEnabled(!sources.empty());
    if (sources.empty())
        m_box->addItem(tr("No source"));
}

void SourceChooser::setDemos(const std::vector<Demo>& demos) {
    m_demos = demos;
    rebuildMenu();
}

void SourceChooser::setRecent(const QStringList& paths) {
    m_recent = paths;
    rebuildMenu();
}

void SourceChooser::setRecentNames(const RecentNames& names) {
    m_recentNames = names;
    rebuildMenu();
}

void SourceChooser::rebuildMenu() {
    m_menu->clear();
    QString group;
    for (const Demo& demo : m_demos) {
        if (demo.group != group)
            m_menu->addSection(group = demo.group);
        QAction* action = m_menu->addAction(base::themeIcon(base::Icon::scene), demo.title);
        action->setToolTip(demo.description);
        connect(action, &QAction::triggered, this, [this, path = demo.path] { emit demoRequested(path); });
    }
    m_menu->setToolTipsVisible(true);
    m_menu->addSeparator();
    QAction* recording =
        m_menu->addAction(base::themeIcon(base::Icon::recording), tr("Open &recording\u2026"), this,
                          &SourceChooser::openRecordingRequested);
    recording->setToolTip(
        tr("A recording of this program or as MCAP, or recorded frames of an array: CSV, NumPy, "
           "HDF5, MATLAB, Tekscan"));
    m_menu->addAction(base::themeIcon(base::Icon::scene), tr("Open &scene file\u2026"), this,
                      &SourceChooser::openSceneRequested);
    QAction* camera = m_menu->addAction(base::themeIcon(base::Icon::sensor), tr("Open &camera\u2026"), this,
                                        &SourceChooser::openCameraRequested);
    camera->setToolTip(tr("A camera in the soft tube, or a video of one, with its calibration"));
    QAction* arm = m_menu->addAction(base::themeIcon(base::Icon::sensor), tr("Open &arm\u2026"), this,
                                     &SourceChooser::openArmRequested);
    arm->setToolTip(tr("An arm over ROS 2, described in a file"));
    m_menu->addAction(base::themeIcon(base::Icon::sensor), tr("Open source &list\u2026"), this,
                      &SourceChooser::openListRequested);
    if (m_recent.isEmpty())
        return;
    m_menu->addSeparator();
    const QList<RecentName> names = recentNamesOf(m_recent, m_recentNames);
    for (qsizetype i = 0; i < names.size(); ++i) {
        const QString& path = m_recent[i];
        QAction* action = m_menu->addAction(base::withoutMnemonic(names[i].oneLine()));
        action->setToolTip(path);
        connect(action, &QAction::triggered, this, [this, path] { emit recentRequested(path); });
    }
}

void SourceChooser::retranslate() {
    m_box->setAccessibleName(tr("Source"));
    m_box->setToolTip(tr("The source that the views show"));
    m_open->setText(tr("Ope&n"));
    m_open->setToolTip(tr("Open a simulated scene or a recording"));
    m_close->setIcon(base::themeIcon(base::Icon::close));
    m_close->setAccessibleName(tr("Close source"));
    m_close->setToolTip(tr("Close this source"));
    rebuildMenu();
    setSources(m_sources, m_box->currentData().toULongLong());
}

} // namespace teleta::chrome
