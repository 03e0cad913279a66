// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/chrome/empty_state.h"
#include "widgets/chrome/source_chooser.h"

#include <QPalette>
#include <QSize>
#include <QStringList>
#include <QTimer>

#include <optional>
#include <utility>
#include <vector>

namespace teleta::chrome {
class DemoList;
class FirstSteps;
class RecentList;
} // namespace teleta::chrome

namespace teleta::console {

class StartPictures;

/// Shown while nothing is open: buttons, the first steps, what was open before, and cards of scenes, studies
/// and patterns. Pictures are made while it is seen. Thread: GUI.
class StartPage : public chrome::EmptyState {
    Q_OBJECT

public:
    explicit StartPage(QWidget* parent = nullptr);

    void setCards(const std::vector<chrome::SourceChooser::Demo>& cards);
    /// Files that were opened before, the newest first.
    void setRecent(const QStringList& files);
    [[nodiscard]] chrome::RecentList& recent() { return *m_recent; }
    [[nodiscard]] chrome::FirstSteps& firstSteps() { return *m_steps; }
    void retranslate();
    /// Its cards become small before it is higher than its room, whatever the sentence above them needs.
    [[nodiscard]] bool hasHeightForWidth() const override { return false; }

signals:
    /// The place of a card.
    void cardRequested(const QString& place);
    void demoRequested();
    void handbookRequested();
    void openRecordingRequested();
    void openListRequested();

protected:
    bool event(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void requestPictures();
    void askAgain();
    void shareRoom();

    chrome::FirstSteps* m_steps;
    chrome::RecentList* m_recent;
    chrome::DemoList* m_cards;
    StartPictures* m_pictures;
    QTimer m_ask; ///< for pictures
    QStringList m_places;
    QStringList m_files;
    std::optional<std::pair<QSize, QPalette>> m_askedFor; ///< of the pictures, of these places and files
};

} // namespace teleta::console
