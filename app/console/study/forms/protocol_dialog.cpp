// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/forms/protocol_dialog.h"

#include "app/console/study/forms/exclusion_editor.h"
#include "app/console/study/forms/form_text.h"
#include "app/console/study/forms/level_task_form.h"
#include "app/console/study/forms/questionnaire_editor.h"
#include "app/console/study/forms/trigger_editor.h"
#include "backend/core/data/output_file.h"
#include "backend/study/protocol/stimulus_set.h"
#include "widgets/base/background.h"
#include "widgets/base/compose.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace teleta::console {

namespace {

constexpr double kShortest_s = 0.001;
constexpr double kLongest_s = 3600.0;
constexpr double kLoudest_dBA = 85.0;
constexpr int kMostRepetitions = 1000;
constexpr int kMostTrials = 100'000;
constexpr double kPatternLines_em = 10.0;
constexpr double kFileLines_em = 5.0;

core::Unexpected refusedEntry(const QString& message, const QString& expected) {
    return core::Unexpected(
        core::Error{core::ErrorKind::refused, message.toStdString(), expected.toStdString(), {}});
}

/// Pattern files below the protocol's folder get relative paths, so that the folder can be moved.
study::Protocol asSavedIn(const QDir& folder, study::Protocol protocol) {
    const auto shorten = [&folder](std::string& file) {
        const QString given = QString::fromStdString(file);
        // What comes with the program is in no folder.
        if (given.isEmpty() || given.startsWith(QLatin1Char(':')))
            return;
        const QString name = folder.relativeFilePath(given);
        if (!name.startsWith(QLatin1String("..")))
            file = name.toStdString();
    };
    for (study::StudyTask& task : protocol.tasks) {
        shorten(task.levels.file);
        for (study::StudyPattern& pattern : task.patterns) {
            for (auto& [condition, file] : pattern.files)
                shorten(file);
        }
    }
    return protocol;
}

} // namespace

ProtocolDialog::ProtocolDialog(const study::Protocol& protocol, QWidget* parent)
    : QDialog(parent)
    , m_content(new QWidget(this))
    , m_name(base::named<QLineEdit>("protocolName", QString::fromStdString(protocol.name), this))
    , m_description(new QLineEdit(QString::fromStdString(protocol.description), this))
    , m_authors(base::named<QLineEdit>("protocolAuthors", this))
    , m_stimulus_s(makeNumber(protocol.stimulus_s, kShortest_s, kLongest_s, 3, QStringLiteral(" s")))
    , m_limit_s(makeNumber(protocol.responseLimit_s, kShortest_s, kLongest_s, 3, QStringLiteral(" s")))
    , m_window(new QComboBox(this))
    , m_replays(new QSpinBox(this))
    , m_order(new QComboBox(this))
    , m_practice(makePhase(protocol.practice))
    , m_test(makePhase(protocol.test))
    , m_restEvery(base::named<QSpinBox>("restEvery", this))
    , m_rest_s(makeNumber(protocol.rest.atLeast_s, 0.0, kLongest_s, 1, QStringLiteral(" s")))
    , m_noise(new QComboBox(this))
    , m_level_dBA(makeNumber(protocol.noise_dBA, 0.0, kLoudest_dBA, 1, QStringLiteral(" dBA")))
    , m_trigger(base::named<TriggerEditor>("protocolTrigger", protocol.trigger, this))
    , m_record(base::named<QCheckBox>("recordSessions", tr("Record each sess&ion"), this))
    , m_taskRows(new QVBoxLayout)
    , m_questionnaireRows(new QVBoxLayout)
    , m_exclusions(new ExclusionEditor(protocol.exclusions, m_content))
    , m_verdict(base::named<QLabel>("verdict", this)) {
    setWindowTitle(tr("Protocol"));
    setObjectName(QStringLiteral("protocolDialog"));
    m_stimulus_s.box->setObjectName(QStringLiteral("stimulus_s"));
    m_window->addItems({tr("of the onset of the stimulus"), tr("of its end")});
    m_window->setCurrentIndex(protocol.window == study::ResponseWindow::fromOnset ? 0 : 1);
    m_replays->setRange(0, kMostRepetitions);
    m_replays->setValue(static_cast<int>(protocol.replays));
    m_replays->setSuffix(tr(" \u00d7", "after a number"));
    m_order->addItems(
        {tr("all repetitions together, in random order"), tr("each repetition in a random order")});
    m_order->setCurrentIndex(protocol.order == study::OrderMethod::fullRandom ? 0 : 1);
    m_restEvery->setRange(0, kMostTrials);
    m_restEvery->setSpecialValueText(tr("no rests"));
    m_restEvery->setPrefix(tr("after every ", "before a number of trials"));
    m_restEvery->setSuffix(tr(" trials", "after a number"));
    m_restEvery->setValue(static_cast<int>(protocol.rest.everyTrials));
    m_rest_s.box->setObjectName(QStringLiteral("rest_s"));
    m_rest_s.box->setPrefix(tr("at least ", "before a number of seconds"));
    m_noise->addItems({tr("pink"), tr("none")});
    m_noise->setCurrentIndex(protocol.noiseColour == "none" ? 1 : 0);
    QStringList authors;
    for (const std::string& author : protocol.authors)
        authors << QString::fromStdString(author);
    m_authors->setText(authors.join(QStringLiteral("; ")));
    m_authors->setPlaceholderText(tr("names separated by semicolons, for the description of exported data"));
    m_record->setChecked(protocol.recordSessions);
    m_verdict->setWordWrap(true);

    auto* form = new QFormLayout;
    const auto addRow = [form](const QString& text, std::initializer_list<QWidget*> widgets) {
        auto* line = new QHBoxLayout;
        for (QWidget* widget : widgets)
            line->addWidget(widget);
        line->addStretch(1);
        base::addFormRow(*form, text, line, *widgets.begin());
    };
    form->addRow(tr("&Name"), m_name);
    form->addRow(tr("D&escription"), m_description);
    form->addRow(tr("Aut&hors"), m_authors);
    addRow(tr("&Stimulus, at most"), {m_stimulus_s.box});
    addRow(tr("Answer &within"), {m_limit_s.box, m_window});
    addRow(tr("May &be felt again"), {m_replays});
    addRow(tr("Or&der"), {m_order});
    addRow(tr("&Practice"), {m_practice.repetitions, m_practice.feedback, m_practice.diagram});
    addRow(tr("&Test"), {m_test.repetitions, m_test.feedback, m_test.diagram});
    addRow(tr("Rests"), {m_restEvery, m_rest_s.box});
    addRow(tr("&Masking noise"), {m_noise, m_level_dBA.box});
    addRow(tr("Tri&ggers"), {m_trigger});
    form->addRow(m_record);

    auto* column = new QVBoxLayout(m_content);
    column->addLayout(form);
    column->addLayout(m_taskRows);
    auto* addButton = new QPushButton(tr("&Add a task"), m_content);
    connect(addButton, &QPushButton::clicked, this, [this] {
        addTask({});
        check();
    });
    auto* levelButton = base::named<QPushButton>("addLevelTask", tr("Add a task with &levels"), m_content);
    connect(levelButton, &QPushButton::clicked, this, [this] {
        addLevelTask(LevelTaskForm::beginning());
        check();
    });
    auto* addButtons = new QHBoxLayout;
    base::addWidgets(addButtons, {addButton, levelButton});
    addButtons->addStretch(1);
    column->addLayout(addButtons);
    column->addLayout(m_questionnaireRows);
    auto* askButton = base::named<QPushButton>("addQuestionnaire", tr("Add a &questionnaire"), m_content);
    connect(askButton, &QPushButton::clicked, this, [this] {
        addQuestionnaire({{}, {}, study::QuestionnaireTime::afterStudy, {study::QuestionnaireItem{}}});
        check();
    });
    column->addWidget(askButton, 0, Qt::AlignLeft);
    column->addWidget(m_exclusions);
    column->addStretch(1);
    auto* area = new QScrollArea(this);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidget(m_content);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    const auto button = [&](const QString& text, QDialogButtonBox::ButtonRole role) {
        return buttons->addButton(text, role);
    };
    connect(button(tr("&Open\u2026"), QDialogButtonBox::ResetRole), &QPushButton::clicked, this,
            &ProtocolDialog::openRequested);
    connect(button(tr("The pape&r's"), QDialogButtonBox::ResetRole), &QPushButton::clicked, this,
            &ProtocolDialog::paperRequested);
    m_save = button(tr("Sa&ve as\u2026"), QDialogButtonBox::ActionRole);
    m_make = button(tr("Ma&ke a study\u2026"), QDialogButtonBox::ActionRole);
    m_make->setObjectName(QStringLiteral("makeStudy"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(area, 1);
    layout->addWidget(m_verdict);
    layout->addWidget(buttons);
    resize(base::em(this, 46), base::em(this, 42));

    connect(buttons, &QDialogButtonBox::rejected, this, &ProtocolDialog::reject);
    connect(m_save, &QPushButton::clicked, this, [this] { save({}); });
    connect(m_make, &QPushButton::clicked, this, [this] {
        const auto valid = this->protocol();
        m_isStudyWanted = valid.has_value();
        if (valid)
            emit studyRequested(*valid);
    });
    connect(m_trigger, &TriggerEditor::changed, this, &ProtocolDialog::check);
    for (QLineEdit* edit : {m_name, m_description, m_authors})
        connect(edit, &QLineEdit::textChanged, this, &ProtocolDialog::check);
    for (QSpinBox* box : {m_practice.repetitions, m_test.repetitions, m_restEvery})
        connect(box, &QSpinBox::valueChanged, this, &ProtocolDialog::check);
    for (QComboBox* box : {m_noise, m_window})
        connect(box, &QComboBox::currentIndexChanged, this, &ProtocolDialog::check);
    connect(m_stimulus_s.box, &QDoubleSpinBox::valueChanged, this, &ProtocolDialog::check);
    connect(m_exclusions, &ExclusionEditor::changed, this, &ProtocolDialog::check);
    for (const study::StudyTask& task : protocol.tasks)
        addTask(task);
    for (const study::Questionnaire& questionnaire : protocol.questionnaires)
        addQuestionnaire(questionnaire);
    check();
    m_saved = fields();
}

double ProtocolDialog::NumberField::value() const {
    return box->value() == shown ? read : box->value();
}

ProtocolDialog::NumberField ProtocolDialog::makeNumber(double value, double low, double high, int decimals,
                                                       const QString& unit) {
    auto* box = new QDoubleSpinBox(this);
    box->setDecimals(decimals);
    box->setRange(low, high);
    box->setSuffix(unit);
    box->setValue(value);
    return {box, value, box->value()};
}

ProtocolDialog::PhaseRow ProtocolDialog::makePhase(const study::PhaseSettings& phase) {
    PhaseRow row{new QSpinBox(this), new QCheckBox(tr("feedback"), this),
                 new QCheckBox(tr("pictures in view"), this)};
    row.repetitions->setRange(0, kMostRepetitions);
    row.repetitions->setSuffix(tr(" \u00d7 each pattern", "after a number"));
    row.repetitions->setValue(static_cast<int>(phase.repetitions));
    row.feedback->setChecked(phase.feedback);
    row.diagram->setChecked(phase.diagram);
    return row;
}

void ProtocolDialog::addLevelTask(const study::StudyTask& task) {
    auto* form = new LevelTaskForm(task, this);
    connect(form, &LevelTaskForm::changed, this, &ProtocolDialog::check);
    connect(form, &LevelTaskForm::removeRequested, this, [this, form] { removeTask(form); });
    m_tasks.push_back({form, form});
    m_taskRows->addWidget(form);
}

void ProtocolDialog::addTask(const study::StudyTask& task) {
    if (task.design != study::Design::identification) {
        addLevelTask(task);
        return;
    }
    auto* box = new QGroupBox(tr("Task"), this);
    QStringList conditions;
    for (const std::string& condition : task.conditions)
        conditions << QString::fromStdString(condition);
    QStringList patterns;
    QStringList files;
    for (const study::StudyPattern& pattern : task.patterns) {
        patterns << QString::fromStdString(pattern.letter + ' ' + pattern.name);
        for (const auto& [condition, file] : pattern.files)
            files << QString::fromStdString(pattern.letter + ' ' + condition + ' ' + file);
    }
    const TaskRow row{box,
                      nullptr,
                      new QLineEdit(QString::fromStdString(task.id), box),
                      new QLineEdit(QString::fromStdString(task.name), box),
                      new QLineEdit(conditions.join(QStringLiteral(", ")), box),
                      new QPlainTextEdit(patterns.join(QLatin1Char('\n')), box),
                      new QPlainTextEdit(files.join(QLatin1Char('\n')), box),
                      new QPushButton(tr("Choose a pattern file\u2026"), box)};
    row.choose->setObjectName(QStringLiteral("choosePattern"));
    row.id->setObjectName(QStringLiteral("taskId"));
    row.patterns->setObjectName(QStringLiteral("taskPatterns"));
    row.patterns->setTabChangesFocus(true);
    row.patterns->setFixedHeight(base::em(this, kPatternLines_em));
    row.files->setObjectName(QStringLiteral("taskFiles"));
    row.files->setTabChangesFocus(true);
    row.files->setFixedHeight(base::em(this, kFileLines_em));
    row.files->setPlaceholderText(
        tr("letter, condition and file, one per line, for your own patterns; all others are built in"));
    row.id->setPlaceholderText(tr("for example shape"));
    row.conditions->setPlaceholderText(tr("for example static, dynamic"));
    row.patterns->setPlaceholderText(tr("letter and name, one per line, for example A circle"));
    auto* form = new QFormLayout(box);
    form->addRow(tr("Identifier"), row.id);
    form->addRow(tr("Name"), row.name);
    form->addRow(tr("Conditions"), row.conditions);
    form->addRow(tr("Patterns"), row.patterns);
    form->addRow(tr("Your own"), row.files);
    connect(row.choose, &QPushButton::clicked, this, [this, row] { askForPattern(row); });
    auto* remove = new QPushButton(tr("Remove this task"), box);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(row.choose);
    buttons->addWidget(remove);
    buttons->addStretch(1);
    form->addRow(buttons);
    connect(remove, &QPushButton::clicked, this, [this, box] { removeTask(box); });
    for (QLineEdit* edit : {row.id, row.name, row.conditions})
        connect(edit, &QLineEdit::textChanged, this, &ProtocolDialog::check);
    for (QPlainTextEdit* edit : {row.patterns, row.files})
        connect(edit, &QPlainTextEdit::textChanged, this, &ProtocolDialog::check);
    m_tasks.push_back(row);
    m_taskRows->addWidget(box);
}

void ProtocolDialog::removeTask(QWidget* box) {
    std::erase_if(m_tasks, [box](const TaskRow& row) { return row.box == box; });
    box->hide();
    box->deleteLater();
    check();
}

void ProtocolDialog::addQuestionnaire(const study::Questionnaire& questionnaire) {
    auto* editor = new QuestionnaireEditor(questionnaire, this);
    connect(editor, &QuestionnaireEditor::changed, this, &ProtocolDialog::check);
    connect(editor, &QuestionnaireEditor::removeRequested, this, [this, editor] {
        std::erase(m_questionnaires, editor);
        editor->hide();
        editor->deleteLater();
        check();
    });
    m_questionnaires.push_back(editor);
    m_questionnaireRows->addWidget(editor);
}

core::Expected<study::StudyTask> ProtocolDialog::taskOf(const TaskRow& row) {
    if (row.levels != nullptr)
        return row.levels->task();
    study::StudyTask task;
    task.id = row.id->text().trimmed().toStdString();
    task.name = row.name->text().trimmed().toStdString();
    for (const QString& condition : parts(row.conditions->text(), QLatin1Char(',')))
        task.conditions.push_back(condition.toStdString());
    for (const auto& [letter, name] : firstWords(row.patterns->toPlainText()))
        task.patterns.push_back({letter.toStdString(), name.toStdString()});
    for (const auto& [letter, rest] : firstWords(row.files->toPlainText())) {
        const QString condition = rest.section(QLatin1Char(' '), 0, 0);
        const QString file = rest.section(QLatin1Char(' '), 1).trimmed();
        const auto pattern =
            std::find_if(task.patterns.begin(), task.patterns.end(),
                         [&](const study::StudyPattern& one) { return one.letter == letter.toStdString(); });
        const bool isCondition = std::find(task.conditions.begin(), task.conditions.end(),
                                           condition.toStdString()) != task.conditions.end();
        if (pattern == task.patterns.end() || !isCondition)
            return refusedEntry(tr("the task has no pattern \"%1 %2\"").arg(letter, condition),
                                tr("a letter and a condition of the task, then the file"));
        if (!QDir::isAbsolutePath(file))
            return refusedEntry(tr("the file of \"%1 %2\" cannot be found").arg(letter, condition),
                                tr("its full path"));
        if (!pattern->files.emplace(condition.toStdString(), file.toStdString()).second)
            return refusedEntry(tr("\"%1 %2\" has two files").arg(letter, condition), tr("one file"));
    }
    return task;
}

/// The first stimulus without a pattern, otherwise the first one without a file. Empty: all have one, or the
/// task is incomplete.
QString ProtocolDialog::placeForPattern(const TaskRow& row) {
    const core::Expected<study::StudyTask> task = taskOf(row);
    if (!task)
        return {};
    study::Protocol alone;
    alone.tasks = {*task};
    const std::vector<std::string> missing = study::missingStimuli(alone);
    for (const std::string& condition : task->conditions) {
        for (const study::StudyPattern& pattern : task->patterns) {
            const bool isNext = missing.empty()
                                    ? !pattern.files.contains(condition)
                                    : study::stimulusId(*task, pattern, condition) == missing.front();
            if (isNext)
                return QString::fromStdString(pattern.letter + ' ' + condition);
        }
    }
    return {};
}

void ProtocolDialog::askForPattern(const TaskRow& row) {
    const QString place = placeForPattern(row);
    if (place.isEmpty())
        return;
    base::askToOpen(this, {.title = tr("Pattern file for %1", "a letter and a condition").arg(place)},
                    [files = QPointer(row.files), place](const QString& path) {
                        if (files)
                            files->appendPlainText(place + QLatin1Char(' ') + path);
                    });
}

core::Expected<study::Protocol> ProtocolDialog::protocol() const {
    study::Protocol protocol;
    for (const QString& author : parts(m_authors->text(), QLatin1Char(';')))
        protocol.authors.push_back(author.toStdString());
    protocol.trigger = m_trigger->settings();
    protocol.recordSessions = m_record->isChecked();
    protocol.name = m_name->text().trimmed().toStdString();
    protocol.description = m_description->text().trimmed().toStdString();
    protocol.stimulus_s = m_stimulus_s.value();
    protocol.responseLimit_s = m_limit_s.value();
    protocol.window =
        m_window->currentIndex() == 0 ? study::ResponseWindow::fromOnset : study::ResponseWindow::fromEnd;
    protocol.replays = static_cast<std::size_t>(m_replays->value());
    protocol.order =
        m_order->currentIndex() == 0 ? study::OrderMethod::fullRandom : study::OrderMethod::blockedRandom;
    const auto phase = [](const PhaseRow& row) {
        return study::PhaseSettings{static_cast<std::size_t>(row.repetitions->value()),
                                    row.feedback->isChecked(), row.diagram->isChecked()};
    };
    protocol.practice = phase(m_practice);
    protocol.test = phase(m_test);
    protocol.rest = {static_cast<std::size_t>(m_restEvery->value()), m_rest_s.value()};
    protocol.noiseColour = m_noise->currentIndex() == 0 ? "pink" : "none";
    protocol.noise_dBA = m_level_dBA.value();
    for (const QuestionnaireEditor* editor : m_questionnaires)
        protocol.questionnaires.push_back(editor->questionnaire());
    for (const TaskRow& row : m_tasks) {
        TELETA_TRY(study::StudyTask task, taskOf(row));
        protocol.tasks.push_back(std::move(task));
    }
    TELETA_TRY(protocol.exclusions, m_exclusions->rules());
    return study::parseProtocol(study::protocolText(protocol), tr("this form").toStdString());
}

void ProtocolDialog::check() {
    const auto valid = protocol();
    m_level_dBA.box->setEnabled(m_noise->currentIndex() == 0);
    m_rest_s.box->setEnabled(m_restEvery->value() > 0);
    m_save->setEnabled(valid.has_value());
    for (const TaskRow& row : m_tasks) {
        if (row.choose != nullptr)
            row.choose->setEnabled(!placeForPattern(row).isEmpty());
    }
    const std::vector<std::string> missing =
        valid ? study::missingStimuli(*valid) : std::vector<std::string>();
    m_make->setEnabled(valid.has_value() && missing.empty());
    QPalette colours = palette();
    if (!missing.empty()) {
        m_verdict->setText(QStringLiteral("\u2717 ") +
                           tr("There is no tactile pattern for %1. Name a file for it, or use a task, letter "
                              "and condition whose pattern is built in. The protocol can be saved as it is.")
                               .arg(QString::fromStdString(missing.front())));
        colours.setColor(QPalette::WindowText, base::statusColours(palette()).lost);
    } else if (valid) {
        m_verdict->setText(QStringLiteral("\u2713 ") + tr("%n test trial(s) per participant", nullptr,
                                                          static_cast<int>(valid->testTrials())));
        colours.setColor(QPalette::WindowText, base::statusColours(palette()).live);
    } else {
        const core::Error& error = valid.error();
        const QString expected = QString::fromStdString(error.expected);
        m_verdict->setText(QStringLiteral("\u2717 ") + QString::fromStdString(error.message) +
                           (expected.isEmpty() ? QString() : tr(" (expected: %1)").arg(expected)));
        colours.setColor(QPalette::WindowText, base::statusColours(palette()).lost);
    }
    m_verdict->setPalette(colours);
}

QVariantList ProtocolDialog::fields() const {
    QVariantList values;
    const QList<QWidget*> widgets = m_content->findChildren<QWidget*>();
    for (const QWidget* field : widgets) {
        if (const auto* line = qobject_cast<const QLineEdit*>(field)) {
            // Numbers are formatted by language.
            if (qobject_cast<const QAbstractSpinBox*>(line->parent()) == nullptr)
                values << line->text();
        } else if (const auto* text = qobject_cast<const QPlainTextEdit*>(field)) {
            values << text->toPlainText();
        } else if (const auto* whole = qobject_cast<const QSpinBox*>(field)) {
            values << whole->value();
        } else if (const auto* number = qobject_cast<const QDoubleSpinBox*>(field)) {
            values << number->value();
        } else if (const auto* choice = qobject_cast<const QComboBox*>(field)) {
            values << choice->currentIndex();
        } else if (const auto* box = qobject_cast<const QCheckBox*>(field)) {
            values << box->isChecked();
        }
    }
    return values;
}

bool ProtocolDialog::isChanged() const {
    return fields() != m_saved;
}

void ProtocolDialog::reject() {
    whenSettled([this] { QDialog::reject(); });
}

void ProtocolDialog::leaveTo(const study::Protocol& protocol) {
    const auto said = this->protocol();
    if (m_isStudyWanted && said && study::protocolText(*said) == study::protocolText(protocol))
        done(QDialog::Accepted);
}

void ProtocolDialog::whenSettled(std::function<void()> goOn) {
    if (!isChanged()) {
        goOn();
        return;
    }
    m_goOn = std::move(goOn);
    if (m_question)
        m_question->raise();
    else
        ask();
}

void ProtocolDialog::ask() {
    auto* box = base::named<QMessageBox>("unsavedProtocol", QMessageBox::Question, tr("Unsaved changes"),
                                         tr("The protocol has changes that are not saved."),
                                         QMessageBox::Discard | QMessageBox::Cancel, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* saveFirst = box->addButton(tr("Sa&ve as\u2026"), QMessageBox::AcceptRole);
    saveFirst->setEnabled(m_save->isEnabled()); // only what can be read again is written
    box->setDefaultButton(QMessageBox::Cancel);
    connect(box, &QMessageBox::finished, this, [this, box, saveFirst] {
        const auto goOn = std::exchange(m_goOn, nullptr);
        m_question = nullptr;
        if (box->clickedButton() == saveFirst)
            save(goOn);
        else if (box->clickedButton() == box->button(QMessageBox::Discard))
            goOn();
    });
    m_question = box;
    box->open();
}

void ProtocolDialog::save(std::function<void()> goOn) {
    const auto valid = protocol();
    if (!valid)
        return;
    const auto write = [this, protocol = *valid, entered = fields(),
                        goOn = std::move(goOn)](const QString& path) {
        base::runInBackground(
            this,
            [path, text = study::protocolText(asSavedIn(QFileInfo(path).absoluteDir(), protocol))] {
                return core::writeFile(path.toStdString(), text);
            },
            [this, path, entered, goOn](const core::Expected<void>& saved) {
                m_verdict->setText(saved ? tr("\u2713 Saved: %1").arg(path)
                                         : QStringLiteral("\u2717 ") +
                                               QString::fromStdString(core::describe(saved.error())));
                if (!saved)
                    return;
                m_saved = entered;
                if (goOn && !isChanged())
                    goOn();
            });
    };
    base::askToSave(this,
                    {.title = tr("Save the protocol"),
                     .filters = {tr("Protocols (*.toml)")},
                     .suffix = QStringLiteral("toml")},
                    write);
}

} // namespace teleta::console
