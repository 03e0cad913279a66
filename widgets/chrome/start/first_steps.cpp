// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chrome/start/first_steps.h"

#include "widgets/base/compose.h"
#include "widgets/base/icons.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/chrome/start/demo_card.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace teleta::chrome {

namespace {

struct StepCard {
    const char* name;
    base::Icon icon;
};
constexpr std::array<StepCard, 3> kStepCards{
    {{"touch", base::Icon::operate}, {"pattern", base::Icon::patterns}, {"study", base::Icon::study}}};

} // namespace

QStringList FirstSteps::names() {
    QStringList names;
    for (const StepCard& step : kStepCards)
        names << QLatin1String(step.name);
    return names;
}

FirstSteps::FirstSteps(QWidget* parent)
    : QWidget(parent)
    , m_title(new QLabel(this))
    , m_hide(base::named<QToolButton>("hideFirstSteps", this)) {
    m_title->setFont(base::bold(base::sized(font(), base::kTitleText)));
    m_hide->setAutoRaise(true);
    m_hide->setIcon(base::themeIcon(base::Icon::close));
    m_hide->setFocusPolicy(Qt::StrongFocus);
    auto* head = new QHBoxLayout;
    head->addWidget(m_title);
    head->addStretch(1);
    head->addWidget(m_hide);
    auto* row = new QHBoxLayout;
    row->setSpacing(base::grid(this, base::kGroup));
    for (std::size_t i = 0; i < kSteps; ++i) {
        m_cards[i] = new DemoCard(kStepCards[i].icon, {}, {}, this);
        m_cards[i]->setObjectName(QLatin1String(kStepCards[i].name));
        connect(m_cards[i], &DemoCard::clicked, this,
                [this, i] { emit stepRequested(QLatin1String(kStepCards[i].name)); });
        row->addWidget(m_cards[i], 1);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(base::grid(this, base::kGroup), 0, base::grid(this, base::kGroup), 0);
    layout->setSpacing(base::grid(this, base::kTight));
    layout->addLayout(head);
    layout->addLayout(row);
    connect(m_hide, &QToolButton::clicked, this, &FirstSteps::hideRequested);
    base::keepTranslated(this, &FirstSteps::retranslate);
}

void FirstSteps::setDone(const QStringList& names) {
    for (DemoCard* card : m_cards)
        card->setStep(names.contains(card->objectName()) ? DemoCard::Step::done : DemoCard::Step::open);
}

void FirstSteps::setLow(bool low) {
    for (DemoCard* card : m_cards)
        card->setSize(low ? DemoCard::Size::small : DemoCard::Size::large);
}

void FirstSteps::retranslate() {
    m_title->setText(tr("First steps"));
    m_hide->setToolTip(tr("Hide the first steps; the handbook has them"));
    m_hide->setAccessibleName(tr("Hide the first steps"));
    m_cards[0]->setTexts(tr("Touch something"),
                         tr("A simulated arm touches five materials: contact, force, stiffness"));
    m_cards[1]->setTexts(tr("Say it with a pattern"), tr("Open a built-in pattern and play it with Space"));
    m_cards[2]->setTexts(tr("Watch a study"),
                         tr("Simulated participants answer, and the confusion matrix fills"));
}

} // namespace teleta::chrome
