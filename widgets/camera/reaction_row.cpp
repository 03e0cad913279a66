// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/reaction_row.h"

#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

namespace teleta::camera {

namespace {

using Doing = pipeline::CarrierReport::Doing;

} // namespace

ReactionRow::ReactionRow(QWidget* parent)
    : QWidget(parent)
    , m_mayReact(new QCheckBox(this))
    , m_line(new QLabel(this)) {
    m_mayReact->setObjectName(QStringLiteral("cameraMayReact"));
    m_line->setObjectName(QStringLiteral("arm"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(base::grid(this));
    layout->addWidget(m_mayReact);
    layout->addWidget(m_line, 1);
    connect(m_mayReact, &QCheckBox::clicked, this, &ReactionRow::mayReactChanged);
    base::keepTranslated(this, &ReactionRow::retranslate);
    set(std::nullopt, false);
    base::onChange(this, &ReactionRow::showTexts, {QEvent::PaletteChange});
}

void ReactionRow::set(const std::optional<pipeline::CarrierReport>& arm, bool mayReact) {
    m_arm = arm;
    setVisible(arm.has_value());
    const QSignalBlocker blocked(m_mayReact);
    m_mayReact->setChecked(mayReact);
    showTexts();
}

void ReactionRow::showTexts() {
    if (!m_arm) {
        m_line->clear();
        return;
    }
    const base::StatusColours& colours = base::statusColours(palette());
    const auto show = [this](const QString& text, const QColor& colour) {
        m_line->setText(text);
        base::setTextColour(m_line, colour);
    };
    const int contact = m_arm->contact;
    switch (m_arm->doing) {
    case Doing::stands:
        show(contact != 0 ? tr("The arm has retreated from contact %1.").arg(contact)
                          : tr("The arm is at rest."),
             palette().color(QPalette::WindowText));
        break;
    case Doing::retreats:
        show(tr("The arm is retreating from contact %1.").arg(contact), colours.lost);
        break;
    case Doing::follows:
        show(tr("The arm follows contact %1.").arg(contact), colours.live);
        break;
    case Doing::held:
        show(m_mayReact->isChecked() ? tr("The arm is held.")
                                     : tr("The arm is held. Tick the box to let it react again."),
             colours.stale);
        break;
    }
}

void ReactionRow::retranslate() {
    m_mayReact->setText(tr("The arm may r&eact"));
    m_mayReact->setToolTip(
        tr("Off: the arm does not react to touch. STOP unticks this; tick it again to let the arm react."));
    showTexts();
}

} // namespace teleta::camera
