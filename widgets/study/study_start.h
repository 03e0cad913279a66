// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/study/study_panel.h"

#include <QScrollArea>
#include <QString>

#include <optional>

class QGridLayout;

namespace teleta::base {
class PictureCard;
}

namespace teleta::study {

/// Shown while no study is open: a card for each way to begin, and one for the study that was open last.
/// The cards share the room, and scroll where it is too small. Thread: GUI.
class StudyStart : public QScrollArea {
    Q_OBJECT

public:
    explicit StudyStart(QWidget* parent = nullptr);

    /// The study that was open last; empty: there is none to go on with.
    void setLast(const std::optional<PanelScene>& last);

signals:
    void rehearsalRequested();
    void publishedRequested();
    void newRequested();
    void openRequested();
    void openServerRequested();
    /// The folder of the study that was open last.
    void lastRequested(const QString& folder);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void arrange();
    void retranslate();
    void describeLast();

    std::optional<PanelScene> m_last;
    QLabel* m_title;
    QLabel* m_sentence;
    QGridLayout* m_grid;
    base::PictureCard* m_continue;
    base::PictureCard* m_rehearsal;
    base::PictureCard* m_published;
    base::PictureCard* m_own;
};

} // namespace teleta::study
