// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/study_command.h"

#include "app/cli/command_io.h"
#include "app/cli/interruption.h"
#include "app/cli/validators.h"
#include "backend/study/rehearsal.h"
#include "backend/study/study_store.h"

#include <QCoreApplication>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <utility>
#include <vector>

namespace teleta::cli {

namespace {

struct StudyText {
    Q_DECLARE_TR_FUNCTIONS(StudyCommand)
};

std::string help(const char* text) {
    return StudyText::tr(text).toStdString();
}

} // namespace

QString StudyCommand::summary() const {
    return StudyText::tr("Rehearse a user study with simulated participants, or go on with one");
}

const char* StudyCommand::example() const {
    return "teleta study rehearse --participants 6 --seed 1 --out study";
}

void StudyCommand::declare(CLI::App& app) {
    app.require_subcommand(1);
    declareRehearse(app);
    declareResume(app);
}

void StudyCommand::declareRehearse(CLI::App& app) {
    m_rehearse = app.add_subcommand(
        "rehearse",
        help(QT_TRANSLATE_NOOP("StudyCommand", "Run simulated participants through a whole study")));
    m_rehearse
        ->add_option("protocol", m_protocolPath,
                     help(QT_TRANSLATE_NOOP("StudyCommand", "Protocol of the study; otherwise the paper's")))
        ->type_name("PROTOCOL.toml");
    m_rehearse
        ->add_option("--participants", m_participants,
                     help(QT_TRANSLATE_NOOP("StudyCommand", "How many take part")))
        ->type_name("N")
        ->capture_default_str()
        ->check(between(1, 10'000));
    m_rehearse
        ->add_option("--seed", m_seed,
                     help(QT_TRANSLATE_NOOP("StudyCommand", "Seed of all orders and answers")))
        ->type_name("S")
        ->capture_default_str();
    m_rehearse
        ->add_option(
            "--lapses", m_lapses,
            help(QT_TRANSLATE_NOOP("StudyCommand", "Share of the trials in which nothing is answered")))
        ->type_name("P")
        ->capture_default_str()
        ->check(between(0, 1));
    m_rehearse
        ->add_option("--out", m_outFolder, help(QT_TRANSLATE_NOOP("StudyCommand", "Folder of the new study")))
        ->type_name("DIR")
        ->required();
    declareJson(*m_rehearse, m_json);
}

void StudyCommand::declareResume(CLI::App& app) {
    m_resume = app.add_subcommand(
        "resume", help(QT_TRANSLATE_NOOP("StudyCommand", "Go on with a rehearsal that was interrupted")));
    m_resume
        ->add_option("study", m_studyFolder, help(QT_TRANSLATE_NOOP("StudyCommand", "Folder of the study")))
        ->type_name("DIR")
        ->required();
    declareJson(*m_resume, m_json);
}

core::Expected<void> StudyCommand::run() {
    return m_rehearse->parsed() ? runRehearse() : runResume();
}

core::Expected<void> StudyCommand::runRehearse() const {
    const core::Expected<study::Protocol> protocol =
        m_protocolPath.empty() ? study::paperProtocol() : study::readProtocol(m_protocolPath);
    if (!protocol)
        return core::Unexpected(protocol.error());
    study::StudyHead head;
    head.protocol = *protocol;
    head.seed = m_seed;
    head.mode = study::Mode::simulated;
    head.plannedParticipants = m_participants;
    head.lapses = m_lapses;
    head.created = QDateTime::currentDateTimeUtc();
    head.appVersion = QCoreApplication::applicationVersion().toStdString();
    core::Expected<study::StudyStore> store = study::StudyStore::create(m_outFolder, head);
    if (!store)
        return core::Unexpected(store.error());
    return goOn(*store);
}

core::Expected<void> StudyCommand::runResume() const {
    core::Expected<study::StudyStore> store = study::StudyStore::open(m_studyFolder);
    if (!store)
        return core::Unexpected(store.error());
    return goOn(*store);
}

core::Expected<void> StudyCommand::goOn(study::StudyStore& store) const {
    const core::Expected<study::RehearsalProgress> progress =
        study::rehearse(store, [](std::size_t) { return !interrupted(); });
    if (!progress)
        return core::Unexpected(progress.error());
    if (progress->interrupted)
        return core::Unexpected(interruption());
    const study::StudyHead& head = store.head();
    if (m_json)
        return printDocument({{"study", store.folder()},
                              {"protocol", head.protocol.name},
                              {"mode", study::toString(head.mode)},
                              {"seed", std::to_string(head.seed)},
                              {"participants", progress->participants},
                              {"trials", progress->trialsBefore + progress->trials},
                              {"trials_before", progress->trialsBefore}});
    const std::vector<std::pair<QString, QString>> fields{
        {StudyText::tr("Study"), QString::fromStdString(store.folder())},
        {StudyText::tr("Protocol"), QString::fromStdString(head.protocol.name)},
        {StudyText::tr("Seed"), QString::number(head.seed)},
        {StudyText::tr("Simulated participants"), QString::number(progress->participants)},
        {StudyText::tr("Trials"), QString::number(progress->trialsBefore + progress->trials)},
        {StudyText::tr("Of them kept before"), QString::number(progress->trialsBefore)}};
    return printFields(fields);
}

} // namespace teleta::cli
