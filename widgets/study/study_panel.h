// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/study/protocol/trial.h"
#include "widgets/base/compose.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QString>
#include <QTreeWidget>
#include <QWidget>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace teleta::study {

/// A participant's session in the list.
struct SessionLine {
    QString name;
    QString state; ///< "finished", "interrupted", ..
    std::size_t kept = 0;
    std::size_t planned = 0;
    bool finished = false;
    bool interrupted = false;
    friend bool operator==(const SessionLine&, const SessionLine&) = default;
};

struct ParticipantLine {
    QString id;
    QString order; ///< of the conditions, by the Williams square
    std::vector<SessionLine> sessions;
    friend bool operator==(const ParticipantLine&, const ParticipantLine&) = default;
};

/// What the study panel shows.
struct PanelScene {
    QString name;
    QString folder;
    QString store;          ///< a server; empty: a file in the folder
    QString storeProblem;   ///< why the server cannot be used; empty: no problem
    bool storeAway = false; ///< the server does not answer
    Mode mode = Mode::run;
    QString protocol; ///< some lines
    std::vector<ParticipantLine> participants;
    std::optional<std::pair<int, int>> chosen; ///< participant, session
    bool locked = false; ///< a session is running or the store is busy: the choice is locked
    friend bool operator==(const PanelScene&, const PanelScene&) = default;
};

/// The study: a summary of its protocol, the participants with their sessions. Thread: GUI.
class StudyPanel : public QWidget {
    Q_OBJECT

public:
    explicit StudyPanel(QWidget* parent = nullptr);

    void setScene(const PanelScene& scene);
    /// Moves the keyboard focus to the field for a new participant.
    void askForName();
    /// Clears the field once the participant is enrolled.
    void clearName(const QString& id);
    [[nodiscard]] QTreeWidget* list() const { return m_list; }

signals:
    void newRequested();
    void openRequested();
    void openServerRequested();
    void protocolRequested();
    void enrolRequested(const QString& id);
    void sessionChosen(int participant, int session);
    /// Of the list's menu, or by the key Delete.
    void deleteRequested(int participant);

private:
    void retranslate();
    void refresh();
    void fillList();

    PanelScene m_scene;
    QLabel* m_name = new QLabel(this);
    QLabel* m_folder = new QLabel(this);
    QLabel* m_store = base::named<QLabel>("store", this);
    QLabel* m_protocol = new QLabel(this);
    QPushButton* m_new = new QPushButton(this);
    QPushButton* m_open = new QPushButton(this);
    QPushButton* m_edit = new QPushButton(this);
    QLabel* m_people = new QLabel(this);
    QTreeWidget* m_list = base::named<QTreeWidget>("participants", this);
    QAction* m_delete = base::named<QAction>("deleteParticipant", m_list);
    QLineEdit* m_id = base::named<QLineEdit>("participantId", this);
    QPushButton* m_add = base::named<QPushButton>("addParticipant", this);
};

} // namespace teleta::study
