// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/study_start.h"

#include "widgets/base/controls/picture_card.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/study/study_pictures.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <vector>

namespace teleta::study {

namespace {

constexpr double kCard_em = 14.0; ///< least width
constexpr double kMostCard_em = 26.0;
constexpr double kLeastPicture_em = 4.0;
constexpr double kPictureShape = 0.6; ///< greatest height, of its width

} // namespace

StudyStart::StudyStart(QWidget* parent)
    : QScrollArea(parent)
    , m_title(new QLabel(this))
    , m_sentence(new QLabel(this))
    , m_grid(new QGridLayout)
    , m_continue(new base::PictureCard(this))
    , m_rehearsal(new base::PictureCard(this))
    , m_published(new base::PictureCard(this))
    , m_own(new base::PictureCard(this)) {
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    const int margin = base::grid(this, base::kGroup);
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->setSpacing(base::grid(this));
    m_title->setFont(base::bold(base::sized(font(), base::kLargeText)));
    for (QLabel* label : {m_title, m_sentence}) {
        label->setAlignment(Qt::AlignCenter);
        label->setWordWrap(true);
    }
    m_grid->setSpacing(margin);
    auto* middle = new QHBoxLayout;
    middle->addStretch(1);
    middle->addLayout(m_grid);
    middle->addStretch(1);
    layout->addStretch(2);
    layout->addWidget(m_title);
    layout->addWidget(m_sentence);
    layout->addSpacing(base::grid(this));
    layout->addLayout(middle);
    layout->addStretch(3);
    setWidget(content);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    viewport()->setAutoFillBackground(false);
    content->setAutoFillBackground(false);

    const auto add = [this](base::PictureCard* card, const char* name, auto requested) {
        QPushButton* button = card->addButton(name);
        connect(button, &QPushButton::clicked, this, requested);
        return button;
    };
    add(m_continue, "continueStudyButton", [this] {
        if (m_last)
            emit lastRequested(m_last->folder);
    });
    add(m_rehearsal, "watchRehearsal", &StudyStart::rehearsalRequested);
    add(m_published, "publishedProtocolButton", &StudyStart::publishedRequested);
    add(m_own, "newStudyButton", &StudyStart::newRequested);
    add(m_own, "openStudyButton", &StudyStart::openRequested);
    add(m_own, "serverStudyButton", &StudyStart::openServerRequested);
    m_rehearsal->setPicture(paintSessionFlow);
    m_published->setPicture(paintPublishedMatrix);
    m_own->setPicture(paintProtocolPage);
    m_continue->setPicture([this](QPainter& painter, const QRectF& rect, const QPalette& palette) {
        if (m_last)
            paintProgress(painter, rect, palette, m_last->participants);
    });
    setLast({});
    base::keepTranslated(this, &StudyStart::retranslate);
}

void StudyStart::setLast(const std::optional<PanelScene>& last) {
    m_last = last;
    m_continue->setVisible(last.has_value());
    // The one button of the view that is filled.
    findChild<QPushButton*>(QStringLiteral("continueStudyButton"))->setDefault(last.has_value());
    findChild<QPushButton*>(QStringLiteral("watchRehearsal"))->setDefault(!last);
    describeLast();
    arrange();
    m_continue->update();
}

void StudyStart::describeLast() {
    if (!m_last)
        return;
    int finished = 0;
    int planned = 0;
    QString interrupted;
    for (const ParticipantLine& person : m_last->participants) {
        planned += static_cast<int>(person.sessions.size());
        for (const SessionLine& session : person.sessions) {
            finished += session.finished ? 1 : 0;
            if (session.interrupted)
                interrupted = tr("%1 stopped in \u201c%2\u201d after %3 of %4 trials.", "a participant")
                                  .arg(person.id, session.name)
                                  .arg(session.kept)
                                  .arg(session.planned);
        }
    }
    QString state = interrupted;
    if (state.isEmpty())
        state = planned == 0 ? tr("Nobody has taken part yet.")
                             : tr("%1 of %2 sessions are finished.").arg(finished).arg(planned);
    if (m_last->mode == Mode::simulated)
        state = tr("A rehearsal. %1").arg(state);
    m_continue->setTexts(tr("Go on with \u201c%1\u201d", "a study").arg(m_last->name), state);
}

void StudyStart::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    arrange();
}

void StudyStart::arrange() {
    std::vector<base::PictureCard*> cards;
    for (base::PictureCard* card : {m_continue, m_rehearsal, m_published, m_own}) {
        m_grid->removeWidget(card);
        if (card != m_continue || m_last)
            cards.push_back(card);
    }
    const int count = static_cast<int>(cards.size());
    const int gap = m_grid->horizontalSpacing();
    const QMargins margins = widget()->layout()->contentsMargins();
    const QSize room = viewport()->size().shrunkBy(margins);
    int least = base::em(this, kCard_em);
    for (const base::PictureCard* card : cards)
        least = std::max(least, card->leastWidth());
    int columns = std::clamp((room.width() + gap) / (least + gap), 1, count);
    if (columns == 3 && count == 4) // not one alone in a row
        columns = 2;
    const int rows = (count + columns - 1) / columns;
    const int width = std::min(base::em(this, kMostCard_em), (room.width() - (columns - 1) * gap) / columns);
    int texts = 0;
    for (base::PictureCard* card : cards) {
        card->setFixedWidth(width);
        texts = std::max(texts, card->textHeight(width));
    }
    const int head =
        m_title->sizeHint().height() + m_sentence->heightForWidth(room.width()) + base::grid(this, 4.0);
    const int each = (room.height() - head - (rows - 1) * gap) / rows - texts;
    const int height =
        std::clamp(each, base::em(this, kLeastPicture_em), static_cast<int>(kPictureShape * width));
    for (int i = 0; i < count; ++i) {
        cards[static_cast<std::size_t>(i)]->setPictureHeight(height);
        m_grid->addWidget(cards[static_cast<std::size_t>(i)], i / columns, i % columns);
    }
}

void StudyStart::retranslate() {
    m_title->setText(tr("No study is open"));
    m_sentence->setText(tr("Run the published user study, or one of your own: from the first practice trial "
                           "to confusion matrices and ANOVA."));
    m_rehearsal->setTexts(tr("Watch a rehearsal"),
                          tr("Simulated participants go through the whole study, and its results build up."));
    m_published->setTexts(
        tr("The published protocol"),
        tr("Six shapes and five stiffnesses, static and dynamic: read every step, and begin "
           "a study with it."));
    m_own->setTexts(tr("Your own study"),
                    tr("Begin with a protocol of yours, or go on with a study in a folder or on a server."));
    const auto name = [this](const char* button, const QString& text, const QString& toolTip) {
        auto* found = findChild<QPushButton*>(QLatin1String(button));
        found->setText(text);
        found->setToolTip(toolTip);
        found->setMinimumWidth(found->fontMetrics().horizontalAdvance(text) + base::grid(this, 2.0));
    };
    name("continueStudyButton", tr("Go on"), tr("Open the study that was open last"));
    name("watchRehearsal", tr("Watch"), tr("Simulated participants go through the whole study"));
    name("publishedProtocolButton", tr("Read it"), tr("Stimuli, practice and test trials of the paper"));
    name("newStudyButton", tr("New\u2026"), tr("With the paper's protocol or your own"));
    name("openStudyButton", tr("Open\u2026"), tr("The folder of a study"));
    name("serverStudyButton", tr("Server\u2026"), tr("A study that several stations share"));
    describeLast();
    arrange();
}

} // namespace teleta::study
