// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/patterns/patterns_page.h"

#include "app/console/patterns/export_dialog.h"
#include "app/console/patterns/import_dialog.h"
#include "backend/pattern/files/pattern_file.h"
#include "backend/pattern/files/pattern_format.h"
#include "backend/pattern/model/built_in_patterns.h"
#include "widgets/base/background.h"
#include "widgets/base/compose.h"
#include "widgets/base/file_dialog.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/bracelet/bracelet_view.h"
#include "widgets/bracelet/strength_panel.h"
#include "widgets/pattern/document/pattern_document.h"
#include "widgets/pattern/document/pattern_names.h"
#include "widgets/pattern/pattern_editor.h"
#include "widgets/pattern/pattern_library.h"
#include "widgets/pattern/timeline/timeline_view.h"

#include <QApplication>
#include <QDateTime>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

namespace teleta::console {

using pattern::Pattern;

namespace {

QString fileName(const QString& path) {
    return QFileInfo(path).fileName();
}

bool isOwnFormat(const QString& path) {
    return pattern::formatOf(path.toStdString()) == pattern::PatternFormat::own;
}

bool isReadable(const QString& path) {
    const auto format = pattern::formatOf(path.toStdString());
    return format && pattern::isReadable(*format);
}

/// The first pattern file of a drag.
QString patternIn(const QMimeData& data) {
    for (const QUrl& url : data.urls())
        if (url.isLocalFile() && isReadable(url.toLocalFile()))
            return url.toLocalFile();
    return {};
}

} // namespace

PatternsPage::PatternsPage(BraceletService& station, PatternCollection& collection,
                           const QString& recoveryFolder, QWidget* parent)
    : QWidget(parent)
    , m_station(station)
    , m_collection(collection)
    , m_keeper(new RecoveryKeeper(recoveryFolder, this))
    , m_messages(new chrome::MessageBar(this))
    , m_recovery(new QWidget(this))
    , m_recoveryText(new QLabel(m_recovery))
    , m_recover(base::named<QPushButton>("recover", m_recovery))
    , m_discard(base::named<QPushButton>("discardRecovered", m_recovery))
    , m_editor(new pattern::PatternEditor(this))
    , m_playback(new PatternPlayback(station, *m_editor, this))
    , m_picture(new bracelet::BraceletView)
    , m_strength(new bracelet::StrengthPanel) {
    setAcceptDrops(true);
    m_writing.setMaxThreadCount(1);
    auto* bracelet = new QWidget;
    auto* braceletLayout = new QVBoxLayout(bracelet);
    braceletLayout->setContentsMargins(0, 0, 0, 0);
    braceletLayout->setSpacing(0);
    braceletLayout->addWidget(m_picture, 1);
    braceletLayout->addWidget(m_strength);
    m_editor->setBraceletPicture(bracelet);
    m_recoveryText->setWordWrap(true);
    m_recovery->setAutoFillBackground(true);
    m_recovery->setBackgroundRole(QPalette::ToolTipBase);
    auto* offer = new QHBoxLayout(m_recovery);
    offer->setContentsMargins(base::grid(this), base::grid(this, 0.5), base::grid(this),
                              base::grid(this, 0.5));
    offer->addWidget(m_recoveryText, 1);
    for (QPushButton* button : {m_recover, m_discard}) {
        button->setAutoDefault(false);
        offer->addWidget(button);
    }
    m_recovery->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_messages);
    layout->addWidget(m_recovery);
    layout->addWidget(m_editor, 1);

    connectEditor();
    connectCollection();
    connectStrength();
    connect(m_recover, &QPushButton::clicked, this, &PatternsPage::recover);
    connect(m_discard, &QPushButton::clicked, this, &PatternsPage::discardRecovered);
    connect(m_keeper, &RecoveryKeeper::found, this, [this] {
        showRecovery();
        emit recoveryOffered(m_recoveryText->text());
    });
    connect(m_keeper, &RecoveryKeeper::failed, this, [this](const core::Error& error) {
        report(tr("Unsaved edits could not be backed up: a crash would lose them."), error);
    });
    connect(m_picture, &bracelet::BraceletView::held, &m_station, &BraceletService::hold);
    showPattern(pattern::builtInPatterns().front(), {});
    showOwn();
    base::onChange(this, &PatternsPage::showRecovery, {QEvent::LanguageChange});
    m_keeper->look();
}

void PatternsPage::connectEditor() {
    using pattern::PatternEditor;
    connect(m_editor, &PatternEditor::newRequested, this, [this] { whenSettled([this] { openNew(); }); });
    connect(m_editor, &PatternEditor::openRequested, this, [this](const QString& idOrPath) {
        if (idOrPath.isEmpty())
            askForFile(false);
        else
            open(idOrPath);
    });
    connect(m_editor, &PatternEditor::saveRequested, this, &PatternsPage::save);
    connect(m_editor, &PatternEditor::saveAsRequested, this, [this] { askForFile(true); });
    connect(m_editor, &PatternEditor::exportRequested, this, &PatternsPage::askForExport);
    connect(m_editor, &PatternEditor::compareRequested, this, &PatternsPage::compareWith);
    connect(m_editor, &PatternEditor::duplicateRequested, this, [this](const QString& idOrPath) {
        load(idOrPath, {}, [this, idOrPath](const Import& import) {
            m_collection.duplicate(import->pattern,
                                   tr("%1 (copy)").arg(pattern::displayName(import->pattern)));
            informOfLosses(idOrPath, import->losses);
        });
    });
    pattern::PatternDocument* document = m_editor->document();
    connect(document, &pattern::PatternDocument::refused, this, [this](const QString& message) {
        m_messages->post({chrome::Message::Severity::warning, message, {}, {}});
    });
    connect(document, &pattern::PatternDocument::told, this, &PatternsPage::inform);
    connect(document, &pattern::PatternDocument::autosaveDue, this, [this](const Pattern& pattern) {
        m_keeper->keep(
            {pattern, m_editor->document()->path().toStdString(), QDateTime::currentMSecsSinceEpoch()});
    });
    connect(document, &pattern::PatternDocument::dirtyChanged, this, [this](bool dirty) {
        if (!dirty)
            m_keeper->forget();
    });
    connect(&m_station, &BraceletService::calibrationChanged, this,
            [this](const motors::MotorCalibration& calibration) {
                m_editor->document()->setMotors(calibration.profiles());
            });
}

void PatternsPage::connectStrength() {
    const auto show = [this] {
        m_strength->setStrongest(m_station.strongest());
        m_strength->setEnabled(m_station.session() != nullptr);
    };
    connect(m_strength, &bracelet::StrengthPanel::strongestChanged, &m_station,
            &BraceletService::setStrongest);
    connect(&m_station, &BraceletService::strongestChanged, this, show);
    connect(&m_station, &BraceletService::sessionChanged, this, show);
    connect(&m_station, &BraceletService::strongestFailed, this, [this](const core::Error& error) {
        report(
            tr("The strength limit of the bracelet could not be read or saved: check the slider Strongest."),
            error);
    });
    show();
}

void PatternsPage::connectCollection() {
    pattern::PatternLibrary* library = m_editor->library();
    connect(library, &pattern::PatternLibrary::renameRequested, &m_collection, &PatternCollection::rename);
    connect(library, &pattern::PatternLibrary::deleteRequested, &m_collection, &PatternCollection::remove);
    connect(library, &pattern::PatternLibrary::undoRequested, &m_collection, &PatternCollection::undo);
    connect(&m_collection, &PatternCollection::changed, this, &PatternsPage::showOwn);
    connect(&m_collection, &PatternCollection::doneChanged, this,
            [this] { m_editor->library()->setNotice(m_collection.lastDone(), m_collection.canUndo()); });
    connect(&m_collection, &PatternCollection::failed, this, [this](const QString& what, const auto& error) {
        m_afterSaving = nullptr;
        m_saveAgain = false;
        disconnect(m_adding);
        m_adding = {};
        report(what, error);
    });
    connect(&m_collection, &PatternCollection::removed, this, [this](const QString& path) {
        // The open pattern remains; its file is gone.
        if (path == m_editor->document()->path())
            showPattern(m_editor->document()->pattern(), {}, true);
    });
}

void PatternsPage::showOwn() {
    std::vector<pattern::OwnPattern> own;
    for (const pattern::StoredPattern& stored : m_collection.patterns()) {
        pattern::OwnPattern item;
        item.path = QString::fromStdString(stored.path);
        item.name = fileName(item.path);
        item.renamable = isOwnFormat(item.path);
        if (stored.error)
            item.problem = QString::fromStdString(core::describe(*stored.error));
        item.pattern = stored.pattern;
        if (stored.pattern) {
            if (!stored.pattern->name.empty())
                item.name = QString::fromStdString(stored.pattern->name);
            item.duration_s = stored.pattern->duration_s;
            item.notes = QString::fromStdString(stored.pattern->notes);
            for (const std::string& tag : stored.pattern->tags)
                item.tags << QString::fromStdString(tag);
        }
        own.push_back(std::move(item));
    }
    m_editor->library()->setOwn(std::move(own));
}

void PatternsPage::showPattern(Pattern pattern, const QString& path, bool unsaved) {
    ++m_shown;
    ++m_asked;
    m_saveAgain = false;
    m_afterSaving = nullptr;
    m_playback->stop();
    m_editor->document()->setPattern(std::move(pattern), path, unsaved);
    if (unsaved)
        m_keeper->keep(
            {m_editor->document()->pattern(), path.toStdString(), QDateTime::currentMSecsSinceEpoch()});
    else
        m_keeper->forget();
}

void PatternsPage::load(const QString& idOrPath, const pattern::ImportOptions& options,
                        std::function<void(const Import&)> use) {
    if (const Pattern* builtIn = pattern::findBuiltIn(idOrPath.toStdString())) {
        use(std::make_shared<const pattern::PatternImport>(
            pattern::PatternImport{*builtIn, {}, false, false}));
        return;
    }
    base::runInBackground(
        this,
        [idOrPath, options, own = m_collection.atPath(idOrPath)]() -> core::Expected<Import> {
            TELETA_TRY(pattern::PatternImport import,
                       pattern::importPattern(idOrPath.toStdString(), options));
            if (own)
                import.pattern.id = own->id; // unique among the own patterns
            return std::make_shared<const pattern::PatternImport>(std::move(import));
        },
        [this, idOrPath, use = std::move(use)](core::Expected<Import> import) {
            if (import)
                use(*import);
            else
                report(tr("%1 could not be opened.", "a file").arg(fileName(idOrPath)), import.error());
        });
}

void PatternsPage::askToImport(const QString& path, const Import& import,
                               std::function<void(const Import&)> use) {
    auto* dialog = new ImportDialog(fileName(path), *import, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, path, import, dialog, use = std::move(use)] {
        if (dialog->isChanged())
            load(path, dialog->options(), use);
        else
            use(import);
    });
    dialog->open();
}

void PatternsPage::informOfLosses(const QString& path, const std::vector<pattern::Loss>& losses) {
    QStringList all;
    for (const pattern::Loss& loss : losses)
        all << QString::fromStdString(describe(loss));
    if (!all.isEmpty())
        inform(tr("%1 holds more than the pattern: %2", "a file, a list of sentences")
                   .arg(fileName(path), all.join(QLatin1Char(' '))));
}

void PatternsPage::open(const QString& idOrPath) {
    // The current edits remain until the file has been read: reading may fail.
    settle([this, idOrPath] { openNow(idOrPath); },
           [this, idOrPath] { openNow(idOrPath, m_editor->document()->revision()); });
}

void PatternsPage::openNow(const QString& idOrPath, std::optional<quint64> discarded) {
    // Reading takes time: only the last request is shown, and not over edits made meanwhile.
    load(idOrPath, {}, [this, idOrPath, discarded, number = ++m_asked](const Import& import) {
        const auto show = [this, idOrPath, discarded, number](const Import& accepted) {
            if (number != m_asked)
                return;
            if (discarded == m_editor->document()->revision()) {
                showOpened(accepted->pattern, idOrPath);
                return;
            }
            whenSettled([this, idOrPath, number, accepted] {
                if (number == m_asked)
                    showOpened(accepted->pattern, idOrPath);
            });
        };
        if (number == m_asked && !import->losses.empty())
            askToImport(idOrPath, import, show);
        else
            show(import);
    });
}

void PatternsPage::showOpened(const Pattern& pattern, const QString& idOrPath) {
    if (pattern::findBuiltIn(idOrPath.toStdString()) != nullptr) {
        showPattern(pattern, {});
        return;
    }
    // Other formats cannot hold everything, so an edited pattern is not saved back to such a file.
    showPattern(pattern, isOwnFormat(idOrPath) ? idOrPath : QString());
    emit used(idOrPath);
}

void PatternsPage::openNew() {
    Pattern pattern;
    pattern.id = pattern::newPatternId();
    pattern.name = tr("New pattern").toStdString();
    pattern.duration_s = 2.0;
    showPattern(std::move(pattern), {});
}

void PatternsPage::save() {
    const QString path = m_editor->document()->path();
    if (!path.isEmpty()) {
        write(path);
    } else if (!m_collection.isPossible()) {
        askForFile(true);
    } else {
        // Saving again before the file is known would create a second one.
        m_saveAgain = static_cast<bool>(m_adding);
        if (m_saveAgain)
            return;
        Pattern pattern = m_editor->document()->pattern();
        if (pattern.name.empty())
            pattern.name = tr("New pattern").toStdString();
        m_adding = connect(
            &m_collection, &PatternCollection::added, this,
            [this, revision = m_editor->document()->revision(), shown = m_shown](const QString& added) {
                m_adding = {};
                if (shown == m_shown)
                    takeAdded(added, revision);
                emit used(added);
            },
            Qt::SingleShotConnection);
        m_collection.add(pattern);
    }
}

void PatternsPage::takeAdded(const QString& path, quint64 revision) {
    pattern::PatternDocument* document = m_editor->document();
    if (revision == document->revision())
        document->markSaved(path);
    else
        document->setPath(path);
    if (std::exchange(m_saveAgain, false) && hasUnsaved())
        write(path);
    else
        settled(true);
}

void PatternsPage::saveAs(const QString& path) {
    if (isOwnFormat(path)) {
        write(path);
        return;
    }
    exportTo(path);
    settled(false);
}

void PatternsPage::write(const QString& path) {
    base::runInBackground(
        m_writing, this,
        [path, pattern = std::make_shared<const Pattern>(m_editor->document()->pattern())] {
            return pattern::savePattern(*pattern, path.toStdString());
        },
        [this, path, revision = m_editor->document()->revision()](core::Expected<void> saved) {
            if (!saved)
                report(tr("%1 could not be saved.", "a file").arg(fileName(path)), saved.error());
            else if (revision == m_editor->document()->revision())
                m_editor->document()->markSaved(path);
            settled(saved.has_value());
            if (saved)
                emit used(path);
        });
}

void PatternsPage::exportTo(const QString& path, const pattern::SampleOptions& samples) {
    inform(tr("Exporting %1\u2026", "a file").arg(fileName(path)));
    base::runInBackground(
        this,
        [path, samples, pattern = std::make_shared<const Pattern>(m_editor->document()->pattern())]()
            -> core::Expected<std::vector<pattern::Loss>> {
            TELETA_CHECK(pattern::savePattern(*pattern, path.toStdString(), samples));
            return pattern::exportLosses(*pattern, *pattern::formatOf(path.toStdString()));
        },
        [this, path](const core::Expected<std::vector<pattern::Loss>>& losses) {
            if (!losses) {
                report(tr("%1 could not be exported.", "a file").arg(fileName(path)), losses.error());
                return;
            }
            QStringList all{tr("%1 was exported.", "a file").arg(fileName(path))};
            for (const pattern::Loss& loss : *losses)
                all << QString::fromStdString(describe(loss));
            inform(all.join(QLatin1Char(' ')));
        });
}

void PatternsPage::compareWith(const QString& idOrPath) {
    load(idOrPath, {}, [this, idOrPath](const Import& import) {
        m_editor->compareWith(std::make_shared<const Pattern>(import->pattern));
        informOfLosses(idOrPath, import->losses);
    });
}

bool PatternsPage::hasUnsaved() const {
    return m_editor->document()->isDirty();
}

void PatternsPage::whenSettled(std::function<void()> goOn) {
    settle(goOn, [this, goOn] {
        m_keeper->forget();
        m_editor->document()->markSaved(m_editor->document()->path());
        goOn();
    });
}

void PatternsPage::settle(std::function<void()> goOn, std::function<void()> discard) {
    if (!hasUnsaved()) {
        goOn();
        return;
    }
    const QString name = QString::fromStdString(m_editor->document()->pattern().name);
    auto* ask = new QMessageBox(QMessageBox::Question, tr("Unsaved edits"),
                                tr("%1 has unsaved edits.", "a pattern").arg(name),
                                QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
    ask->setAttribute(Qt::WA_DeleteOnClose);
    ask->setDefaultButton(QMessageBox::Save);
    connect(ask, &QMessageBox::finished, this,
            [this, goOn = std::move(goOn), discard = std::move(discard)](int answer) {
                if (answer == QMessageBox::Discard) {
                    discard();
                } else if (answer == QMessageBox::Save) {
                    m_afterSaving = goOn;
                    save();
                }
            });
    ask->open();
}

void PatternsPage::settled(bool saved) {
    const std::function<void()> goOn = std::exchange(m_afterSaving, nullptr);
    if (goOn && saved && !hasUnsaved())
        goOn();
}

void PatternsPage::showRecovery() {
    m_recovery->setVisible(!m_keeper->lost().empty());
    if (m_keeper->lost().empty())
        return;
    const pattern::RecoveredPattern& lost = m_keeper->lost().front().recovered;
    const QString when =
        QLocale().toString(QDateTime::fromMSecsSinceEpoch(lost.edited_ms), QLocale::ShortFormat);
    QString text = tr("The program ended before %1, edited %2, was saved. The file on disk is unchanged.",
                      "a pattern, a time")
                       .arg(pattern::displayName(lost.pattern), when);
    if (m_keeper->lost().size() > 1)
        text += QLatin1Char(' ') +
                tr("There are %n more.", nullptr, static_cast<int>(m_keeper->lost().size()) - 1);
    m_recoveryText->setText(text);
    m_recover->setText(tr("Open the edits"));
    m_discard->setText(tr("Discard them"));
}

void PatternsPage::recover() {
    if (m_keeper->lost().empty())
        return;
    whenSettled([this] {
        const LostEdits lost = m_keeper->take();
        showPattern(lost.recovered.pattern, QString::fromStdString(lost.recovered.path), true);
        m_keeper->discard(lost); // after showPattern(), so that the edits are backed up again before the old
                                 // file is removed
        showRecovery();
    });
}

void PatternsPage::discardRecovered() {
    if (m_keeper->lost().empty())
        return;
    m_keeper->discard(m_keeper->take());
    showRecovery();
}

void PatternsPage::askForFile(bool save) {
    if (!save) {
        base::askToOpen(
            this,
            {.title = tr("Open pattern"),
             .filters = {tr("All patterns (*.json *.hjif *.haptic *.haptic.zip *.ahap *.ahap.zip *.tact)"),
                         tr("Patterns (*.json)"), tr("HJIF (*.hjif)"),
                         tr("Haptic clips (*.haptic *.haptic.zip)"), tr("AHAP (*.ahap *.ahap.zip)"),
                         tr("tact (*.tact)")}},
            [this](const QString& path) { open(path); });
        return;
    }
    const QFileDialog* dialog = base::askToSave(
        this,
        {.title = tr("Save pattern"), .filters = {tr("Patterns (*.json)")}, .suffix = QStringLiteral("json")},
        [this](const QString& path) { saveAs(path); });
    // Cancelling the save also cancels what was to follow it.
    connect(dialog, &QDialog::rejected, this, [this] { m_afterSaving = nullptr; });
}

void PatternsPage::askForExport() {
    const pattern::PatternDocument& document = *m_editor->document();
    const QString name =
        document.path().isEmpty()
            ? pattern::displayName(document.pattern()).replace(QLatin1Char('/'), QLatin1Char('-'))
            : QString::fromStdString(pattern::baseName(document.path().toStdString()));
    auto* dialog = new ExportDialog(document.motors(), name, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ExportDialog::chosen, this, &PatternsPage::exportTo);
    dialog->open();
}

void PatternsPage::report(const QString& what, const core::Error& error) {
    m_messages->post(
        {chrome::Message::Severity::error, what, QString::fromStdString(core::describe(error)), QString()});
}

void PatternsPage::inform(const QString& what) {
    m_messages->post({chrome::Message::Severity::information, what, {}, {}});
}

void PatternsPage::tick() {
    m_playback->tick();
    m_picture->setIntensities(m_playback->intensities());
    m_picture->setNote(m_playback->note());
    m_picture->setAlarming(m_station.isStopped());
    m_picture->setPreview(!m_station.isDriven());
    m_editor->setStopped(m_station.isStopped());
    m_picture->setHoldable(m_station.isFree());
    m_picture->setTitle(pattern::displayName(m_editor->document()->pattern()));
    m_picture->setProvenance(m_station.isSimulated() ? base::Provenance::simulated : base::Provenance::live);
}

void PatternsPage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (event->spontaneous())
        return;
    // Whoever comes to the page and presses Space wants to hear the pattern, not to filter the library, the
    // first field. Queued: the pages give the focus away after this.
    QMetaObject::invokeMethod(
        this,
        [this] {
            const QWidget* focus = QApplication::focusWidget();
            if (isVisible() && focus != nullptr && m_editor->library()->isAncestorOf(focus))
                m_editor->timeline()->setFocus(Qt::OtherFocusReason);
        },
        Qt::QueuedConnection);
}

void PatternsPage::dragEnterEvent(QDragEnterEvent* event) {
    if (patternIn(*event->mimeData()).isEmpty())
        event->ignore();
    else
        event->acceptProposedAction();
}

void PatternsPage::dropEvent(QDropEvent* event) {
    const QString path = patternIn(*event->mimeData());
    if (path.isEmpty()) {
        event->ignore();
        return;
    }
    event->acceptProposedAction();
    open(path);
}

} // namespace teleta::console
