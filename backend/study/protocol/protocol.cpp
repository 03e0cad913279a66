// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/protocol.h"

#include "backend/core/data/toml_table.h"
#include "backend/study/protocol/identifier.h"
#include "backend/study/protocol/protocol_text.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QString>
#include <QStringList>

#include <set>
#include <utility>

namespace teleta::study {

namespace {

using core::NumberRange;
using core::TomlTable;

struct ProtocolText {
    Q_DECLARE_TR_FUNCTIONS(StudyProtocol)
};

constexpr long long kMostRepetitions = 1000;
constexpr long long kMostTrials = 100'000;
constexpr char kBuiltIn[] = ":/studies";
constexpr char kPaper[] = "teleta.toml";

PhaseSettings readPhase(TomlTable table) {
    PhaseSettings phase;
    phase.repetitions = static_cast<std::size_t>(table.integer("repetitions", 0, kMostRepetitions));
    phase.feedback = table.boolean("feedback", false);
    phase.diagram = table.boolean("diagram", false);
    table.finish();
    return phase;
}

RestSettings readRest(TomlTable table) {
    constexpr double kLongest_s = 3600.0;
    RestSettings rest;
    rest.everyTrials = static_cast<std::size_t>(table.integer("every_trials", 1, kMostTrials));
    rest.atLeast_s = table.number("at_least_s", NumberRange::between(0.0, kLongest_s), 0.0);
    table.finish();
    return rest;
}

StudyTask readTask(TomlTable& table, std::set<std::string>& usedIds) {
    StudyTask task;
    task.id = readIdentifier(table, "id", usedIds);
    task.name = table.text("name", task.id);
    std::set<std::string> conditions;
    for (TomlTable& entry : table.tables("condition", 1)) {
        task.conditions.push_back(readIdentifier(entry, "id", conditions));
        entry.finish();
    }
    std::set<std::string> letters;
    for (TomlTable& entry : table.tables("pattern", 2)) {
        if (task.patterns.size() == kMostPatterns)
            entry.fail("letter", ProtocolText::tr("there are too many patterns").toStdString(),
                       ProtocolText::tr("at most %1, one digit each").arg(kMostPatterns).toStdString());
        StudyPattern pattern;
        pattern.letter = readIdentifier(entry, "letter", letters);
        // These words have another meaning in the columns stimulus and response.
        if (pattern.letter == "NA" || pattern.letter == "NONE")
            entry.fail("letter",
                       ProtocolText::tr("\"%1\" means no answer").arg(pattern.letter.c_str()).toStdString(),
                       ProtocolText::tr("another letter").toStdString());
        pattern.name = entry.text("name", pattern.letter);
        if (entry.has("stimulus")) {
            TomlTable files = entry.table("stimulus");
            for (const std::string& condition : task.conditions) {
                if (files.has(condition))
                    pattern.files[condition] = files.text(condition);
            }
            files.finish();
        }
        entry.finish();
        task.patterns.push_back(std::move(pattern));
    }
    table.finish();
    return task;
}

core::Expected<Protocol> readDocument(const core::TomlDocument& document) {
    TomlTable root = document.root();
    Protocol protocol;
    protocol.name = root.text("name");
    protocol.description = root.text("description", "-");
    protocol.stimulus_s = root.number("stimulus_s", {.low = 0.0, .high = 3600.0, .lowOpen = true});
    protocol.responseLimit_s = root.number("response_limit_s", {.low = 0.0, .high = 3600.0, .lowOpen = true});
    protocol.window = root.choice("response_window", {"from_onset", "from_end"}) == 0
                          ? ResponseWindow::fromOnset
                          : ResponseWindow::fromEnd;
    protocol.replays = static_cast<std::size_t>(root.integer("replays", 0, kMostRepetitions, 0));
    protocol.order = root.choice("order", {"full_random", "blocked_random"}) == 0
                         ? OrderMethod::fullRandom
                         : OrderMethod::blockedRandom;
    protocol.practice = readPhase(root.table("practice"));
    protocol.test = readPhase(root.table("test"));
    if (root.has("pause"))
        protocol.rest = readRest(root.table("pause"));
    TomlTable noise = root.table("masking_noise");
    protocol.noiseColour = noise.choice("colour", {"pink", "none"}) == 0 ? "pink" : "none";
    protocol.noise_dBA = noise.number("level_dBA", NumberRange::between(0.0, 85.0), 0.0);
    noise.finish();
    std::set<std::string> ids;
    for (TomlTable& task : root.tables("task", 1))
        protocol.tasks.push_back(readTask(task, ids));
    protocol.questionnaires = readQuestionnaires(root);
    root.finish();
    if (const std::optional<core::Error>& error = document.firstError())
        return core::Unexpected(*error);
    return protocol;
}

} // namespace

std::size_t Protocol::testTrials() const {
    std::size_t trials = 0;
    for (const StudyTask& task : tasks)
        trials += task.patterns.size() * task.conditions.size() * test.repetitions;
    return trials;
}

core::Expected<Protocol> parseProtocol(std::string_view text, const std::string& file) {
    TELETA_TRY(const core::TomlDocument document, core::TomlDocument::parse(text, file));
    core::Expected<Protocol> protocol = readDocument(document);
    if (protocol)
        protocol->source = text;
    return protocol;
}

core::Expected<Protocol> readProtocol(const std::string& path) {
    QFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::ReadOnly))
        return core::Unexpected(core::Error{
            file.exists() ? core::ErrorKind::ioFailed : core::ErrorKind::notFound,
            ProtocolText::tr("cannot open the protocol: %1").arg(file.errorString()).toStdString(),
            {},
            {path}});
    core::Expected<Protocol> protocol = parseProtocol(file.readAll().toStdString(), path);
    if (!protocol)
        return protocol;
    const QDir folder = QFileInfo(file.fileName()).absoluteDir();
    bool moved = false;
    for (StudyTask& task : protocol->tasks) {
        for (StudyPattern& pattern : task.patterns) {
            for (auto& [condition, name] : pattern.files) {
                const QString given = QString::fromStdString(name);
                moved = moved || QDir::isRelativePath(given);
                name = QDir::cleanPath(folder.absoluteFilePath(given)).toStdString();
            }
        }
    }
    // Stored protocols are read again in another folder.
    if (moved)
        protocol->source = protocolText(*protocol);
    return protocol;
}

core::Expected<Protocol> paperProtocol() {
    return readProtocol(std::string(kBuiltIn) + '/' + kPaper);
}

core::Expected<std::vector<Protocol>> builtInProtocols() {
    QStringList files =
        QDir(QLatin1String(kBuiltIn)).entryList({QStringLiteral("*.toml")}, QDir::Files, QDir::Name);
    files.removeAll(QLatin1String(kPaper));
    files.prepend(QLatin1String(kPaper));
    std::vector<Protocol> protocols;
    for (const QString& file : files) {
        TELETA_TRY(Protocol protocol, readProtocol(std::string(kBuiltIn) + '/' + file.toStdString()));
        protocols.push_back(std::move(protocol));
    }
    return protocols;
}

std::vector<PlannedSession> planSessions(const Protocol& protocol, std::uint64_t studySeed,
                                         std::size_t enrolment) {
    const std::uint64_t participantSeed = derivedSeed(studySeed, enrolment);
    std::vector<PlannedSession> sessions;
    for (std::size_t t = 0; t < protocol.tasks.size(); ++t) {
        const StudyTask& task = protocol.tasks[t];
        const auto square = williamsSquare(task.conditions.size());
        const std::size_t row = enrolment % square.size();
        for (std::size_t position = 0; position < task.conditions.size(); ++position) {
            PlannedSession session;
            session.task = t;
            session.condition = square[row][position];
            session.conditionPosition = position;
            session.sequenceRow = row;
            session.seed = derivedSeed(participantSeed, sessions.size());
            const auto order = [&](std::size_t repetitions, std::uint64_t part) {
                return trialOrder(protocol.order, task.patterns.size(), repetitions,
                                  derivedSeed(session.seed, part));
            };
            session.practice = order(protocol.practice.repetitions, kSeedOfPractice);
            session.test = order(protocol.test.repetitions, kSeedOfTest);
            sessions.push_back(std::move(session));
        }
    }
    return sessions;
}

} // namespace teleta::study
