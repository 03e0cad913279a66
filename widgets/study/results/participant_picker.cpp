// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/results/participant_picker.h"

#include "widgets/base/mnemonics.h"
#include "widgets/base/theme.h"

#include <QCheckBox>
#include <QMenu>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QWidgetAction>

#include <utility>

namespace teleta::study {

namespace {

constexpr qsizetype kNamed = 3;
constexpr double kHighestList_em = 30.0;

} // namespace

ParticipantPicker::ParticipantPicker(QWidget* parent)
    : QPushButton(parent) {
    m_column->setSizeConstraint(QLayout::SetMinAndMaxSize);
    auto* area = new QScrollArea;
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
    area->setMaximumHeight(base::em(this, kHighestList_em));
    area->setWidget(m_panel);
    // A menu would close with each tick.
    auto* list = new QWidgetAction(this);
    list->setDefaultWidget(area);
    auto* menu = new QMenu(this);
    menu->addAction(list);
    setMenu(menu);
}

void ParticipantPicker::setChoices(const QStringList& participants, const QString& noneText) {
    const QStringList before = m_chosen;
    m_noneText = noneText;
    if (m_all != participants || m_column->count() == 0) {
        m_all = participants;
        while (QLayoutItem* item = m_column->takeAt(0)) {
            delete item->widget();
            delete item;
        }
        auto* none = new QCheckBox(m_panel);
        m_column->addWidget(none);
        connect(none, &QCheckBox::clicked, this, [this] { choose({}); });
        for (const QString& id : participants) {
            auto* box = new QCheckBox(base::withoutMnemonic(id), m_panel);
            box->setObjectName(id);
            m_column->addWidget(box);
            connect(box, &QCheckBox::toggled, this, [this, id](bool ticked) {
                QStringList now = m_chosen;
                if (ticked)
                    now << id;
                else
                    now.removeAll(id);
                choose(now);
            });
        }
    }
    choose(before);
    show();
}

void ParticipantPicker::choose(const QStringList& participants) {
    QStringList chosen;
    for (const QString& id : std::as_const(m_all)) {
        if (participants.contains(id))
            chosen << id;
    }
    const bool changes = chosen != m_chosen;
    m_chosen = chosen;
    show();
    if (changes)
        emit chosenChanged();
}

void ParticipantPicker::show() {
    for (int row = 0; row < m_column->count(); ++row) {
        auto* box = static_cast<QCheckBox*>(m_column->itemAt(row)->widget());
        const QSignalBlocker quiet(box);
        box->setChecked(row == 0 ? m_chosen.isEmpty() : m_chosen.contains(m_all[row - 1]));
        if (row == 0)
            box->setText(m_noneText);
    }
    setText(m_chosen.isEmpty() ? m_noneText : describe(m_chosen));
}

QString ParticipantPicker::describe(const QStringList& participants) {
    return participants.size() <= kNamed
               ? participants.join(QStringLiteral(", "))
               : tr("%n participant(s)", nullptr, static_cast<int>(participants.size()));
}

} // namespace teleta::study
