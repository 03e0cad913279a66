// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/touch/jog/limit_line.h"

#include "backend/arm_model/limit_texts.h"

#include <QStringList>

#include <utility>

namespace teleta::touch {

namespace {

/// Beyond those of the arm.
constexpr std::size_t kSingular = 31;

} // namespace

LimitLine::LimitLine(QWidget* parent)
    : QLabel(parent) {
    setObjectName(QStringLiteral("limits"));
    setWordWrap(true);
    hide();
}

void LimitLine::setActive(std::uint32_t flags) {
    for (std::size_t bit = 0; bit < kSingular; ++bit) {
        if (((flags >> bit) & 1U) != 0)
            m_until[bit].setRemainingTime(kHold_ms);
    }
    refresh();
}

void LimitLine::setSingular(bool singular) {
    if (singular)
        m_until[kSingular].setRemainingTime(kHold_ms);
    refresh();
}

void LimitLine::forget() {
    m_until.fill(QDeadlineTimer());
    refresh();
}

void LimitLine::refresh() {
    std::uint32_t shown = 0;
    for (std::size_t bit = 0; bit < m_until.size(); ++bit) {
        if (!m_until[bit].hasExpired())
            shown |= std::uint32_t{1} << bit;
    }
    if (shown != m_shown)
        show(shown);
}

void LimitLine::retranslate() {
    show(m_shown);
}

void LimitLine::show(std::uint32_t flags) {
    m_shown = flags;
    QStringList sentences;
    if (const QStringList limits = arm_model::limitTexts(flags); !limits.isEmpty())
        sentences << tr("Active limits: %1.").arg(limits.join(QStringLiteral(", ")));
    if ((flags >> kSingular) != 0)
        sentences << tr("Near a singularity: slower.");
    setText(sentences.join(QLatin1Char(' ')));
    setVisible(!sentences.isEmpty());
}

} // namespace teleta::touch
