// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/start/start_page.h"

#include "app/console/start/start_pictures.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/chrome/start/demo_card.h"
#include "widgets/chrome/start/demo_list.h"
#include "widgets/chrome/start/first_steps.h"
#include "widgets/chrome/start/recent_list.h"

#include <QPushButton>
#include <QStandardPaths>

#include <algorithm>

namespace teleta::console {

namespace {

/// The page is whole before scenes are run for its pictures.
constexpr int kPicturesAfter_ms = 1000;
/// A page that is lower has low cards for the first steps.
constexpr double kLowPage_em = 44.0;
/// One that is even lower has no headline; one with files above the cards has none as soon as it is low.
constexpr double kLowestPage_em = 41.0;

} // namespace

StartPage::StartPage(QWidget* parent)
    : EmptyState(base::Icon::sensor, parent)
    , m_steps(new chrome::FirstSteps(this))
    , m_recent(new chrome::RecentList(this))
    , m_cards(new chrome::DemoList(this))
    , m_pictures(new StartPictures(QStandardPaths::writableLocation(QStandardPaths::CacheLocation) +
                                       QStringLiteral("/scenes"),
                                   this)) {
    const auto add = [this](const char* name, auto requested) {
        QPushButton* button = addAction({}, {});
        button->setObjectName(QLatin1String(name));
        connect(button, &QPushButton::clicked, this, requested);
    };
    add("openDemo", &StartPage::demoRequested);
    add("openRecording", &StartPage::openRecordingRequested);
    add("openList", &StartPage::openListRequested);
    add("firstSteps", &StartPage::handbookRequested);
    setMore(m_steps);
    setMore(m_recent);
    setMore(m_cards);
    m_steps->hide();
    connect(m_cards, &chrome::DemoList::demoRequested, this, &StartPage::cardRequested);
    m_ask.setSingleShot(true);
    m_ask.setInterval(kPicturesAfter_ms);
    connect(&m_ask, &QTimer::timeout, this, &StartPage::requestPictures);
    connect(m_pictures, &StartPictures::made, m_cards, &chrome::DemoList::setPicture);
    connect(m_pictures, &StartPictures::made, m_recent, &chrome::RecentList::setPicture);
    base::onChange(this, [this] { m_ask.start(); }, {QEvent::PaletteChange});
}

void StartPage::setCards(const std::vector<chrome::SourceChooser::Demo>& cards) {
    m_cards->setDemos(cards);
    m_places.clear();
    for (const chrome::SourceChooser::Demo& card : cards)
        m_places << card.path;
    askAgain();
}

void StartPage::setRecent(const QStringList& files) {
    m_recent->setFiles(files);
    m_files = files.mid(0, chrome::RecentList::kFiles);
    askAgain();
}

void StartPage::askAgain() {
    m_askedFor.reset();
    m_ask.start();
}

void StartPage::requestPictures() {
    if (!isVisible())
        return; // asked for again when it is shown
    const QSizeF size = QSizeF(chrome::DemoCard::kPicture_em) * base::em(this, 1) * devicePixelRatioF();
    const std::pair wanted(size.toSize(), palette());
    if (m_askedFor != wanted) {
        m_askedFor = wanted;
        QStringList places = m_files + m_places;
        // What takes a moment only comes before scenes that are run.
        std::ranges::stable_partition(
            places, [](const QString& place) { return !place.endsWith(QLatin1String(".toml")); });
        m_pictures->request(places, wanted.first, wanted.second);
    }
    m_pictures->resume();
}

void StartPage::showEvent(QShowEvent* event) {
    EmptyState::showEvent(event);
    m_ask.start();
}

void StartPage::hideEvent(QHideEvent* event) {
    EmptyState::hideEvent(event);
    m_ask.stop();
    m_pictures->pause();
}

void StartPage::resizeEvent(QResizeEvent* event) {
    shareRoom();
    EmptyState::resizeEvent(event);
}

bool StartPage::event(QEvent* event) {
    if (event->type() == QEvent::LayoutRequest) // files have come, or are gone
        shareRoom();
    return EmptyState::event(event);
}

void StartPage::shareRoom() {
    const bool isLow = height() < base::em(this, kLowPage_em);
    m_steps->setLow(isLow);
    const bool isLowest = isLow && (!m_recent->isHidden() || height() < base::em(this, kLowestPage_em));
    // What is said of the cards is worth more than the headline.
    setBrief(isLowest || (neededHeight(false) > height() && neededHeight(true) <= height()));
}

void StartPage::retranslate() {
    setTexts(tr("No source"), tr("Open a demo scene to look around, a recording, or a list of sources."));
    setAction("firstSteps", tr("First &steps"), tr("The page of the handbook to begin with (F1)"));
    setAction("openDemo", tr("Open &demo scene"), tr("A simulated arm that touches five materials"));
    setAction("openRecording", tr("&Open recording\u2026"),
              tr("A recording of this program or as MCAP, or recorded frames of an array: CSV, "
                 "NumPy, HDF5, MATLAB, Tekscan"));
    setAction("openList", tr("Open source &list\u2026"), tr("A TOML file that lists scenes and recordings"));
}

} // namespace teleta::console
