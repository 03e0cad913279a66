// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/study/protocol/protocol.h"

#include "backend/core/data/input_file.h"
#include "backend/core/failure.h"
#include "backend/core/keys/toml_depth.h"
#include "backend/core/keys/toml_keys.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "backend/study/protocol/identifier.h"
#include "backend/study/protocol/level_sequence.h"
#include "backend/study/protocol/level_task_keys.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QString>
#include <QStringList>

#include <set>
#include <utility>

namespace teleta::study {

namespace {

using core::Keys;
using core::Need;
using core::NumberRange;

struct ProtocolText {
    Q_DECLARE_TR_FUNCTIONS(StudyProtocol)
};

constexpr long long kMostRepetitions = 1000;
constexpr long long kMostTrials = 100'000;
constexpr double kLongest_s = 3600.0;
constexpr double kLongestPulse_ms = 1000.0;
constexpr char kBuiltIn[] = ":/studies";
constexpr char kPaper[] = "teleta.toml";

void describePhase(Keys& keys, PhaseSettings& phase) {
    keys.whole("repetitions", phase.repetitions, {0, kMostRepetitions},
               "Trials of each pattern; 0 leaves the phase out");
    keys.flag("feedback", phase.feedback, "Show the right answer after each trial");
    keys.flag("diagram", phase.diagram, "Show the pictures of the patterns during the trials");
}

void describeRest(Keys& keys, RestSettings& rest) {
    keys.whole("every_trials", rest.everyTrials, {1, kMostTrials}, "Completed trials between two rests");
    keys.number("at_least_s", rest.atLeast_s, NumberRange::between(0.0, kLongest_s), "Shortest rest",
                Need::optional);
}

void describePattern(Keys& keys, StudyPattern& pattern, std::set<std::string>& letters,
                     const std::vector<std::string>& conditions) {
    describeIdentifier(keys, "letter", pattern.letter, letters,
                       "The pattern's letter in results; not `NA` or `NONE`");
    // These words stand for something else in the columns stimulus and response.
    if (pattern.letter == "NA" || pattern.letter == "NONE")
        keys.refuse("letter",
                    ProtocolText::tr("\"%1\" means no answer").arg(pattern.letter.c_str()).toStdString(),
                    ProtocolText::tr("another letter").toStdString());
    pattern.name = pattern.letter;
    keys.text("name", pattern.name, "What the participant reads; otherwise the letter", Need::optional);
    keys.table(
        "stimulus", "Pattern files by condition; otherwise the built-in patterns", Need::optional,
        [&](Keys& files) {
            for (const std::string& condition : conditions) {
                std::string file;
                files.text(
                    condition.empty() ? "CONDITION" : condition, file,
                    "File of the tactile pattern, relative to the protocol, or the id of a built-in pattern",
                    Need::optional);
                if (!file.empty())
                    pattern.files[condition] = file;
            }
        });
}

void describePatterns(Keys& keys, StudyTask& task) {
    std::set<std::string> letters;
    keys.tables("pattern", task.patterns, 2, "Patterns to be told apart, at most 9",
                [&](Keys& entry, std::vector<StudyPattern>& patterns, std::size_t i) {
                    if (i == kMostPatterns)
                        entry.refuse(
                            "letter", ProtocolText::tr("there are too many patterns").toStdString(),
                            ProtocolText::tr("at most %1, one digit each").arg(kMostPatterns).toStdString());
                    describePattern(entry, patterns[i], letters, task.conditions);
                });
}

void describeTask(Keys& keys, StudyTask& task, std::set<std::string>& usedIds, const Protocol& protocol) {
    describeIdentifier(keys, "id", task.id, usedIds, "The task's name in results");
    task.name = task.id;
    keys.text("name", task.name, "What the participant reads; otherwise the id", Need::optional);
    std::set<std::string> conditions;
    keys.tables("condition", task.conditions, 1, "Conditions, whose order is balanced between participants",
                [&](Keys& entry, std::vector<std::string>& ids, std::size_t i) {
                    describeIdentifier(entry, "id", ids[i], conditions, "The condition's name in results");
                    std::optional<double> reference;
                    entry.number("reference", reference, NumberRange::positive(),
                                 "Level to compare with under this condition, of designs with levels");
                    if (reference)
                        task.references[ids[i]] = *reference;
                });
    keys.choose("design", static_cast<std::size_t>(task.design),
                {{"identification", "Which of the patterns was it?"},
                 {"yes_no", "Was it there?"},
                 {"interval", "In which of 2 to 4 intervals was it?"},
                 {"same_different", "Were the two intervals the same?"},
                 {"compare", "Which of the two intervals had more?"}},
                "What a trial asks", Need::optional, [&](Keys& same, std::size_t chosen) {
                    task.design = static_cast<Design>(chosen);
                    if (task.design != Design::identification)
                        describeLevelTask(same, task, protocol);
                    else if (task.references.empty())
                        describePatterns(same, task);
                    else
                        same.refuse("condition", ProtocolText::tr("patterns have no reference").toStdString(),
                                    ProtocolText::tr("conditions without reference").toStdString());
                });
}

void describeTrigger(Keys& keys, core::TriggerSettings& trigger) {
    using Kind = core::TriggerSettings::Kind;
    keys.choose("kind", static_cast<std::size_t>(trigger.kind),
                {{"none", "No triggers"},
                 {"serial", "A byte on a serial line"},
                 {"osc", "A message of Open Sound Control by UDP"}},
                "Where triggers go", Need::required, [&trigger](Keys& same, std::size_t chosen) {
                    trigger.kind = static_cast<Kind>(chosen);
                    if (trigger.kind == Kind::serial) {
                        same.text("device", trigger.device, "The serial port, such as /dev/ttyUSB0");
                        same.number("pulse_ms", trigger.pulse_ms, NumberRange::between(0.0, kLongestPulse_ms),
                                    "Until the byte 0 follows; 0: it does not", Need::optional);
                    } else if (trigger.kind == Kind::osc) {
                        same.text("host", trigger.host, "Name or address of the receiver", Need::optional);
                        same.whole("port", trigger.port, {1, 65535}, "Its UDP port", Need::optional);
                    }
                });
}

} // namespace

void Protocol::describeKeys(Keys& keys) {
    const NumberRange time = NumberRange::positiveUpTo(kLongest_s);
    keys.text("name", name, "Name of the protocol");
    description = "-";
    keys.text("description", description, "What is studied", Need::optional);
    keys.tables("author", authors, 0, "Who is named as an author of exported data",
                [](Keys& entry, std::vector<std::string>& names, std::size_t i) {
                    entry.text("name", names[i], "The author's name");
                });
    keys.number("stimulus_s", stimulus_s, time, "How long a stimulus lasts");
    keys.number("response_limit_s", responseLimit_s, time, "Time to answer");
    keys.choice("response_window", window, {"from_onset", "from_end"},
                "Whether that time begins with the stimulus or at its end");
    keys.whole("replays", replays, {0, kMostRepetitions}, "How often a stimulus may be felt again",
               Need::optional);
    keys.choice("order", order, {"full_random", "blocked_random"},
                "Whether all trials are shuffled together or repetition by repetition");
    keys.table("practice", "Trials before the test", Need::required,
               [this](Keys& table) { describePhase(table, practice); });
    keys.table("test", "Trials that count", Need::required,
               [this](Keys& table) { describePhase(table, test); });
    keys.table("pause", "Rests within a session; without it there are none", Need::optional,
               [this](Keys& table) { describeRest(table, rest); });
    keys.table("masking_noise", "Noise in the participant's headphones", Need::required, [this](Keys& table) {
        table.choose("colour", noiseColour == "none" ? 1 : 0, {"pink", "none"}, "Kind of noise",
                     Need::required,
                     [this](Keys&, std::size_t chosen) { noiseColour = chosen == 0 ? "pink" : "none"; });
        table.number("level_dBA", noise_dBA, NumberRange::between(0.0, 85.0),
                     "Level, as noted in the results", Need::optional);
    });
    std::set<std::string> ids;
    keys.tables("task", tasks, 1, "What participants have to tell apart",
                [&](Keys& table, std::vector<StudyTask>& all, std::size_t i) {
                    describeTask(table, all[i], ids, *this);
                });
    describeQuestionnaires(keys, questionnaires);
    keys.table("trigger", "Marks of events for other recorders; without it there are none", Need::optional,
               [this](Keys& table) { describeTrigger(table, trigger); });
    keys.table("recording", "What this program records of a session", Need::optional, [this](Keys& table) {
        table.flag("sessions", recordSessions,
                   "Record the bracelet and all open sources of each session into a file");
    });
    describeExclusions(keys, exclusions);
}

double StudyTask::referenceOf(const std::string& condition) const {
    const auto own = references.find(condition);
    return own == references.end() ? levels.reference : own->second;
}

std::size_t Protocol::testTrials() const {
    std::size_t trials = 0;
    for (const StudyTask& task : tasks)
        trials += task.conditions.size() *
                  (task.design == Design::identification
                       ? task.patterns.size() * test.repetitions
                       : task.levels.tracks.size() * mostTrialsOfTrack(task.levels) * test.repetitions);
    return trials;
}

core::Expected<Protocol> parseProtocol(std::string_view text, const std::string& file) {
    core::Expected<Protocol> protocol =
        core::TomlDocument::parse(text, file).and_then(core::readKeys<Protocol>);
    if (protocol)
        protocol->source = text;
    return protocol;
}

core::Expected<Protocol> readProtocol(const std::string& path) {
    TELETA_TRY(const std::string text, core::readFile(path, core::kMostTomlBytes));
    core::Expected<Protocol> protocol = parseProtocol(text, path);
    if (!protocol)
        return protocol;
    const QDir folder = QFileInfo(QString::fromStdString(path)).absoluteDir();
    bool moved = false;
    const auto resolve = [&](std::string& name) {
        const QString given = QString::fromStdString(name);
        moved = moved || QDir::isRelativePath(given);
        name = QDir::cleanPath(folder.absoluteFilePath(given)).toStdString();
    };
    for (StudyTask& task : protocol->tasks) {
        if (!task.levels.file.empty())
            resolve(task.levels.file);
        for (StudyPattern& pattern : task.patterns) {
            for (auto& [condition, name] : pattern.files) {
                if (pattern::findBuiltIn(name) == nullptr)
                    resolve(name);
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

core::Expected<Protocol> readNamedProtocol(const std::string& name) {
    const std::string builtIn = std::string(kBuiltIn) + '/' + name + ".toml";
    const bool isFile = QFileInfo::exists(QString::fromStdString(name));
    return readProtocol(!isFile && QFileInfo::exists(QString::fromStdString(builtIn)) ? builtIn : name);
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
            if (task.design == Design::identification) {
                session.practice = order(protocol.practice.repetitions, kSeedOfPractice);
                session.test = order(protocol.test.repetitions, kSeedOfTest);
                session.practiceTrials = session.practice.size();
                session.testTrials = session.test.size();
            } else {
                session.practiceTrials = mostTrials(protocol, session, Phase::practice);
                session.testTrials = mostTrials(protocol, session, Phase::test);
            }
            sessions.push_back(std::move(session));
        }
    }
    return sessions;
}

} // namespace teleta::study
