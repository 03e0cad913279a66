// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/study_panel.h"

#include "widgets/base/on_change.h"
#include "widgets/base/shown_path.h"
#include "widgets/base/theme.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QMenu>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <initializer_list>

namespace teleta::study {

namespace {

constexpr int kSession = Qt::UserRole;

} // namespace

StudyPanel::StudyPanel(QWidget* parent)
    : QWidget(parent) {
    m_open->setMenu(new QMenu(m_open));
    m_name->setFont(base::bold(base::sized(font(), base::kLargeText)));
    m_people->setFont(base::bold(base::sized(font(), base::kTitleText)));
    for (QLabel* label : {m_name, m_folder, m_store, m_protocol}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
    }
    for (QLabel* label : {m_folder, m_store, m_protocol})
        label->setFont(base::sized(font(), base::kSmallText));
    m_folder->setObjectName(QStringLiteral("folder"));
    m_folder->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_list->addAction(m_delete);
    m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_delete->setShortcut(QKeySequence::Delete);
    m_delete->setShortcutContext(Qt::WidgetShortcut);
    m_list->setColumnCount(2);
    m_list->setUniformRowHeights(true);
    m_list->setIndentation(base::em(this, 0.9));
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);

    auto* buttons = new QHBoxLayout;
    base::addWidgets(buttons, {m_new, m_open, m_edit});
    auto* add = new QHBoxLayout;
    add->addWidget(m_id, 1);
    add->addWidget(m_add);
    auto* layout = new QVBoxLayout(this);
    const int margin = base::grid(this, 2);
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->setSpacing(base::grid(this));
    base::addWidgets(layout, {m_name, m_folder, m_store, m_protocol});
    layout->addLayout(buttons);
    layout->addSpacing(base::grid(this));
    layout->addWidget(m_people);
    layout->addWidget(m_list, 1);
    layout->addLayout(add);

    connect(m_new, &QPushButton::clicked, this, &StudyPanel::newRequested);
    connect(m_edit, &QPushButton::clicked, this, &StudyPanel::protocolRequested);
    const auto enrol = [this] {
        const QString id = m_id->text().trimmed();
        if (id.isEmpty() || m_scene.locked)
            return;
        emit enrolRequested(id);
    };
    connect(m_add, &QPushButton::clicked, this, enrol);
    connect(m_id, &QLineEdit::returnPressed, this, enrol);
    connect(m_delete, &QAction::triggered, this, [this] {
        QTreeWidgetItem* item = m_list->currentItem();
        if (item != nullptr && !m_scene.locked)
            emit deleteRequested(
                m_list->indexOfTopLevelItem(item->parent() != nullptr ? item->parent() : item));
    });
    connect(m_list, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (item == nullptr)
            return;
        const QTreeWidgetItem* person = item->parent() != nullptr ? item->parent() : item;
        const int index = m_list->indexOfTopLevelItem(const_cast<QTreeWidgetItem*>(person));
        const int session = item->data(0, kSession).toInt();
        // Queued: the list, which sends this signal, is refilled.
        QMetaObject::invokeMethod(
            this, [this, index, session] { emit sessionChosen(index, session); }, Qt::QueuedConnection);
    });
    base::keepTranslated(this, &StudyPanel::retranslate);
    base::onChange(this,
                   [this] {
                       fillList();
                       refresh();
                   },
                   {QEvent::PaletteChange});
}

void StudyPanel::askForName() {
    m_id->setFocus(Qt::OtherFocusReason);
}

void StudyPanel::clearName(const QString& id) {
    if (m_id->text().trimmed() == id)
        m_id->clear();
}

void StudyPanel::setScene(const PanelScene& scene) {
    if (scene == m_scene)
        return;
    const bool newPeople = scene.participants != m_scene.participants || scene.chosen != m_scene.chosen;
    m_scene = scene;
    if (newPeople)
        fillList();
    refresh();
}

void StudyPanel::refresh() {
    m_name->setText(m_scene.name);
    m_folder->setText(base::fromHome(m_scene.folder));
    m_folder->setToolTip(m_scene.folder);
    base::setTextColour(m_folder, palette().color(QPalette::PlaceholderText));
    const bool usable = m_scene.storeProblem.isEmpty();
    const base::StatusColours& status = base::statusColours(palette());
    m_store->setVisible(!m_scene.store.isEmpty());
    m_store->setText(usable ? tr("\u25cf On the server: %1").arg(m_scene.store)
                     : m_scene.storeAway
                         ? tr("\u2717 Server unreachable: %1").arg(m_scene.storeProblem)
                         : tr("\u2717 The study cannot be used: %1").arg(m_scene.storeProblem));
    base::setTextColour(m_store, usable ? status.live : status.lost);
    m_protocol->setText(m_scene.protocol);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_list, m_new, m_open, m_add})
        widget->setEnabled(!m_scene.locked);
    m_delete->setEnabled(!m_scene.locked && !m_scene.participants.empty());
    m_id->setReadOnly(m_scene.locked); // it keeps the keyboard
    const bool real = m_scene.mode != Mode::simulated;
    m_id->setVisible(real);
    m_add->setVisible(real);
}

void StudyPanel::fillList() {
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    const base::StatusColours& colours = base::statusColours(palette());
    for (std::size_t p = 0; p < m_scene.participants.size(); ++p) {
        const ParticipantLine& person = m_scene.participants[p];
        // Over both columns: the order of the conditions would leave the sessions no room for their names.
        auto* top = new QTreeWidgetItem(
            m_list,
            {person.order.isEmpty()
                 ? person.id
                 : tr("%1: %2", "participant, order of the conditions").arg(person.id, person.order)});
        top->setFirstColumnSpanned(true);
        int next = -1;
        for (std::size_t s = 0; s < person.sessions.size(); ++s) {
            const SessionLine& session = person.sessions[s];
            auto* item = new QTreeWidgetItem(top, {session.name, session.state});
            item->setData(0, kSession, static_cast<int>(s));
            item->setToolTip(0, session.name);
            item->setToolTip(1, tr("%1 of %2 trials", "kept").arg(session.kept).arg(session.planned));
            if (session.finished)
                item->setForeground(1, colours.live);
            else if (session.interrupted)
                item->setForeground(1, colours.stale);
            if (!session.finished && next < 0)
                next = static_cast<int>(s);
            if (m_scene.chosen == std::pair(static_cast<int>(p), static_cast<int>(s))) {
                top->setExpanded(true);
                m_list->setCurrentItem(item);
            }
        }
        top->setData(0, kSession, std::max(next, 0));
    }
}

void StudyPanel::retranslate() {
    m_new->setText(tr("&New\u2026"));
    m_new->setToolTip(tr("Create a new study"));
    m_open->setText(tr("&Open\u2026"));
    m_open->setToolTip(tr("Open another study"));
    m_open->menu()->clear();
    m_open->menu()->addAction(tr("The &folder of a study\u2026"), this, &StudyPanel::openRequested);
    m_open->menu()->addAction(tr("A study on a &server\u2026"), this, &StudyPanel::openServerRequested);
    m_edit->setText(tr("Pro&tocol\u2026"));
    m_edit->setToolTip(tr("View the protocol, or make another one from it"));
    m_people->setText(tr("Participants"));
    m_delete->setText(tr("&Delete the participant\u2026"));
    m_list->setHeaderLabels({tr("Session"), tr("State")});
    m_list->setAccessibleName(tr("Participants and their sessions"));
    m_id->setPlaceholderText(tr("Name of a new participant, for example P07"));
    m_id->setAccessibleName(tr("Name of a new participant"));
    m_add->setText(tr("A&dd"));
    m_add->setToolTip(tr("Enrol this participant"));
    fillList();
    refresh();
}

} // namespace teleta::study
