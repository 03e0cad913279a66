// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/forms/protocol_summary.h"

#include "widgets/base/rows_html.h"
#include "widgets/study/study_names.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <array>
#include <utility>
#include <vector>

namespace teleta::console {

namespace {

class Summary {
    Q_DECLARE_TR_FUNCTIONS(ProtocolSummary)

public:
    explicit Summary(const study::Protocol& protocol)
        : m_protocol(protocol) {}

    [[nodiscard]] QString html() const {
        QString text =
            QStringLiteral("<h2>%1</h2>").arg(QString::fromStdString(m_protocol.name).toHtmlEscaped());
        text += paragraph(QString::fromStdString(m_protocol.description));
        QStringList authors;
        for (const std::string& author : m_protocol.authors)
            authors << QString::fromStdString(author);
        text += paragraph(authors.join(QStringLiteral("; ")));
        text += base::rowsHtml(
            {{tr("Each trial"), trial()},
             {tr("Practice"), phase(m_protocol.practice)},
             {tr("Test"), phase(m_protocol.test)},
             {tr("Order"), m_protocol.order == study::OrderMethod::fullRandom
                               ? tr("All repetitions together, in random order.")
                               : tr("Each repetition in a random order.")},
             {tr("Rests"), rests()},
             {tr("Masking noise"), noise()},
             {tr("Recording"), m_protocol.recordSessions ? tr("Each session is recorded.") : QString()},
             {tr("Test trials"),
              tr("%n for each participant, at most.", nullptr, static_cast<int>(m_protocol.testTrials()))}});
        for (const study::StudyTask& task : m_protocol.tasks)
            text += QStringLiteral("<h3>%1</h3>").arg(study::displayName(task).toHtmlEscaped()) +
                    base::rowsHtml(taskRows(task));
        std::vector<Row> asked;
        for (const study::Questionnaire& one : m_protocol.questionnaires)
            asked.emplace_back(QString::fromStdString(one.title),
                               when(one.when) + QLatin1Char(' ') +
                                   tr("%n question(s).", nullptr, static_cast<int>(one.items.size())));
        text += section(tr("Questionnaires"), asked);
        std::vector<Row> rules;
        for (const study::ExclusionRule& rule : m_protocol.exclusions)
            rules.emplace_back(QString::fromStdString(rule.id), excluded(rule));
        text += section(tr("What does not count"), rules);
        return text;
    }

private:
    using Row = std::pair<QString, QString>;

    static QString number(double value) { return QLocale().toString(value, 'g', 6); }
    static QString seconds(double value) { return tr("%1 s").arg(number(value)); }
    static QString paragraph(const QString& text) {
        return text.isEmpty() ? QString() : QStringLiteral("<p>%1</p>").arg(text.toHtmlEscaped());
    }
    static QString section(const QString& title, const std::vector<Row>& rows) {
        return rows.empty() ? QString() : QStringLiteral("<h3>%1</h3>").arg(title) + base::rowsHtml(rows);
    }

    [[nodiscard]] QString trial() const {
        QStringList said{tr("The stimulus lasts %1 at most.").arg(seconds(m_protocol.stimulus_s)),
                         (m_protocol.window == study::ResponseWindow::fromOnset
                              ? tr("The answer counts within %1 of its onset.")
                              : tr("The answer counts within %1 of its end."))
                             .arg(seconds(m_protocol.responseLimit_s)),
                         m_protocol.replays == 0 ? tr("It is felt once.")
                                                 : tr("It may be felt again %n time(s).", nullptr,
                                                      static_cast<int>(m_protocol.replays))};
        return said.join(QLatin1Char(' '));
    }

    static QString phase(const study::PhaseSettings& settings) {
        if (settings.repetitions == 0)
            return tr("None.");
        QStringList said{tr("Each stimulus %n time(s).", nullptr, static_cast<int>(settings.repetitions)),
                         settings.feedback ? tr("The right answer is shown after each trial.")
                                           : tr("The right answer is not shown."),
                         settings.diagram ? tr("The pictures of the patterns are in view.")
                                          : tr("The pictures of the patterns are not in view.")};
        return said.join(QLatin1Char(' '));
    }

    [[nodiscard]] QString rests() const {
        if (m_protocol.rest.everyTrials == 0)
            return tr("None.");
        return tr("After every %n trial(s), at least %1.", nullptr,
                  static_cast<int>(m_protocol.rest.everyTrials))
            .arg(seconds(m_protocol.rest.atLeast_s));
    }

    [[nodiscard]] QString noise() const {
        return m_protocol.noiseColour == "none" ? tr("None.")
                                                : tr("Pink, %1 dBA.").arg(number(m_protocol.noise_dBA));
    }

    [[nodiscard]] std::vector<Row> taskRows(const study::StudyTask& task) const {
        QStringList conditions;
        for (const std::string& condition : task.conditions)
            conditions << study::displayCondition(task, condition);
        std::vector<Row> rows{{tr("Conditions"), QLocale().createSeparatedList(conditions)}};
        if (task.design == study::Design::identification) {
            QStringList patterns;
            for (const study::StudyPattern& pattern : task.patterns)
                patterns << QStringLiteral("%1 %2").arg(QString::fromStdString(pattern.letter),
                                                        study::displayName(task, pattern));
            rows.emplace_back(tr("Which was it?"), patterns.join(QStringLiteral(", ")));
            return rows;
        }
        const study::LevelTask& levels = task.levels;
        rows.emplace_back(tr("Question"), study::displayQuestion(task));
        rows.emplace_back(tr("Design"), design(task.design));
        rows.emplace_back(tr("Levels"),
                          tr("%1 to %2 %3, chosen by %4.", "lowest, highest, unit, procedure")
                              .arg(number(levels.range.lowest), number(levels.range.highest),
                                   study::displayUnit(levels.vary), procedure(levels.procedure)));
        rows.emplace_back(tr("Tracks"),
                          tr("%n, interleaved.", nullptr, static_cast<int>(levels.tracks.size())));
        return rows;
    }

    static QString design(study::Design design) {
        switch (design) {
        case study::Design::identification:
            break;
        case study::Design::yesNo:
            return tr("Yes or no: was it there?");
        case study::Design::interval:
            return tr("Intervals: in which one was it?");
        case study::Design::sameDifferent:
            return tr("Same or different?");
        case study::Design::compare:
            return tr("Compare: which one had more?");
        }
        return {};
    }

    static QString procedure(const study::Procedure& procedure) {
        const std::array names{tr("constant stimuli"), tr("a staircase"),
                               tr("a Bayesian procedure (QUEST+)")};
        return names[procedure.index()];
    }

    static QString when(study::QuestionnaireTime time) {
        switch (time) {
        case study::QuestionnaireTime::beforeStudy:
            return tr("Before the first session.");
        case study::QuestionnaireTime::beforeSession:
            return tr("Before each session.");
        case study::QuestionnaireTime::afterSession:
            return tr("After each session.");
        case study::QuestionnaireTime::afterStudy:
            break;
        }
        return tr("After the last session.");
    }

    static QString excluded(const study::ExclusionRule& rule) {
        using study::ExclusionKind;
        const QString value = number(rule.value);
        switch (rule.kind) {
        case ExclusionKind::responseTimeBelow_s:
            return tr("Trials answered earlier than %1.").arg(seconds(rule.value));
        case ExclusionKind::responseTimeAbove_s:
            return tr("Trials answered later than %1.").arg(seconds(rule.value));
        case ExclusionKind::responseTimeMad:
            return tr("Trials whose time is more than %1 MADs from the median.").arg(value);
        case ExclusionKind::deviceFaults:
            return tr("Trials with more than %1 device faults.").arg(value);
        case ExclusionKind::framesMissedAbove:
            return tr("Trials with more than %1 missed frames.").arg(value);
        case ExclusionKind::timeoutsShareAbove:
            return tr("Sessions in which more than %1 % of the trials have no answer.").arg(share(rule));
        case ExclusionKind::catchYesShareAbove:
            return tr("Sessions with more than %1 % of yes in catch trials.").arg(share(rule));
        case ExclusionKind::sameAnswerShareAbove:
            return tr("Sessions with one answer in more than %1 % of the trials.").arg(share(rule));
        case ExclusionKind::practiceAccuracyBelow:
            return tr("Participants with less than %1 % right in practice.").arg(share(rule));
        case ExclusionKind::accuracyNotAboveChance:
            return tr("Participants who are not better than chance (p above %1).").arg(value);
        }
        return {};
    }

    static QString share(const study::ExclusionRule& rule) { return number(100.0 * rule.value); }

    const study::Protocol& m_protocol;
};

} // namespace

QString protocolSummary(const study::Protocol& protocol) {
    return Summary(protocol).html();
}

} // namespace teleta::console
