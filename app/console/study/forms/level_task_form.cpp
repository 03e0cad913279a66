// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/forms/level_task_form.h"

#include "app/console/study/forms/form_text.h"
#include "backend/core/number_text.h"
#include "widgets/base/compose.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/theme.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::console {

using study::Design;

namespace {

constexpr double kTrackLines_em = 6.0;
constexpr std::size_t kConstant = 0;
constexpr std::size_t kStaircase = 1;
constexpr std::size_t kBayes = 2;

QString asText(double value) {
    return QString::fromStdString(std::string(core::NumberText(value).view()));
}

QString asText(const std::optional<double>& value) {
    return value ? asText(*value) : QString();
}

QString asText(const std::vector<double>& values) {
    QStringList texts;
    for (const double value : values)
        texts << asText(value);
    return texts.join(QStringLiteral(", "));
}

QString tactorText(const std::vector<std::size_t>& tactors) {
    QString text;
    for (const std::size_t tactor : tactors)
        text += QLatin1Char(' ') + QString::number(tactor + 1);
    return text;
}

core::Unexpected refusedField(const QString& message, const QString& expected) {
    return core::Unexpected(
        core::Error{core::ErrorKind::refused, message.toStdString(), expected.toStdString(), {}});
}

} // namespace

LevelTaskForm::LevelTaskForm(const study::StudyTask& task, QWidget* parent)
    : QGroupBox(tr("Task with levels"), parent)
    , m_form(new QFormLayout(this)) {
    const study::LevelTask& levels = task.levels;
    QStringList conditions;
    for (const std::string& condition : task.conditions) {
        const auto own = task.references.find(condition);
        conditions << QString::fromStdString(condition) +
                          (own == task.references.end() ? QString() : QLatin1Char(' ') + asText(own->second));
    }
    QStringList tracks;
    for (const study::LevelTrack& track : levels.tracks)
        tracks << QString::fromStdString(track.id) + tactorText(track.tactors) +
                      (track.reference.empty() ? QString()
                                               : QStringLiteral(" /") + tactorText(track.reference));
    m_id = line("levelTaskId", QString::fromStdString(task.id));
    m_name = line("levelTaskName", QString::fromStdString(task.name));
    m_design = base::named<QComboBox>("design", this);
    m_design->addItems({tr("yes or no: was it there?"), tr("intervals: in which one was it?"),
                        tr("same or different"), tr("compare: which one had more?")});
    m_design->setCurrentIndex(static_cast<int>(task.design) - 1);
    m_question = line("question", QString::fromStdString(levels.question));
    m_question->setPlaceholderText(tr("the usual question of the design"));
    m_conditions = line("levelConditions", conditions.join(QStringLiteral(", ")));
    m_conditions->setPlaceholderText(tr("for example rest, or weak 0.3, strong 0.7 with their references"));
    m_intervals = base::named<QSpinBox>("intervals", this);
    m_intervals->setRange(2, static_cast<int>(study::kMostIntervals));
    m_intervals->setValue(static_cast<int>(levels.intervals));
    m_gap_s = line("gap_s", asText(levels.gap_s));
    m_catchShare = line("catchShare", asText(levels.catchShare));
    m_tracks = base::named<QPlainTextEdit>("tracks", tracks.join(QLatin1Char('\n')), this);
    m_tracks->setTabChangesFocus(true);
    m_tracks->setFixedHeight(base::em(this, kTrackLines_em));
    m_tracks->setPlaceholderText(
        tr("name and tactors, one track per line, for example t1 1; tactors of the reference after /"));
    m_file = line("stimulusFile", QString::fromStdString(levels.file));
    m_file->setPlaceholderText(tr("full path of a pattern file"));
    m_choose = base::named<QPushButton>("chooseStimulus", tr("Choose\u2026"), this);
    m_vary = base::named<QComboBox>("vary", this);
    m_vary->addItems({tr("intensity"), tr("time from burst to burst"), tr("length of a burst"), tr("length"),
                      tr("balance of a phantom")});
    m_vary->setCurrentIndex(static_cast<int>(levels.vary));
    m_unit = base::named<QLabel>("levelUnit", this);
    m_unit->setWordWrap(true);
    m_scale = base::named<QComboBox>("scale", this);
    m_scale->addItems({tr("linear"), tr("logarithmic (log10)")});
    m_scale->setCurrentIndex(static_cast<int>(levels.range.scale));
    m_lowest = line("lowest", asText(levels.range.lowest));
    m_highest = line("highest", asText(levels.range.highest));
    m_reference = line("reference", asText(levels.reference));
    m_practice = line("practiceLevel", asText(levels.practiceLevel));
    m_practice->setPlaceholderText(tr("the highest"));
    m_procedure = base::named<QComboBox>("procedure", this);
    m_procedure->addItems({tr("constant stimuli"), tr("staircase"), tr("Bayesian (QUEST+)")});
    m_procedure->setCurrentIndex(static_cast<int>(levels.procedure.index()));
    m_values = line("values", asText(levels.values));
    m_values->setPlaceholderText(tr("levels with commas between them, for example 0.1, 0.2, 0.4"));

    addRow(tr("Identifier"), m_id);
    addRow(tr("Name"), m_name);
    addRow(tr("Design"), m_design);
    addRow(tr("Question"), m_question);
    addRow(tr("Conditions"), m_conditions);
    addRow(tr("Intervals"), m_intervals, {Design::interval});
    addRow(tr("Gap between intervals, s"), m_gap_s,
           {Design::interval, Design::sameDifferent, Design::compare});
    addRow(tr("Share of catch trials"), m_catchShare, {Design::yesNo});
    addRow(tr("Tracks"), m_tracks);
    auto* file = new QWidget(this);
    auto* fileLine = new QHBoxLayout(file);
    fileLine->setContentsMargins(0, 0, 0, 0);
    fileLine->addWidget(m_file, 1);
    fileLine->addWidget(m_choose);
    addRow(tr("Stimulus"), file);
    addRow(tr("A level sets the"), m_vary);
    addRow(QString(), m_unit);
    addRow(tr("Scale"), m_scale);
    addRow(tr("Lowest level"), m_lowest);
    addRow(tr("Highest level"), m_highest);
    addRow(tr("Reference; 0 is nothing"), m_reference);
    addRow(tr("Level of the practice"), m_practice);
    addRow(tr("Levels are chosen by"), m_procedure);
    addRow(tr("Levels"), m_values, {}, {kConstant});
    const auto* staircase = std::get_if<study::StaircaseSettings>(&levels.procedure);
    addStaircase(staircase != nullptr ? *staircase : study::StaircaseSettings());
    const auto* bayes = std::get_if<study::BayesSettings>(&levels.procedure);
    addBayes(bayes != nullptr ? *bayes : study::BayesSettings());

    auto* remove = base::named<QPushButton>("removeLevelTask", tr("Remove this task"), this);
    m_form->addRow(remove);
    connect(remove, &QPushButton::clicked, this, &LevelTaskForm::removeRequested);
    connect(m_choose, &QPushButton::clicked, this, &LevelTaskForm::askForFile);
    for (QLineEdit* edit : {m_staircase.down, m_staircase.stepUp, m_staircase.stepDown})
        connect(edit, &QLineEdit::textChanged, this, &LevelTaskForm::showConsequences);
    connect(m_tracks, &QPlainTextEdit::textChanged, this, &LevelTaskForm::changed);
    connect(m_intervals, &QSpinBox::valueChanged, this, &LevelTaskForm::changed);
    for (QComboBox* box : findChildren<QComboBox*>())
        connect(box, &QComboBox::currentIndexChanged, this, [this] {
            showRows();
            emit changed();
        });
    showRows();
}

QLineEdit* LevelTaskForm::line(const char* name, const QString& text) {
    auto* edit = base::named<QLineEdit>(name, text, this);
    connect(edit, &QLineEdit::textChanged, this, &LevelTaskForm::changed);
    return edit;
}

void LevelTaskForm::addRow(const QString& label, QWidget* field, std::vector<Design> designs,
                           std::vector<std::size_t> procedures) {
    m_form->addRow(label, field);
    m_rows.push_back({field, std::move(designs), std::move(procedures)});
}

void LevelTaskForm::addStaircase(const study::StaircaseSettings& settings) {
    const auto add = [this](const QString& label, const char* name, const QString& text) {
        QLineEdit* edit = line(name, text);
        addRow(label, edit, {}, {kStaircase});
        return edit;
    };
    const auto whole = [](std::size_t value) { return QString::number(value); };
    m_staircase.first = add(tr("First level"), "first", asText(settings.first));
    m_staircase.down = add(tr("Right answers for a step down"), "down", whole(settings.down));
    m_staircase.stepUp = add(tr("Step up, log10 units on a log scale"), "stepUp", asText(settings.stepUp));
    m_staircase.stepDown = add(tr("Step down, likewise"), "stepDown", asText(settings.stepDown));
    m_staircase.fastReversals =
        add(tr("Reversals with larger steps"), "fastReversals", whole(settings.fastReversals));
    m_staircase.fastFactor = add(tr("These steps are larger by"), "fastFactor", asText(settings.fastFactor));
    m_staircase.reversals = add(tr("Reversals at most"), "reversals", whole(settings.reversals));
    m_staircase.skip = add(tr("First reversals left out"), "skipReversals", whole(settings.skipReversals));
    m_staircase.most = add(tr("Trials at most"), "staircaseTrials", whole(settings.mostTrials));
    m_target = base::named<QLabel>("targetShare", this);
    addRow(tr("It stays at"), m_target, {}, {kStaircase});
}

void LevelTaskForm::addBayes(const study::BayesSettings& settings) {
    m_bayes.function = base::named<QComboBox>("function", this);
    m_bayes.function->addItems(
        {QStringLiteral("gauss"), QStringLiteral("logistic"), QStringLiteral("weibull")});
    m_bayes.function->setCurrentIndex(static_cast<int>(settings.function));
    addRow(tr("Function"), m_bayes.function, {}, {kBayes});
    const auto add = [this](const QString& label, const char* name, const QString& text,
                            std::vector<Design> designs = {}) {
        QLineEdit* edit = line(name, text);
        addRow(label, edit, std::move(designs), {kBayes});
        return edit;
    };
    const auto whole = [](std::size_t value) { return QString::number(value); };
    m_bayes.slope = add(tr("Slopes or spreads"), "slope", asText(settings.slope));
    m_bayes.lapse = add(tr("Lapse rates"), "lapse", asText(settings.lapse));
    m_bayes.guess =
        add(tr("Rates of yes without a stimulus"), "guess", asText(settings.guess), {Design::yesNo});
    m_bayes.grid = add(tr("Levels of the grid"), "grid", whole(settings.grid));
    m_bayes.priorMean = add(tr("Mean of the prior, in the scale"), "priorMean", asText(settings.priorMean));
    m_bayes.priorMean->setPlaceholderText(tr("all thresholds are equally likely"));
    m_bayes.priorSd = add(tr("Its standard deviation"), "priorSd", asText(settings.priorSd));
    m_bayes.most = add(tr("Trials at most"), "bayesTrials", whole(settings.mostTrials));
    m_bayes.least = add(tr("Trials at least"), "leastTrials", whole(settings.leastTrials));
    m_bayes.sd = add(tr("Ends with a standard deviation of"), "sdAtMost", asText(settings.sdAtMost));
    m_bayes.sd->setPlaceholderText(tr("only with its trials"));
}

void LevelTaskForm::showRows() {
    const auto design = static_cast<Design>(m_design->currentIndex() + 1);
    const auto procedure = static_cast<std::size_t>(m_procedure->currentIndex());
    const auto has = [](const auto& list, const auto& value) {
        return list.empty() || std::find(list.begin(), list.end(), value) != list.end();
    };
    for (const Row& row : m_rows)
        m_form->setRowVisible(row.field, has(row.designs, design) && has(row.procedures, procedure));
    showConsequences();
}

void LevelTaskForm::showConsequences() {
    switch (static_cast<study::Vary>(m_vary->currentIndex())) {
    case study::Vary::intensity:
        m_unit->setText(tr("Levels are shares of the intensity in the file, 0 to 1."));
        break;
    case study::Vary::balance:
        m_unit->setText(tr("Levels are balances, from 0 (the first tactor alone) to 1 (the second alone)."));
        break;
    case study::Vary::onset:
    case study::Vary::burst:
    case study::Vary::duration:
        m_unit->setText(tr("Levels are times in seconds."));
        break;
    }
    const auto down = count(m_staircase.down);
    const auto up = number(m_staircase.stepUp);
    const auto below = number(m_staircase.stepDown);
    const bool isKnown = down && up && below && *down > 0 && *up > 0.0 && *below > 0.0;
    if (!isKnown) {
        m_target->setText(QStringLiteral("\u2013"));
        return;
    }
    study::StaircaseSettings settings;
    settings.down = *down;
    settings.stepUp = *up;
    settings.stepDown = *below;
    m_target->setText(
        tr("%1 % right answers").arg(QLocale().toString(100.0 * study::targetShare(settings), 'f', 1)));
}

void LevelTaskForm::askForFile() {
    base::askToOpen(this, {.title = tr("Pattern file of the stimulus")},
                    [this](const QString& path) { m_file->setText(path); });
}

study::StudyTask LevelTaskForm::beginning() {
    study::StudyTask task;
    task.id = "detection";
    task.name = tr("Detection").toStdString();
    task.conditions = {"rest"};
    task.design = Design::interval;
    task.levels.range = {study::LevelScale::log10, 0.01, 1.0};
    task.levels.procedure = study::StaircaseSettings();
    task.levels.tracks = {{"all"}};
    return task;
}

core::Expected<double> LevelTaskForm::number(const QLineEdit* edit) const {
    bool isNumber = false;
    const double value = QLocale::c().toDouble(edit->text().trimmed(), &isNumber);
    if (isNumber && std::isfinite(value))
        return value;
    const auto* label = qobject_cast<const QLabel*>(m_form->labelForField(const_cast<QLineEdit*>(edit)));
    return refusedField(tr("%1: \"%2\" is not a number", "a row of the form")
                            .arg(label != nullptr ? label->text() : edit->objectName(), edit->text()),
                        tr("a number with a point, such as 0.5"));
}

core::Expected<std::optional<double>> LevelTaskForm::wish(const QLineEdit* edit) const {
    if (edit->text().trimmed().isEmpty())
        return std::nullopt;
    TELETA_TRY(const double value, number(edit));
    return value;
}

core::Expected<std::vector<double>> LevelTaskForm::numbers(const QLineEdit* edit) const {
    std::vector<double> values;
    for (const QString& part : parts(edit->text(), QLatin1Char(','))) {
        bool isNumber = false;
        values.push_back(QLocale::c().toDouble(part, &isNumber));
        if (!isNumber || !std::isfinite(values.back()))
            return refusedField(tr("\"%1\" is not a number").arg(part),
                                tr("numbers with a point, such as 0.1, 0.2"));
    }
    return values;
}

core::Expected<std::size_t> LevelTaskForm::count(const QLineEdit* edit) const {
    bool isWhole = false;
    const qulonglong value = edit->text().trimmed().toULongLong(&isWhole);
    if (!isWhole)
        return refusedField(tr("\"%1\" is not a whole number").arg(edit->text()), tr("a number such as 12"));
    return static_cast<std::size_t>(value);
}

core::Expected<void> LevelTaskForm::readTracks(study::StudyTask& task) const {
    for (const QString& one : parts(m_tracks->toPlainText(), QLatin1Char('\n'))) {
        study::LevelTrack track;
        std::vector<std::size_t>* tactors = &track.tactors;
        for (const QString& word : parts(one, QLatin1Char(' '))) {
            bool isNumber = false;
            const uint tactor = word.toUInt(&isNumber);
            if (track.id.empty())
                track.id = word.toStdString();
            else if (word == QStringLiteral("/"))
                tactors = &track.reference;
            else if (isNumber && tactor >= 1)
                tactors->push_back(tactor - 1);
            else
                return refusedField(tr("\"%1\" is no tactor").arg(word),
                                    tr("a name and numbers of tactors, for example t1 1"));
        }
        task.levels.tracks.push_back(std::move(track));
    }
    if (task.levels.tracks.empty())
        task.levels.tracks = {{"all"}};
    return {};
}

core::Expected<void> LevelTaskForm::readConditions(study::StudyTask& task) const {
    for (const QString& one : parts(m_conditions->text(), QLatin1Char(','))) {
        const QString id = one.section(QLatin1Char(' '), 0, 0);
        const QString reference = one.section(QLatin1Char(' '), 1).trimmed();
        task.conditions.push_back(id.toStdString());
        if (reference.isEmpty())
            continue;
        bool isNumber = false;
        task.references[id.toStdString()] = QLocale::c().toDouble(reference, &isNumber);
        if (!isNumber)
            return refusedField(tr("\"%1\" is not a number").arg(reference),
                                tr("a condition and its reference, such as weak 0.3"));
    }
    return {};
}

core::Expected<study::Procedure> LevelTaskForm::procedure() const {
    switch (static_cast<std::size_t>(m_procedure->currentIndex())) {
    case kStaircase: {
        study::StaircaseSettings staircase;
        TELETA_TRY(staircase.first, number(m_staircase.first));
        TELETA_TRY(staircase.down, count(m_staircase.down));
        TELETA_TRY(staircase.stepUp, number(m_staircase.stepUp));
        TELETA_TRY(staircase.stepDown, number(m_staircase.stepDown));
        TELETA_TRY(staircase.fastReversals, count(m_staircase.fastReversals));
        TELETA_TRY(staircase.fastFactor, number(m_staircase.fastFactor));
        TELETA_TRY(staircase.reversals, count(m_staircase.reversals));
        TELETA_TRY(staircase.skipReversals, count(m_staircase.skip));
        TELETA_TRY(staircase.mostTrials, count(m_staircase.most));
        return staircase;
    }
    case kBayes: {
        study::BayesSettings bayes;
        bayes.function = static_cast<study::RiseShape>(m_bayes.function->currentIndex());
        TELETA_TRY(bayes.slope, numbers(m_bayes.slope));
        TELETA_TRY(bayes.lapse, numbers(m_bayes.lapse));
        TELETA_TRY(bayes.guess, numbers(m_bayes.guess));
        TELETA_TRY(bayes.grid, count(m_bayes.grid));
        TELETA_TRY(bayes.priorMean, wish(m_bayes.priorMean));
        TELETA_TRY(bayes.priorSd, wish(m_bayes.priorSd));
        TELETA_TRY(bayes.mostTrials, count(m_bayes.most));
        TELETA_TRY(bayes.leastTrials, count(m_bayes.least));
        TELETA_TRY(bayes.sdAtMost, wish(m_bayes.sd));
        return bayes;
    }
    default:
        return study::ConstantSettings();
    }
}

core::Expected<study::StudyTask> LevelTaskForm::task() const {
    study::StudyTask task;
    study::LevelTask& levels = task.levels;
    task.id = m_id->text().trimmed().toStdString();
    task.name = m_name->text().trimmed().toStdString();
    task.design = static_cast<Design>(m_design->currentIndex() + 1);
    levels.question = m_question->text().trimmed().toStdString();
    levels.intervals = static_cast<std::size_t>(m_intervals->value());
    TELETA_CHECK(readConditions(task));
    TELETA_CHECK(readTracks(task));
    levels.file = m_file->text().trimmed().toStdString();
    levels.vary = static_cast<study::Vary>(m_vary->currentIndex());
    levels.range.scale = static_cast<study::LevelScale>(m_scale->currentIndex());
    TELETA_TRY(levels.gap_s, number(m_gap_s));
    TELETA_TRY(levels.catchShare, number(m_catchShare));
    TELETA_TRY(levels.range.lowest, number(m_lowest));
    TELETA_TRY(levels.range.highest, number(m_highest));
    TELETA_TRY(levels.reference, number(m_reference));
    TELETA_TRY(levels.practiceLevel, wish(m_practice));
    TELETA_TRY(levels.values, numbers(m_values));
    TELETA_TRY(levels.procedure, procedure());
    return task;
}

} // namespace teleta::console
