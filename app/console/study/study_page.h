// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/study/running/noise_player.h"
#include "app/console/study/running/participant_placement.h"
#include "app/console/study/study_bracelet.h"
#include "app/console/study/study_controller.h"
#include "app/console/study/study_leaving.h"
#include "app/console/study/study_planning.h"
#include "app/console/study/study_scenes.h"
#include "widgets/chrome/message_bar.h"

#include <QString>
#include <QStringList>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>

class QComboBox;
class QLabel;
class QStackedWidget;
class QTabWidget;

namespace teleta::study {
class ConfusionView;
class ParticipantWindow;
class PlanPanel;
class ResultsView;
class SessionPanel;
class StudyPanel;
class StudyStart;
} // namespace teleta::study

namespace teleta::console {

/// The Study page: protocol and participants on the left, the session in the middle, the live confusion
/// matrix on the right, and the participant's window. Files are read on pool threads. Thread: GUI.
class StudyPage : public QWidget {
    Q_OBJECT

public:
    StudyPage(BraceletService& station, core::StopSwitch& stop,
              StudyController::SteadyClock clock = core::steadyNow_ns,
              StudyController::WallClock utcNow = QDateTime::currentDateTimeUtc, QWidget* parent = nullptr);

    ~StudyPage() override;

    /// Opens a study's folder, the address of a study on a server (postgresql://..), or a protocol to create
    /// one from.
    void open(const QString& path);
    /// Opens a simulated study, or creates one with the paper's protocol, and rehearses it. folder: empty for
    /// a new one among the user's documents.
    void watchRehearsal(const QString& folder = {});
    /// The same with the study of a scene.
    void watchScene(const study::StudyScene& scene, std::uint64_t seed, const QString& folder = {});
    /// The folder of the study that was open last, offered while none is open; empty: there is none.
    void setLast(const QString& folder);
    /// See StudyLeaving.
    [[nodiscard]] bool isSettled() const { return m_leaving->isSettled(); }
    void whenSettled(std::function<void()> goOn) { m_leaving->whenSettled(std::move(goOn)); }
    /// Names of views for bringForward().
    [[nodiscard]] static QStringList viewNames();
    void bringForward(const QString& view);
    /// Window for screenshots of the page if it is not the console's; otherwise null.
    [[nodiscard]] QWidget* forwardWindow() const;
    /// To be called 30 times a second.
    void tick();

    [[nodiscard]] StudyController& controller() { return m_controller; }
    [[nodiscard]] chrome::MessageBar& messages() { return *m_messages; }
    [[nodiscard]] study::ParticipantWindow& participantWindow() { return *m_participant; }

signals:
    /// Something could not be opened.
    void openFailed(const teleta::core::Error& error);

private:
    void build();
    void connectViews();
    void retranslate();
    void refresh();
    void showParticipant();
    void showSession();
    void showPlan();
    void doNextStep();
    void askForNewStudy(study::Mode mode, std::optional<study::Protocol> protocol = {});
    void askForStudy();
    void askForDeletion(int participant);
    void askForServer();
    void showProtocol(const study::Protocol& protocol);
    void readProtocol(const study::Protocol& protocol);
    void withPaper(std::function<void(const study::Protocol&)> use);
    void askForProtocol();
    void analyse();
    void report(const QString& what, const core::Error& error);
    void tellWhatWasOpened();
    void tellThatNoiseFailed(const core::Error& error);

    StudyController m_controller;
    NoisePlayer m_noise;
    chrome::MessageBar* m_messages;
    QStackedWidget* m_stack;
    study::StudyStart* m_empty;
    QTabWidget* m_tabs;
    study::StudyPanel* m_study;
    study::SessionPanel* m_session;
    study::ConfusionView* m_matrix;
    QComboBox* m_counts;
    QComboBox* m_speed;
    QWidget* m_speedRow;
    QLabel* m_speedLabel;
    std::unique_ptr<study::ParticipantWindow> m_participant;
    ParticipantPlacement m_placement;
    study::ResultsView* m_results;
    study::PlanPanel* m_plan;
    StudyPlanning m_planning;
    StudyBracelet m_bracelet;
    StudyLeaving* m_leaving;
    bool m_outdated = true;   ///< the results lack the latest trials
    bool m_analysing = false; ///< on a pool thread
    QString m_choicesOf;      ///< session whose answers the participant's window shows
    std::size_t m_asked = 0;  ///< QuestionnaireSequence::shown() of the one in the participant's window
    bool m_rehearseWhenOpened = false;
    QString m_last;         ///< folder of the study that was open last
    QString m_noiseProblem; ///< why the noise could not be played the last time
};

} // namespace teleta::console
